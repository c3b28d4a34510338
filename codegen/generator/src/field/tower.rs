//! Canonical forms: closed forms as elements of a tower of square roots over rational functions.

use super::{Facts, Sign};
use crate::algebra::{Algebra, Polynomial, Ring, Var};
use closedform_project::expression::Expr;
use closedform_syntax::Function;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;
use thiserror::Error;

/// How many variables a tower can add to the inputs: square roots, named differences, results, the circle constant.
const SPARE: usize = 48;

/// A square root that the inputs do not contain.
#[derive(Clone, Debug)]
pub struct Radical {
    /// The variable that stands for the root.
    pub var: Var,
    /// The polynomial under the root, in the inputs and the radicals before this one.
    pub radicand: Polynomial,
}

/// A quotient whose denominator is free of radicals, in lowest terms; equal elements are the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// The numerator, at most linear in each radical.
    pub numerator: Polynomial,
    /// The denominator: coprime integer coefficients, upright sign.
    pub denominator: Polynomial,
}

/// Why an expression has no canonical form.
#[derive(Debug, Error, PartialEq)]
pub enum TowerError {
    /// A quotient by zero.
    #[error("divides by an expression that is zero everywhere")]
    DivisionByZero,
    /// More radicals than the ring has room for.
    #[error("has more than {SPARE} different square roots and named parts")]
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
    #[error("asks for the positive_root() of something that is no polynomial in its unknown, free of square roots")]
    NoPolynomial,
    /// An exponent out of range.
    #[error("has an exponent too large to expand")]
    HugeExponent,
    /// A name that is no input.
    #[error("uses `{0}`, which is no input")]
    UnknownName(String),
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
        }
    }

    /// A function of an element.
    fn call(&mut self, function: Function, argument: &Element) -> Result<Element, TowerError> {
        match function {
            Function::Sqrt => self.sqrt(argument),
            Function::Abs => self.abs(argument),
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
    /// When the element is zero.
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
    /// When the denominator is zero.
    pub fn quotient(&self, numerator: &Polynomial, denominator: &Polynomial) -> Result<Element, TowerError> {
        let mut numerator = self.reduce(numerator);
        let mut denominator = self.reduce(denominator);
        while let Some(radical) = self.top_radical(&denominator) {
            let conjugate = conjugate(&denominator, radical.var);
            numerator = self.reduce(&numerator.times(&conjugate));
            denominator = self.reduce(&denominator.times(&conjugate));
        }
        if denominator.is_zero() {
            return Err(TowerError::DivisionByZero);
        }
        Ok(self.lowest_terms(&numerator, &denominator))
    }

    /// Replaces even powers of radicals by powers of their radicands.
    #[must_use]
    pub fn reduce(&self, polynomial: &Polynomial) -> Polynomial {
        let mut result = polynomial.clone();
        for radical in self.radicals.iter().rev() {
            if result.degree(radical.var) < 2 {
                continue;
            }
            let root = self.ring.variable(radical.var);
            let mut sum = self.ring.integer(0);
            for (power, coefficient) in result.coefficients(radical.var).iter().enumerate() {
                let even = coefficient.times(&radical.radicand.power((power / 2) as u32));
                sum = sum.plus(&if power % 2 == 0 { even } else { even.times(&root) });
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

    /// The nonnegative square root.
    ///
    /// # Errors
    /// See [`TowerError`].
    pub fn sqrt(&mut self, a: &Element) -> Result<Element, TowerError> {
        if a.numerator.is_zero() {
            return Ok(a.clone());
        }
        let radicand = self.reduce(&a.numerator.times(&a.denominator));
        let sign = self.facts.sign(&a.denominator);
        let (outside, denominator, inside) = self.split_squares(&radicand)?;
        let root = self.radical(&inside)?;
        let magnitude = if sign.is(Sign::NONNEGATIVE) {
            a.denominator.clone()
        } else if sign.is(Sign::NONPOSITIVE) {
            a.denominator.negated()
        } else {
            return self.sqrt_over_open_sign(a);
        };
        let root = self.multiply(&root, &self.element(&outside))?;
        self.multiply(&root, &self.quotient(&self.ring.integer(1), &magnitude.scaled(&denominator))?)
    }

    /// `sqrt(n/d)` where the sign of `d` is open: `sqrt(n*d)/|d|`, and `|d|` is `sqrt(d^2)`.
    fn sqrt_over_open_sign(&mut self, a: &Element) -> Result<Element, TowerError> {
        let magnitude = self.radical(&a.denominator.power(2))?;
        let inside = self.reduce(&a.numerator.times(&a.denominator));
        let root = self.sqrt(&self.element(&inside))?;
        self.multiply(&root, &self.reciprocal(&magnitude)?)
    }

    /// Writes a radicand as `(outside/denominator)^2 * inside`.
    fn split_squares(&self, radicand: &Polynomial) -> Result<(Polynomial, BigRational, Polynomial), TowerError> {
        let content = self.content(radicand);
        let rational = radicand.primitive().0.abs();
        let (square, rest) = split_square_integer(&(rational.numer() * rational.denom()));
        let mut outside = self.ring.constant(&BigRational::from_integer(square));
        let denominator = BigRational::from_integer(rational.denom().clone());
        let mut inside = radicand.scaled(&(BigRational::from_integer(rest) / &rational));
        for (factor, exponent) in &content.factors().powers {
            let sign = self.facts.sign(factor);
            if *exponent < 2 || !sign.is_definite() {
                continue;
            }
            let magnitude = if sign.is(Sign::NONNEGATIVE) { factor.clone() } else { factor.negated() };
            outside = outside.times(&magnitude.power(exponent / 2));
            let squares = factor.power(exponent / 2 * 2);
            inside = inside.divided_by(&squares).unwrap_or(inside);
        }
        if inside.as_constant().is_some_and(|c| c.is_negative()) {
            return Err(TowerError::NegativeRadicand);
        }
        Ok((outside, denominator, inside))
    }

    /// The root of a polynomial, through radicals that the tower has, or as a new one.
    fn radical(&mut self, inside: &Polynomial) -> Result<Element, TowerError> {
        if inside.as_constant().is_some_and(|c| c.is_one()) {
            return Ok(self.element(&self.ring.integer(1)));
        }
        if let Some(known) = self.radicals.iter().find(|radical| radical.radicand == *inside) {
            return Ok(self.element(&self.ring.variable(known.var)));
        }
        if let Some(known) = self.through_known_radicals(inside) {
            return Ok(known);
        }
        let sign = if self.facts.sign(inside).is(Sign::POSITIVE) { Sign::POSITIVE } else { Sign::NONNEGATIVE };
        let var = self.allocate(sign)?;
        // an expression that takes this root is real nowhere else
        self.facts.learn(inside, Sign::NONNEGATIVE);
        self.radicals.push(Radical { var, radicand: inside.clone() });
        Ok(self.element(&self.ring.variable(var)))
    }

    /// The root as a quotient of known radicals times a polynomial: `sqrt(6)` is `sqrt(2)*sqrt(3)`, and so is `sqrt(2)`
    /// if `sqrt(6)` and `sqrt(3)` are known.
    fn through_known_radicals(&self, inside: &Polynomial) -> Option<Element> {
        let count = self.radicals.len().min(6);
        (1_usize..1 << count).find_map(|all| {
            // the subsets of `all`, the whole first
            let mut below = std::iter::successors(Some(all), |below| below.checked_sub(1).map(|below| below & all));
            below.find_map(|below| self.through_quotient(inside, all & !below, below))
        })
    }

    /// The root as a polynomial times the radicals `above`, over those `below`.
    fn through_quotient(&self, inside: &Polynomial, above: usize, below: usize) -> Option<Element> {
        let chosen =
            |set: usize| self.radicals.iter().enumerate().filter(move |(i, _)| set >> i & 1 == 1).map(|(_, r)| r);
        let one = self.ring.integer(1);
        let divisor = chosen(below).fold(one.clone(), |p, r| p.times(&r.radicand));
        let radicands = chosen(above).fold(one.clone(), |p, r| p.times(&r.radicand));
        let square = self.reduce(&inside.times(&divisor)).divided_by(&radicands)?;
        let (outside, denominator) = self.root_of_square(&square)?;
        let roots = chosen(above | below).fold(outside, |p, r| p.times(&self.ring.variable(r.var)));
        self.quotient(&roots, &divisor.scaled(&denominator)).ok()
    }

    /// The root of a square, as a polynomial and a number that divides it.
    fn root_of_square(&self, square: &Polynomial) -> Option<(Polynomial, BigRational)> {
        let (outside, denominator, rest) = self.split_squares(square).ok()?;
        rest.as_constant()?.is_one().then_some((outside, denominator))
    }

    /// The magnitude: where the sign is open, the root of the square.
    fn abs(&mut self, a: &Element) -> Result<Element, TowerError> {
        let sign = self.sign(a);
        if sign.is(Sign::NONNEGATIVE) {
            Ok(a.clone())
        } else if sign.is(Sign::NONPOSITIVE) {
            Ok(self.negate(a))
        } else {
            let above = self.sqrt(&self.element(&self.reduce(&a.numerator.power(2))))?;
            let below = self.sqrt(&self.element(&a.denominator.power(2)))?;
            self.multiply(&above, &self.reciprocal(&below)?)
        }
    }

    /// What a radical is the magnitude of, if it is the root of a square.
    #[must_use]
    pub fn magnitude_of(&self, radical: &Radical) -> Option<Polynomial> {
        let factors = radical.radicand.factors();
        let even = factors.powers.iter().all(|(_, power)| power % 2 == 0);
        let root = factors.powers.iter().fold(self.ring.integer(1), |p, (f, power)| p.times(&f.power(power / 2)));
        (even && factors.constant.is_one() && self.top_radical(&radical.radicand).is_none()).then_some(root)
    }

    /// The sign of an element on the domain.
    #[must_use]
    pub fn sign(&self, a: &Element) -> Sign {
        self.sign_of(&a.numerator) * self.facts.sign(&a.denominator)
    }

    /// The sign of a polynomial in inputs and radicals.
    #[must_use]
    pub fn sign_of(&self, polynomial: &Polynomial) -> Sign {
        let Some(radical) = self.top_radical(polynomial) else {
            return self.facts.sign(polynomial);
        };
        let (rational, surd) = parts(polynomial, radical.var);
        let root = self.facts.variable(radical.var);
        let left = self.sign_of(&rational);
        let right = self.sign_of(&surd) * root;
        let sum = left.plus(right);
        if sum.is_definite() {
            return sum;
        }
        // a + b*r with a and b*r of opposite signs has the sign of the norm, or its negative
        let norm = self.sign_of(&self.norm(polynomial, radical));
        if left.is(Sign::NONNEGATIVE) && right.is(Sign::NONPOSITIVE) {
            norm
        } else if left.is(Sign::NONPOSITIVE) && right.is(Sign::NONNEGATIVE) {
            -norm
        } else {
            Sign::ANY
        }
    }

    /// The product of a polynomial with its conjugate, free of the radical.
    #[must_use]
    pub fn norm(&self, polynomial: &Polynomial, radical: &Radical) -> Polynomial {
        self.reduce(&polynomial.times(&conjugate(polynomial, radical.var)))
    }
}

/// The polynomial with the radical's sign turned.
#[must_use]
pub fn conjugate(polynomial: &Polynomial, radical: Var) -> Polynomial {
    let root = polynomial.ring().variable(radical);
    let (rational, surd) = parts(polynomial, radical);
    rational.minus(&surd.times(&root))
}

/// The parts `a`, `b` of `a + b*radical`.
#[must_use]
pub fn parts(polynomial: &Polynomial, radical: Var) -> (Polynomial, Polynomial) {
    let mut coefficients = polynomial.coefficients(radical).into_iter();
    let zero = polynomial.ring().integer(0);
    let rational = coefficients.next().unwrap_or_else(|| zero.clone());
    (rational, coefficients.next().unwrap_or(zero))
}

/// Writes a positive integer as `square^2 * rest`, by trial division (a large cofactor stays whole).
fn split_square_integer(value: &BigInt) -> (BigInt, BigInt) {
    let mut rest = value.clone();
    let mut square = BigInt::one();
    let root = value.sqrt();
    if &root * &root == *value {
        return (root, BigInt::one());
    }
    for divisor in 2_u32..=10_000 {
        let divisor = BigInt::from(divisor);
        let divisor_squared = &divisor * &divisor;
        if divisor_squared > rest {
            break;
        }
        while (&rest % &divisor_squared).is_zero() {
            rest /= &divisor_squared;
            square *= &divisor;
        }
    }
    let root = rest.sqrt();
    if root.to_u8() != Some(1) && &root * &root == rest {
        return (square * root, BigInt::one());
    }
    (square, rest)
}
