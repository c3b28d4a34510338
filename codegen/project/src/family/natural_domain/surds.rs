//! Surds: sums of two terms with square roots or magnitudes, whose sign squares decide.
//!
//! With terms s and t of known squares: s + t vanishes where s^2 = t^2, unless both have one sign and are not zero; and
//! s + t >= 0 where s >= 0 and s^2 >= t^2, or t >= 0 and t^2 >= s^2.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator};

use crate::construct::{binary, compared, integer, joined, negative, product, squared};

/// Comparisons that hold together.
pub(super) type Clause = Vec<Expr>;

/// When a sum of two such terms compares so with zero.
pub(super) enum Decision {
    /// Wherever it has a value.
    Always,
    /// Where one of these holds.
    Where(Vec<Clause>),
}

/// When the expression is not zero, not negative or positive, if it is such a sum.
pub(super) fn decide(expr: &Expr, relation: Relation) -> Option<Decision> {
    let [s, t] = <[Term; 2]>::try_from(terms(expr)?).ok()?;
    let both_positive = s.sign() == Some(true) && t.sign() == Some(true);
    if both_positive && (relation == Relation::GreaterOrEqual || s.is_number() || t.is_number()) {
        return Some(Decision::Always);
    }
    let clauses = match relation {
        Relation::NotEqual => apart(&s, &t),
        Relation::GreaterOrEqual => larger(&s, &t, relation),
        Relation::Greater => larger(&s, &t, relation).into_iter().chain(positive(&s, &t)).collect(),
        _ => Vec::new(),
    };
    (!clauses.is_empty()).then_some(Decision::Where(clauses))
}

/// That the squares differ, or both terms have one sign and are not zero.
fn apart(s: &Term, t: &Term) -> Vec<Clause> {
    let squares = with_zero(Relation::NotEqual, difference(s, t));
    let same_sign = match (s.sign(), t.sign()) {
        (Some(a), Some(b)) if a != b => None,
        (Some(_), Some(_)) => Some(s.square()),
        _ => {
            let factors = [s.magnitude(), t.magnitude(), s.square()].into_iter().filter(|factor| !is_one(factor));
            signed(s.negative != t.negative, factors.collect())
        }
    };
    let same_sign = same_sign.map(|value| vec![with_zero(Relation::Greater, value)]);
    [Some(vec![squares]), same_sign].into_iter().flatten().collect()
}

/// That the term which is not negative has the larger square.
fn larger(s: &Term, t: &Term, relation: Relation) -> Vec<Clause> {
    let clause = |one: &Term, other: &Term| {
        let squares = with_zero(relation, difference(one, other));
        match one.sign() {
            Some(true) => Some(vec![squares]),
            Some(false) => None,
            None => Some(vec![with_zero(Relation::GreaterOrEqual, one.coefficient()), squares]),
        }
    };
    [clause(s, t), clause(t, s)].into_iter().flatten().collect()
}

/// That both terms are positive.
fn positive(s: &Term, t: &Term) -> Option<Clause> {
    let is_positive = |term: &Term| match term.sign() {
        Some(true) => Some(vec![with_zero(Relation::Greater, term.square())]),
        Some(false) => None,
        None if term.radicand.is_none() => Some(vec![with_zero(Relation::Greater, term.coefficient())]),
        None => {
            Some(vec![with_zero(Relation::Greater, term.coefficient()), with_zero(Relation::Greater, term.square())])
        }
    };
    Some([is_positive(s)?, is_positive(t)?].concat())
}

fn with_zero(relation: Relation, function: Expr) -> Expr {
    compared(relation, function, integer(0))
}

/// The difference of the squares of two terms.
fn difference(s: &Term, t: &Term) -> Expr {
    binary(BinaryOperator::Subtract, s.square(), t.square())
}

/// The product of factors, the first of them with the sign.
fn signed(is_negative: bool, mut factors: Vec<Expr>) -> Option<Expr> {
    if is_negative && let Some(first) = factors.first_mut() {
        *first = negative(first.clone());
    }
    product(factors)
}

fn is_one(expr: &Expr) -> bool {
    *expr == integer(1)
}

/// A rational function, times the root of another one.
struct Term {
    negative: bool,
    /// Its factors; those below the bar are divided by.
    factors: Vec<(Expr, bool)>,
    radicand: Option<Expr>,
}

/// The terms of a sum, the rational ones added up to one; `None` where roots occur otherwise.
fn terms(expr: &Expr) -> Option<Vec<Term>> {
    let mut found = Vec::new();
    split(expr, false, &mut found)?;
    let (rational, mut terms): (Vec<Term>, Vec<Term>) = found.into_iter().partition(|term| term.radicand.is_none());
    match rational.len() {
        0 | 1 => terms.extend(rational),
        _ => {
            let sum = joined(BinaryOperator::Add, rational.iter().map(Term::coefficient))?;
            terms.push(Term { negative: false, factors: vec![(sum, false)], radicand: None });
        }
    }
    Some(terms)
}

