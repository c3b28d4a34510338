//! Formulas as they are written: the steps of a kernel in certified arithmetic, and the proof that its text has them.
//!
//! For such a kernel no stable form was found or proved: it keeps its bound at run time. Its proof is simple. Text and
//! reference make one graph of steps, in which equal steps are one node and every change of form is an identity.

use crate::field::Sign;
use crate::program::{Condition, Graph, Node};
use closedform_maxima::Definition;
use closedform_project::contract::KernelContract;
use closedform_project::domain::Condition as Contracted;
use closedform_project::expression::{Expr, LowerError, Test, lower};
use closedform_syntax::{BinaryOp, Condition as SourceCondition, Expr as Source, Kernel as SourceKernel, Relation};
use num_rational::BigRational;
use num_traits::{One, Zero};
use thiserror::Error;

/// Why a formula cannot be taken step by step.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WrittenError {
    /// It uses what the generator does not know.
    #[error(transparent)]
    Lower(#[from] LowerError),
    /// A name that is no input.
    #[error("it uses `{0}`, which is no input")]
    UnknownName(String),
    /// A root of something that is no polynomial in its unknown.
    #[error("it asks for the positive_root() of something that is no polynomial in its unknown")]
    NoPolynomial,
    /// A quotient by the number zero.
    #[error("it divides by zero")]
    DivisionByZero,
    /// A formula of very many steps, mostly.
    #[error("as it is written it is beyond the kernel language: {0}. Split it into functions of fewer steps")]
    BeyondTheLanguage(String),
    /// The text takes a step that no formula as written has.
    #[error("its text has steps of another precision")]
    Compensated,
}

/// Conditions and results as steps of one graph.
pub struct Written<'a> {
    /// The steps.
    pub graph: Graph,
    inputs: &'a [String],
}

/// The conditions of a domain and the results.
pub type Steps = (Vec<Condition>, Vec<Node>);

impl<'a> Written<'a> {
    /// No steps yet.
    #[must_use]
    pub fn new(inputs: &'a [String]) -> Self {
        let mut graph = Graph::default();
        // first, so that positions agree with those of the text
        for index in 0..inputs.len() {
            graph.input(index, Sign::ANY);
        }
        Self { graph, inputs }
    }

    /// The steps of a contract's conditions and references.
    ///
    /// # Errors
    /// See [`WrittenError`].
    pub fn reference(&mut self, contract: &KernelContract, references: &[Definition]) -> Result<Steps, WrittenError> {
        let conditions = contract.domain.conditions().map(|condition| self.condition(condition));
        let conditions = conditions.collect::<Result<_, _>>()?;
        let results = references.iter().map(|reference| self.expression(&lower(&reference.body)?));
        Ok((conditions, results.collect::<Result<_, _>>()?))
    }

    /// The steps of a Rust text.
    ///
    /// # Errors
    /// When it has others than a formula as written.
    pub fn text(&mut self, source: &SourceKernel) -> Result<Steps, WrittenError> {
        let mut slots: Vec<Node> = (0..self.inputs.len()).map(|index| self.graph.input(index, Sign::ANY)).collect();
        let requires = source.requires.iter().map(|require| self.text_condition(&require.condition, &slots));
        let conditions = requires.collect::<Result<_, _>>()?;
        for step in &source.lets {
            let node = self.text_value(&step.value, &slots)?;
            slots.push(node);
        }
        let results = source.output.values().map(|value| self.text_value(value, &slots));
        Ok((conditions, results.collect::<Result<_, _>>()?))
    }

    fn expression(&mut self, expr: &Expr) -> Result<Node, WrittenError> {
        match expr {
            Expr::Rational(value) => Ok(self.graph.constant(value)),
            Expr::Pi => Ok(self.graph.pi()),
            Expr::Symbol(name) => self.input(name),
            Expr::Sum(items) => self.sum(items),
            Expr::Product(items) => self.product(items),
            Expr::Power(base, exponent) => {
                let power = self.power(base, exponent.unsigned_abs())?;
                if *exponent < 0 { self.quotient(None, power) } else { Ok(power) }
            }
            Expr::Call(function, inner) => {
                let inner = self.expression(inner)?;
                Ok(self.graph.call(*function, inner))
            }
            Expr::Choice(test, values) => {
                let condition = self.test(test)?;
                let [then, otherwise] = &**values;
                let (then, otherwise) = (self.expression(then)?, self.expression(otherwise)?);
                Ok(self.graph.select(condition, then, otherwise))
            }
            Expr::Extreme { largest, items } => {
                let items = self.all(items)?;
                Ok(self.graph.extreme(*largest, items))
            }
            Expr::PositiveRoot { polynomial, unknown } => {
                let coefficients = coefficients(polynomial, unknown).ok_or(WrittenError::NoPolynomial)?;
                let coefficients = self.all(&coefficients)?;
                Ok(self.graph.positive_root(coefficients, f64::INFINITY))
            }
        }
    }

