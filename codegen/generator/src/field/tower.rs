//! Canonical forms: closed forms as elements of a tower of square and cube roots over rational functions.
//!
//! Radicals may depend on each other without being seen to: the cube roots of `q + sqrt(d)` and `q - sqrt(d)` have the
//! product `cbrt(q^2 - d)`, and the square root of `2 + sqrt(3)` is `(sqrt(6) + sqrt(2))/2`. Polynomials in radicals are
//! then no field: one that is not zero may have the value zero. Nothing wrong follows from that.
//!
//! - What is zero here has the value zero: radicals fulfil all that they are reduced by. So forms that are equal have
//!   equal values, and forms that are not prove nothing: a formula is refused then.
//! - What divides has another value than zero. A quotient is multiplied above and below with conjugates until its
//!   denominator is a polynomial in the inputs and pi, which depend on nothing: only the zero polynomial has the value
//!   zero everywhere. The denominator is the product of the divisor and of every conjugate, so one of these that has the
//!   value zero makes it the zero polynomial, and the quotient is refused, by the loop's end at the latest.
//! - Signs are those of values, given those of the inputs: a norm has the value of a product, whatever that is.

mod cube;
mod square;
pub mod surd;

use super::{Facts, Sign};
use crate::algebra::{Algebra, Polynomial, Ring, Var};
use closedform_project::expression::Expr;
use closedform_syntax::Function;
use std::collections::BTreeMap;
use thiserror::Error;

/// How many variables a tower can add to the inputs: square roots, named differences, results, the circle constant.
const SPARE: usize = 48;

/// A real root that the inputs do not contain.
#[derive(Clone, Debug)]
pub struct Radical {
    /// The variable that stands for the root.
    pub var: Var,
    /// Its degree: 2 or 3.
    pub degree: u32,
    /// The polynomial under the root, in the inputs and the radicals before this one.
    pub radicand: Polynomial,
}

/// A quotient whose denominator is free of radicals, in lowest terms; equal elements are the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// The numerator, of a degree in each radical below the radical's own.
    pub numerator: Polynomial,
    /// The denominator: coprime integer coefficients, upright sign.
    pub denominator: Polynomial,
}

/// Why an expression has no canonical form.
#[derive(Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum TowerError {
    /// A quotient by zero, or by a sum of roots whose conjugate is zero.
    #[error("divides by an expression that is zero everywhere, or whose roots depend on each other")]
    DivisionByZero,
    /// More radicals than the ring has room for.
    #[error("has more than {SPARE} different roots and named parts")]
    TooManyRadicals,
    /// A polynomial root inside another expression.
    #[error(
        "uses positive_root() inside another expression: give the root a kernel of its own and take it as an input"
    )]
    NestedRoot,
    /// A choice inside another expression.
    #[error(
        "uses max() or min() inside another expression: give the choice a kernel of its own and take it as an input"
    )]
    NestedExtreme,
    /// A root of something that is no polynomial in its unknown.
    #[error("asks for the positive_root() of something that is no polynomial in its unknown, free of roots")]
    NoPolynomial,
    /// An exponent out of range.
    #[error("has an exponent too large to expand")]
    HugeExponent,
    /// A name that is no input.
    #[error("uses `{0}`, which is no input")]
    UnknownName(String),
    /// A choice between two values.
    #[error("chooses with `if`, whose sides are no element of one field")]
    Choice,
    /// A function that is no root.
    #[error("calls `{0}`, which is not algebraic")]
    NotAlgebraic(&'static str),
    /// A sum with a cube root that may cancel in a way that no rule mends.
    #[error("adds three terms with a cube root, or its square, that may cancel")]
    CancellingCubes,
    /// A sum with the circle constant that may cancel: no `f64` is exact enough to start from.
    #[error("adds terms with pi that may cancel")]
    CancellingPi,
    /// The square root of a negative constant.
    #[error("takes the square root of a negative number")]
    NegativeRadicand,
}

/// The tower over the inputs of one kernel.
pub struct Tower {
    ring: Ring,
    names: Vec<String>,
    next: usize,
    radicals: Vec<Radical>,
    pi: Option<Var>,
    unknown: Option<(String, Var)>,
    /// What the domain says about signs.
    pub facts: Facts,
}

impl Tower {
    /// The rational functions of some inputs.
    #[must_use]
    pub fn new(algebra: Algebra, inputs: &[String]) -> Self {
        let ring = algebra.ring(inputs.len() + SPARE);
        let facts = Facts::new(&ring, Var(inputs.len()));
        Self {
            facts,
            ring,
            names: inputs.to_vec(),
            next: inputs.len() + 1,
            radicals: Vec::new(),
            pi: None,
            unknown: None,
        }
    }

    /// The ring of polynomials below the tower.
    #[must_use]
    pub fn ring(&self) -> &Ring {
        &self.ring
    }