fn split(expr: &Expr, negative: bool, found: &mut Vec<Term>) -> Option<()> {
    match &expr.kind {
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => split(operand, !negative, found),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => split(operand, negative, found),
        ExprKind::Binary { operator: BinaryOperator::Add, left, right } => {
            split(left, negative, found)?;
            split(right, negative, found)
        }
        ExprKind::Binary { operator: BinaryOperator::Subtract, left, right } => {
            split(left, negative, found)?;
            split(right, !negative, found)
        }
        // a sum over a constant has its terms
        ExprKind::Binary { operator: BinaryOperator::Divide, left, right } if is_sum(left) && is_number(right) => {
            split(left, negative, found)
        }
        _ => {
            let mut term = Term { negative, factors: Vec::new(), radicand: None };
            term.take(expr, false)?;
            found.push(term);
            Some(())
        }
    }
}

fn is_sum(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Binary { operator: BinaryOperator::Add | BinaryOperator::Subtract, .. })
}

fn is_number(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Integer(_) | ExprKind::Float(_))
}

impl Term {
    /// Multiplies by an expression, or divides by it; `None` where that takes more than one root.
    fn take(&mut self, expr: &Expr, below: bool) -> Option<()> {
        match &expr.kind {
            ExprKind::Unary { operator: UnaryOperator::Minus, operand } => {
                self.negative = !self.negative;
                self.take(operand, below)
            }
            ExprKind::Binary { operator: BinaryOperator::Multiply, left, right } => {
                self.take(left, below)?;
                self.take(right, below)
            }
            ExprKind::Binary { operator: BinaryOperator::Divide, left, right } => {
                self.take(left, below)?;
                self.take(right, !below)
            }
            ExprKind::Call { .. } => match (expr.as_call(), &self.radicand) {
                (Some(("sqrt", [radicand])), None) if !has_root(radicand) => {
                    self.radicand = Some(radicand.clone());
                    // sqrt(r) is r/sqrt(r) upside down
                    if below {
                        self.factors.push((radicand.clone(), true));
                    }
                    Some(())
                }
                (Some(("abs", [inner])), None) if !has_root(inner) => {
                    self.radicand = Some(squared(inner.clone()));
                    if below {
                        self.factors.extend([(inner.clone(), true), (inner.clone(), true)]);
                    }
                    Some(())
                }
                _ => None,
            },
            _ if has_root(expr) => None,
            _ => {
                if !is_one(expr) {
                    self.factors.push((expr.clone(), below));
                }
                Some(())
            }
        }
    }

    /// The sign of a term with a coefficient that is a number.
    fn sign(&self) -> Option<bool> {
        self.factors.iter().all(|(factor, _)| is_number(factor)).then_some(!self.negative)
    }

    /// The term without its root.
    fn coefficient(&self) -> Expr {
        self.quotient(self.negative)
    }

    /// The term without its root and its sign.
    fn magnitude(&self) -> Expr {
        self.quotient(false)
    }

    fn quotient(&self, is_negative: bool) -> Expr {
        let side = |below: bool| self.factors.iter().filter(move |(_, is_below)| *is_below == below);
        let above: Vec<Expr> = side(false).map(|(factor, _)| factor.clone()).collect();
        let above = if above.is_empty() { vec![integer(1)] } else { above };
        let below = product(side(true).map(|(factor, _)| factor.clone()));
        let above = signed(is_negative, above).unwrap_or_else(|| integer(1));
        below.map_or(above.clone(), |below| binary(BinaryOperator::Divide, above, below))
    }

    fn is_number(&self) -> bool {
        self.radicand.is_none() && self.sign().is_some()
    }

    fn square(&self) -> Expr {
        let of_factors = (!self.factors.is_empty()).then(|| squared(self.magnitude()));
        product(of_factors.into_iter().chain(self.radicand.clone())).unwrap_or_else(|| integer(1))
    }
}

/// Whether anything in the expression is no rational function.
pub(super) fn has_root(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::Symbol(_) => false,
        ExprKind::Unary { operand, .. } => has_root(operand),
        ExprKind::Binary { operator: BinaryOperator::Power, left, right } => {
            has_root(left) || !matches!(&right.kind, ExprKind::Integer(_))
        }
        ExprKind::Binary { left, right, .. } => has_root(left) || has_root(right),
        _ => true,
    }
}