    fn test(&mut self, test: &Test) -> Result<Condition, WrittenError> {
        let mut part = |part: &Test| self.test(part).map(Box::new);
        match test {
            Test::Compare(relation, sides) => {
                let [left, right] = &**sides;
                Ok(Condition::Compare(self.expression(left)?, *relation, self.expression(right)?))
            }
            Test::And(parts) => Ok(Condition::And(part(&parts[0])?, part(&parts[1])?)),
            Test::Or(parts) => Ok(Condition::Or(part(&parts[0])?, part(&parts[1])?)),
            Test::Not(inner) => Ok(Condition::Not(part(inner)?)),
        }
    }

    fn all(&mut self, items: &[Expr]) -> Result<Vec<Node>, WrittenError> {
        items.iter().map(|item| self.expression(item)).collect()
    }

    fn input(&mut self, name: &str) -> Result<Node, WrittenError> {
        let index = self.inputs.iter().position(|input| input == name);
        let index = index.ok_or_else(|| WrittenError::UnknownName(name.to_owned()))?;
        Ok(self.graph.input(index, Sign::ANY))
    }

    fn sum(&mut self, items: &[Expr]) -> Result<Node, WrittenError> {
        let terms = self.all(items)?;
        let sum = terms.into_iter().reduce(|sum, term| self.graph.add(sum, term));
        Ok(sum.unwrap_or_else(|| self.graph.constant(&BigRational::zero())))
    }

    /// A product, what has negative powers below one bar.
    fn product(&mut self, items: &[Expr]) -> Result<Node, WrittenError> {
        let (mut above, mut below) = (None, None);
        for item in items {
            let (side, factor) = match item {
                Expr::Power(base, exponent) if *exponent < 0 => {
                    (&mut below, self.power(base, exponent.unsigned_abs())?)
                }
                _ => (&mut above, self.expression(item)?),
            };
            *side = Some(side.map_or(factor, |product| self.graph.mul(product, factor)));
        }
        match below {
            Some(below) => self.quotient(above, below),
            None => Ok(above.unwrap_or_else(|| self.graph.constant(&BigRational::one()))),
        }
    }

    fn quotient(&mut self, above: Option<Node>, below: Node) -> Result<Node, WrittenError> {
        if self.graph.literal(below).is_some_and(Zero::is_zero) {
            return Err(WrittenError::DivisionByZero);
        }
        let above = above.unwrap_or_else(|| self.graph.constant(&BigRational::one()));
        Ok(self.graph.div(above, below))
    }

    /// By squares, from the highest binary digit of the exponent.
    fn power(&mut self, base: &Expr, exponent: u32) -> Result<Node, WrittenError> {
        let base = self.expression(base)?;
        let Some(highest) = exponent.checked_ilog2() else { return Ok(self.graph.constant(&BigRational::one())) };
        Ok((0..highest).rev().fold(base, |power, digit| {
            let square = self.graph.mul(power, power);
            if exponent >> digit & 1 == 1 { self.graph.mul(square, base) } else { square }
        }))
    }

    fn condition(&mut self, condition: &Contracted) -> Result<Condition, WrittenError> {
        match condition {
            Contracted::Compare(comparison) => {
                let left = self.expression(&comparison.lhs)?;
                let right = self.expression(&comparison.rhs)?;
                Ok(Condition::Compare(left, comparison.relation, right))
            }
            Contracted::And(parts) => self.joined(parts, Condition::And),
            Contracted::Or(parts) => self.joined(parts, Condition::Or),
        }
    }

    fn joined(
        &mut self,
        parts: &[Contracted],
        join: fn(Box<Condition>, Box<Condition>) -> Condition,
    ) -> Result<Condition, WrittenError> {
        let parts: Vec<Condition> = parts.iter().map(|part| self.condition(part)).collect::<Result<_, _>>()?;
        let joined = parts.into_iter().reduce(|a, b| join(a.into(), b.into()));
        let zero = self.graph.constant(&BigRational::zero());
        Ok(joined.unwrap_or(Condition::Compare(zero, Relation::Equal, zero)))
    }

