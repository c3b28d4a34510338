//! Surds: sums of two terms with square roots or magnitudes, whose sign squares decide.
//!
//! With terms s and t of known squares: s + t vanishes where s^2 = t^2, unless both have one sign and are not zero; and
//! s + t >= 0 where s >= 0 and s^2 >= t^2, or t >= 0 and t^2 >= s^2.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator, parse_expression, print};

/// When a sum of two such terms compares so with zero.
pub(super) enum Decision {
    /// Wherever it has a value.
    Always,
    /// Where this Maxima condition holds.
    Where(String),
}

/// When the expression is not zero (`#`), not negative (`>=`) or positive (`>`), if it is such a sum.
pub(super) fn decide(expr: &Expr, operator: &str) -> Option<Decision> {
    let [s, t] = <[Term; 2]>::try_from(terms(expr)?).ok()?;
    let both_positive = s.sign() == Some(true) && t.sign() == Some(true);
    if both_positive && (operator == ">=" || s.is_number() || t.is_number()) {
        return Some(Decision::Always);
    }
    let s2 = s.square();
    let apart = compared(&format!("{s2}-{}", t.square()), "#");
    let text = match operator {
        "#" => match (s.sign(), t.sign()) {
            (Some(a), Some(b)) if a != b => apart,
            (Some(_), Some(_)) => format!("{apart} or {}", compared(&s2, ">")),
            _ => {
                format!("{apart} or {}", compared(&product([&s.coefficient(), &t.coefficient(), &s2]), ">"))
            }
        },
        ">=" => larger(&s, &t, operator)?,
        ">" => {
            let clauses = [larger(&s, &t, operator), positive(&s, &t)];
            clauses.into_iter().flatten().reduce(|a, b| format!("{a} or {b}"))?
        }
        _ => return None,
    };
    Some(Decision::Where(text))
}

/// That the term which is not negative has the larger square.
fn larger(s: &Term, t: &Term, operator: &str) -> Option<String> {
    let clause = |one: &Term, other: &Term| {
        let squares = compared(&format!("{}-{}", one.square(), other.square()), operator);
        match one.sign() {
            Some(true) => Some(squares),
            Some(false) => None,
            None => Some(format!("{} and {squares}", compared(&one.coefficient(), ">="))),
        }
    };
    [clause(s, t), clause(t, s)].into_iter().flatten().reduce(|a, b| format!("{a} or {b}"))
}

/// That both terms are positive.
fn positive(s: &Term, t: &Term) -> Option<String> {
    let is_positive = |term: &Term| match term.sign() {
        Some(true) => Some(compared(&term.square(), ">")),
        Some(false) => None,
        None if term.radicand.is_none() => Some(compared(&term.coefficient(), ">")),
        None => Some(format!("{} and {}", compared(&term.coefficient(), ">"), compared(&term.square(), ">"))),
    };
    Some(format!("{} and {}", is_positive(s)?, is_positive(t)?))
}

/// The comparison of a rational function with zero, in as few parentheses as it needs.
fn compared(function: &str, operator: &str) -> String {
    let text = parse_expression(function).map_or_else(|_| function.to_owned(), |function| print(&function));
    format!("{text} {operator} 0")
}

/// The product of coefficients and squares, what is one left out.
fn product(factors: [&str; 3]) -> String {
    let negative = factors.iter().filter(|factor| factor.starts_with('-')).count() % 2 == 1;
    let factors = factors.into_iter().map(|factor| factor.trim_start_matches('-')).filter(|factor| *factor != "1");
    let product = factors.map(|factor| format!("({factor})")).collect::<Vec<_>>().join("*");
    if negative { format!("-{product}") } else { product }
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
            let text = rational
                .iter()
                .map(|term| format!("({})", term.coefficient()))
                .reduce(|sum, term| format!("{sum}+{term}"));
            let sum = parse_expression(&text?).ok()?;
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
                    self.radicand = Some(parse_expression(&format!("({})^2", print(inner))).ok()?);
                    if below {
                        self.factors.extend([(inner.clone(), true), (inner.clone(), true)]);
                    }
                    Some(())
                }
                _ => None,
            },
            _ if has_root(expr) => None,
            _ => {
                if print(expr) != "1" {
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
    fn coefficient(&self) -> String {
        let above = self.product(false).unwrap_or_else(|| "1".to_owned());
        let below = self.product(true).map_or_else(String::new, |below| format!("/({below})"));
        format!("{}{above}{below}", if self.negative { "-" } else { "" })
    }

    fn product(&self, below: bool) -> Option<String> {
        let factors = self.factors.iter().filter(|(_, is_below)| *is_below == below);
        factors
            .map(|(factor, _)| format!("({})", print(factor)))
            .reduce(|product, factor| format!("{product}*{factor}"))
    }

    fn is_number(&self) -> bool {
        self.radicand.is_none() && self.sign().is_some()
    }

    fn square(&self) -> String {
        let squared = (!self.factors.is_empty()).then(|| format!("({})^2", self.coefficient().trim_start_matches('-')));
        let radicand = self.radicand.as_ref().map(|radicand| format!("({})", print(radicand)));
        [squared, radicand].into_iter().flatten().reduce(|a, b| format!("{a}*{b}")).unwrap_or_else(|| "1".to_owned())
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