    /// The radicals, lowest first.
    #[must_use]
    pub fn radicals(&self) -> &[Radical] {
        &self.radicals
    }

    /// The variable of the circle constant, if it occurs.
    #[must_use]
    pub fn pi(&self) -> Option<Var> {
        self.pi
    }

    /// How many inputs there are; they are the first variables.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.names.len()
    }

    /// The radical of this degree and radicand, as an element; a new one if there is none.
    fn radical_of(&mut self, degree: u32, radicand: &Polynomial, sign: Sign) -> Result<Element, TowerError> {
        let known = self.radicals.iter().find(|known| known.degree == degree && known.radicand == *radicand);
        let var = match known {
            Some(known) => known.var,
            None => {
                let var = self.allocate(sign)?;
                self.radicals.push(Radical { var, degree, radicand: radicand.clone() });
                var
            }
        };
        Ok(self.element(&self.ring.variable(var)))
    }

    /// A new variable of a given sign.
    ///
    /// # Errors
    /// When the ring has no room left.
    pub fn allocate(&mut self, sign: Sign) -> Result<Var, TowerError> {
        if self.next >= self.ring.size() {
            return Err(TowerError::TooManyRadicals);
        }
        let var = Var(self.next);
        self.next += 1;
        self.facts.set_variable(var, sign);
        Ok(var)
    }

    /// The radical of highest level that occurs in a polynomial.
    #[must_use]
    pub fn top_radical(&self, polynomial: &Polynomial) -> Option<&Radical> {
        self.radicals.iter().rev().find(|radical| polynomial.contains(radical.var))
    }

    /// The polynomial as an element.
    #[must_use]
    pub fn element(&self, polynomial: &Polynomial) -> Element {
        Element { numerator: polynomial.clone(), denominator: self.ring.integer(1) }
    }

    /// The canonical form of an expression.
    ///
    /// # Errors
    /// Where the expression is no element of a tower of square roots; see [`TowerError`].
    pub fn canonical(&mut self, expr: &Expr) -> Result<Element, TowerError> {
        match expr {
            Expr::Rational(value) => Ok(self.element(&self.ring.constant(value))),
            Expr::Pi => {
                let var = self.pi_variable()?;
                Ok(self.element(&self.ring.variable(var)))
            }
            Expr::Symbol(name) => {
                let var = self.variable(name)?;
                Ok(self.element(&self.ring.variable(var)))
            }
            Expr::Sum(items) => {
                let mut sum = self.element(&self.ring.integer(0));
                for item in items {
                    let item = self.canonical(item)?;
                    sum = self.add(&sum, &item)?;
                }
                Ok(sum)
            }
            Expr::Product(items) => {
                let mut product = self.element(&self.ring.integer(1));
                for item in items {
                    let item = self.canonical(item)?;
                    product = self.multiply(&product, &item)?;
                }
                Ok(product)
            }
            Expr::Power(base, exponent) => {
                let base = self.canonical(base)?;
                self.power(&base, *exponent)
            }
            Expr::Call(function, argument) => {
                let argument = self.canonical(argument)?;
                self.call(*function, &argument)
            }
            Expr::Extreme { .. } => Err(TowerError::NestedExtreme),
            Expr::PositiveRoot { .. } => Err(TowerError::NestedRoot),
            Expr::Choice(..) => Err(TowerError::Choice),
        }
    }

    /// A function of an element.
    fn call(&mut self, function: Function, argument: &Element) -> Result<Element, TowerError> {
        match function {
            Function::Sqrt => self.sqrt(argument),
            Function::Abs => self.abs(argument),
            Function::Cbrt => self.cube_root(argument),
            other => Err(TowerError::NotAlgebraic(other.name())),
        }
    }

    /// The numerator of an expression as a polynomial that has one more variable, `unknown`, which is returned too.
    ///
    /// # Errors
    /// See [`TowerError`].
    pub fn polynomial_in(&mut self, expr: &Expr, unknown: &str) -> Result<(Polynomial, Var), TowerError> {
        let var = self.allocate(Sign::POSITIVE)?;
        self.unknown = Some((unknown.to_owned(), var));
        let element = self.canonical(expr);
        self.unknown = None;
        let element = element?;
        if self.top_radical(&element.numerator).is_some() || element.denominator.contains(var) {
            return Err(TowerError::NoPolynomial);
        }
        Ok((element.numerator, var))
    }

    /// Gives a variable beyond the inputs a name.
    pub fn name_unknown(&mut self, name: &str, var: Var) {
        self.unknown = Some((name.to_owned(), var));
    }

    /// The variable of an input, or of the unknown.
    ///
    /// # Errors
    /// When the name is neither.
    pub fn variable(&self, name: &str) -> Result<Var, TowerError> {
        match &self.unknown {
            Some((unknown, var)) if unknown == name => Ok(*var),
            _ => {
                let index = self.names.iter().position(|n| n == name);
                index.map(Var).ok_or_else(|| TowerError::UnknownName(name.to_owned()))
            }
        }
    }

    fn pi_variable(&mut self) -> Result<Var, TowerError> {
        if let Some(var) = self.pi {
            return Ok(var);
        }
        let var = self.allocate(Sign::POSITIVE)?;
        self.pi = Some(var);
        Ok(var)
    }

    /// The sum.
    ///
    /// # Errors
    /// See [`TowerError`].
    pub fn add(&self, a: &Element, b: &Element) -> Result<Element, TowerError> {
        let left = a.numerator.times(&b.denominator);
        let right = b.numerator.times(&a.denominator);
        self.quotient(&left.plus(&right), &a.denominator.times(&b.denominator))
    }

    /// The product.
    ///
    /// # Errors
    /// See [`TowerError`].
    pub fn multiply(&self, a: &Element, b: &Element) -> Result<Element, TowerError> {
        self.quotient(&a.numerator.times(&b.numerator), &a.denominator.times(&b.denominator))
    }

    /// The negative.
    #[must_use]
    pub fn negate(&self, a: &Element) -> Element {
        Element { numerator: a.numerator.negated(), denominator: a.denominator.clone() }
    }

    /// The reciprocal.
    ///
    /// # Errors
    /// When the element has the value zero, or one of its conjugates has.
    pub fn reciprocal(&self, a: &Element) -> Result<Element, TowerError> {
        self.quotient(&a.denominator, &a.numerator)
    }

    fn power(&self, base: &Element, exponent: i32) -> Result<Element, TowerError> {
        let magnitude = exponent.unsigned_abs();
        if magnitude > 64 {
            return Err(TowerError::HugeExponent);
        }
        let base = if exponent < 0 { self.reciprocal(base)? } else { base.clone() };
        let mut result = self.element(&self.ring.integer(1));
        for _ in 0..magnitude {
            result = self.multiply(&result, &base)?;
        }
        Ok(result)
    }

    /// A quotient of polynomials in inputs and radicals, in canonical form.
    ///
    /// # Errors
    /// When the denominator has the value zero, or one of its conjugates has.
    pub fn quotient(&self, numerator: &Polynomial, denominator: &Polynomial) -> Result<Element, TowerError> {
        let mut numerator = self.reduce(numerator);
        let mut denominator = self.reduce(denominator);
        while let Some(radical) = self.top_radical(&denominator) {
            let conjugate = self.conjugate(&denominator, radical);
            numerator = self.reduce(&numerator.times(&conjugate));
            denominator = self.reduce(&denominator.times(&conjugate));
        }
        if denominator.is_zero() {
            return Err(TowerError::DivisionByZero);
        }
        Ok(self.lowest_terms(&numerator, &denominator))
    }

    /// Replaces powers of radicals by powers of their radicands.
    #[must_use]
    pub fn reduce(&self, polynomial: &Polynomial) -> Polynomial {
        let mut result = polynomial.clone();
        for radical in self.radicals.iter().rev() {
            if u32::from(result.degree(radical.var)) < radical.degree {
                continue;
            }
            let root = self.ring.variable(radical.var);
            let mut sum = self.ring.integer(0);
            for (power, coefficient) in (0..).zip(&result.coefficients(radical.var)) {
                let whole = coefficient.times(&radical.radicand.power(power / radical.degree));
                sum = sum.plus(&whole.times(&root.power(power % radical.degree)));
            }
            result = sum;
        }
        result
    }

    fn lowest_terms(&self, numerator: &Polynomial, denominator: &Polynomial) -> Element {
        let common = self.content(numerator).gcd(denominator);
        let cancel = |p: &Polynomial| p.divided_by(&common).unwrap_or_else(|| p.clone());
        let (content, denominator) = cancel(denominator).primitive();
        Element { numerator: cancel(numerator).scaled(&content.recip()), denominator }
    }

    /// The greatest common divisor of the coefficients of all products of radicals, free of rational content.
    #[must_use]
    pub fn content(&self, polynomial: &Polynomial) -> Polynomial {
        let common = self.split(polynomial).values().fold(self.ring.integer(0), |gcd, part| gcd.gcd(part));
        common.primitive().1
    }

    /// The coefficients of all products of radicals, by the exponents of the radicals.
    fn split(&self, polynomial: &Polynomial) -> BTreeMap<Vec<u16>, Polynomial> {
        let mut parts: BTreeMap<Vec<u16>, Polynomial> = BTreeMap::new();
        for mut term in polynomial.terms() {
            let key = self.radicals.iter().map(|r| std::mem::take(&mut term.exponents[r.var.0])).collect();
            let single = self.ring.term(&term.coefficient, &term.exponents);
            let part = parts.entry(key).or_insert_with(|| self.ring.integer(0));
            *part = part.plus(&single);
        }
        parts
    }
}