    fn text_value(&mut self, expr: &Source, slots: &[Node]) -> Result<Node, WrittenError> {
        match expr {
            Source::Literal { value, .. } => {
                let value = BigRational::from_float(*value).ok_or(WrittenError::Compensated)?;
                Ok(self.graph.constant(&value))
            }
            Source::Name(name) => Ok(slots[name.slot]),
            Source::Pi(_) => Ok(self.graph.pi()),
            Source::Neg(inner) => {
                let inner = self.text_value(inner, slots)?;
                Ok(self.graph.neg(inner))
            }
            Source::Call(function, inner) => {
                let inner = self.text_value(inner, slots)?;
                Ok(self.graph.call(*function, inner))
            }
            Source::Binary { op, left, right } => {
                let (left, right) = (self.text_value(left, slots)?, self.text_value(right, slots)?);
                match op {
                    BinaryOp::Add => Ok(self.graph.add(left, right)),
                    BinaryOp::Sub => Ok(self.graph.sub(left, right)),
                    BinaryOp::Mul => Ok(self.graph.mul(left, right)),
                    BinaryOp::Div => self.quotient(Some(left), right),
                }
            }
            Source::Extreme { largest, items } => {
                let items = self.text_values(items, slots)?;
                Ok(self.graph.extreme(*largest, items))
            }
            Source::PositiveRoot(coefficients) => {
                let coefficients = self.text_values(coefficients, slots)?;
                Ok(self.graph.positive_root(coefficients, f64::INFINITY))
            }
            Source::If { condition, then, otherwise } => {
                let condition = self.text_condition(condition, slots)?;
                let (then, otherwise) = (self.text_value(then, slots)?, self.text_value(otherwise, slots)?);
                Ok(self.graph.select(condition, then, otherwise))
            }
            Source::Compensated(_) | Source::Residual(_) => Err(WrittenError::Compensated),
        }
    }

    fn text_values(&mut self, items: &[Source], slots: &[Node]) -> Result<Vec<Node>, WrittenError> {
        items.iter().map(|item| self.text_value(item, slots)).collect()
    }

    fn text_condition(&mut self, condition: &SourceCondition, slots: &[Node]) -> Result<Condition, WrittenError> {
        let mut part = |part: &SourceCondition| self.text_condition(part, slots).map(Box::new);
        match condition {
            SourceCondition::Compare { op, left, right } => {
                let (left, right) = (self.text_value(left, slots)?, self.text_value(right, slots)?);
                Ok(Condition::Compare(left, *op, right))
            }
            SourceCondition::And(left, right) => Ok(Condition::And(part(left)?, part(right)?)),
            SourceCondition::Or(left, right) => Ok(Condition::Or(part(left)?, part(right)?)),
            SourceCondition::Not(inner) => Ok(Condition::Not(part(inner)?)),
        }
    }
}

/// Whether a text has the conditions and the results of its contract, step by step.
///
/// # Errors
/// See [`WrittenError`].
pub fn same(source: &SourceKernel, contract: &KernelContract, references: &[Definition]) -> Result<bool, WrittenError> {
    let mut written = Written::new(&contract.inputs);
    Ok(written.reference(contract, references)? == written.text(source)?)
}

/// The coefficients of a polynomial in its unknown, lowest power first; `None` if it is none.
fn coefficients(expr: &Expr, unknown: &str) -> Option<Vec<Expr>> {
    if !expr.symbols().contains(unknown) {
        return Some(vec![expr.clone()]);
    }
    match expr {
        Expr::Symbol(_) => Some(vec![Expr::integer(0), Expr::integer(1)]),
        Expr::Sum(items) => {
            let items = items.iter().map(|item| coefficients(item, unknown)).collect::<Option<Vec<_>>>()?;
            items.into_iter().reduce(sum_of)
        }
        Expr::Product(items) => {
            let items = items.iter().map(|item| coefficients(item, unknown)).collect::<Option<Vec<_>>>()?;
            items.into_iter().reduce(|a, b| product_of(&a, &b))
        }
        Expr::Power(base, exponent @ 1..=64) => {
            let base = coefficients(base, unknown)?;
            std::iter::repeat_n(base, *exponent as usize).reduce(|a, b| product_of(&a, &b))
        }
        _ => None,
    }
}

fn sum_of(mut a: Vec<Expr>, b: Vec<Expr>) -> Vec<Expr> {
    a.resize(a.len().max(b.len()), Expr::integer(0));
    a.iter_mut().zip(b).filter(|(_, b)| !b.is_zero()).for_each(|(a, b)| {
        *a = if a.is_zero() { b } else { a.clone().plus(b) };
    });
    a
}

fn product_of(a: &[Expr], b: &[Expr]) -> Vec<Expr> {
    let mut product = vec![Expr::integer(0)];
    for (i, a) in a.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
        for (j, b) in b.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
            let mut term = vec![Expr::integer(0); i + j];
            term.push(a.clone().times(b.clone()));
            product = sum_of(product, term);
        }
    }
    product
}
