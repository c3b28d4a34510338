//! Nested forms: a polynomial as sums and products with few operations, plain or for double-double.

use crate::algebra::{Factors, Polynomial, Var};
use crate::field::{Facts, Sign};
use crate::program::{is_exact, is_power_of_two};
use num_rational::BigRational;
use num_traits::{One, Signed};
use std::collections::HashMap;

/// How a polynomial is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Nested {
    /// A constant.
    Constant(BigRational),
    /// A variable.
    Var(Var),
    /// The sum of two parts, with the signs of both and of the sum on the domain.
    Sum(Box<Nested>, Box<Nested>, [Sign; 3]),
    /// The product of two parts.
    Product(Box<Nested>, Box<Nested>),
}

/// What the parts of a sum must fulfil.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    /// No sum may cancel: its terms agree in sign on the domain, or both are exact.
    Plain,
    /// Sums may cancel, because they are evaluated in double-double.
    DoubleDouble,
}

/// How many variables are tried as the outermost one of a Horner form, while no more than so many polynomials have been
/// nested: of many variables, all orders are too many.
const TRIED: usize = 3;
const MANY: usize = 1_000;

/// Finds nested forms over a domain, remembering what it found.
pub struct Nester<'f> {
    facts: &'f Facts,
    inputs: usize,
    mode: Mode,
    found: HashMap<String, Option<(Nested, usize)>>,
}

impl<'f> Nester<'f> {
    /// A search in one mode; the first `inputs` variables have exact values.
    #[must_use]
    pub fn new(facts: &'f Facts, inputs: usize, mode: Mode) -> Self {
        Self { facts, inputs, mode, found: HashMap::new() }
    }

    /// The cheapest nested form that was tried, if there is one.
    pub fn nest(&mut self, polynomial: &Polynomial) -> Option<Nested> {
        self.search(polynomial).map(|(nested, _)| nested)
    }

    fn search(&mut self, polynomial: &Polynomial) -> Option<(Nested, usize)> {
        let key = format!("{:?}", polynomial.terms());
        if let Some(found) = self.found.get(&key) {
            return found.clone();
        }
        let result = self.product_of_factors(polynomial).or_else(|| self.horner(polynomial));
        self.found.insert(key, result.clone());
        result
    }

    /// The product of the factors, unless there is but one or one of them has no form.
    fn product_of_factors(&mut self, polynomial: &Polynomial) -> Option<(Nested, usize)> {
        let mut factors = polynomial.factors();
        let single = factors.powers.len() == 1 && factors.powers[0].1 == 1;
        let upright = factors.constant.is_one() || factors.constant.abs().is_one() && has_both_signs(polynomial);
        if single && polynomial.len() > 1 && upright {
            return None;
        }
        turn_minus_into_a_difference(&mut factors);
        let mut parts = Vec::new();
        let mut cost = 0;
        if !factors.constant.is_one() || factors.powers.is_empty() {
            parts.push(Nested::Constant(factors.constant));
        }
        for (factor, exponent) in &factors.powers {
            let (nested, factor_cost) = match single_variable(factor) {
                Some(var) => (Nested::Var(var), 0),
                None if single => self.horner(factor)?,
                None => self.search(factor)?,
            };
            cost += factor_cost;
            parts.extend(std::iter::repeat_n(nested, *exponent as usize));
        }
        cost += parts.len() - 1;
        let product = product(parts);
        Some((product, cost))
    }

    /// `rest + v^k * quotient`, for the variable that makes it cheapest.
    fn horner(&mut self, polynomial: &Polynomial) -> Option<(Nested, usize)> {
        let mut variables = polynomial.variables();
        variables.sort_by_key(|&var| {
            let uses = polynomial.terms().iter().filter(|t| t.exponents[var.0] > 0).count();
            (std::cmp::Reverse(uses), var)
        });
        let mut best: Option<(Nested, usize)> = None;
        let tried = if self.found.len() < MANY { TRIED } else { 1 };
        for var in variables.into_iter().take(tried) {
            let candidate = self.horner_in(polynomial, var);
            if let Some((nested, cost)) = candidate
                && best.as_ref().is_none_or(|(_, least)| cost < *least)
            {
                best = Some((nested, cost));
            }
        }
        best
    }

    fn horner_in(&mut self, polynomial: &Polynomial, var: Var) -> Option<(Nested, usize)> {
        let coefficients = polynomial.coefficients(var);
        let rest = coefficients.first()?.clone();
        let power = coefficients.iter().skip(1).position(|c| !c.is_zero())? as u32 + 1;
        let factor = polynomial.ring().variable(var).power(power);
        let quotient = polynomial.minus(&rest).divided_by(&factor)?;
        let multiple = quotient.times(&factor);
        if !self.may_add(&rest, &multiple) {
            return None;
        }
        let signs = [&multiple, &rest, polynomial].map(|part| self.facts.sign(part));
        let (rest, rest_cost) = self.search(&rest)?;
        let (quotient_nested, quotient_cost) = self.search(&quotient)?;
        let mut factors = vec![Nested::Var(var); power as usize];
        factors.push(quotient_nested);
        let product = product(factors);
        let cost = rest_cost + quotient_cost + power as usize + 1;
        Some((Nested::Sum(Box::new(product), Box::new(rest), signs), cost))
    }

    fn may_add(&self, a: &Polynomial, b: &Polynomial) -> bool {
        let exact = self.is_exact(a) && self.is_exact(b);
        self.mode == Mode::DoubleDouble || exact || self.facts.sign(a).plus(self.facts.sign(b)).is_definite()
    }

    /// Whether `f64` holds the value without rounding: an input times a power of two, or a constant.
    fn is_exact(&self, polynomial: &Polynomial) -> bool {
        let terms = polynomial.terms();
        let [term] = terms.as_slice() else { return false };
        match polynomial.variables().as_slice() {
            [] => is_exact(&term.coefficient),
            [var] => term.exponents[var.0] == 1 && var.0 < self.inputs && is_power_of_two(&term.coefficient),
            _ => false,
        }
    }
}

fn has_both_signs(polynomial: &Polynomial) -> bool {
    let terms = polynomial.terms();
    let negative = terms.iter().filter(|term| term.coefficient.is_negative()).count();
    negative > 0 && negative < terms.len()
}

/// Lets a factor that is a difference take the minus of the constant.
fn turn_minus_into_a_difference(factors: &mut Factors) {
    if !factors.constant.is_negative() {
        return;
    }
    if let Some((factor, _)) =
        factors.powers.iter_mut().find(|(factor, power)| has_both_signs(factor) && power % 2 == 1)
    {
        *factor = factor.negated();
        factors.constant = -factors.constant.clone();
    }
}

/// The product of the factors from left to right, its constant first.
fn product(factors: Vec<Nested>) -> Nested {
    let mut constant = BigRational::one();
    let mut flat = Vec::new();
    let mut open: Vec<Nested> = factors.into_iter().rev().collect();
    while let Some(factor) = open.pop() {
        match factor {
            Nested::Constant(value) => constant *= value,
            Nested::Product(a, b) => open.extend([*b, *a]),
            other => flat.push(other),
        }
    }
    if !constant.is_one() || flat.is_empty() {
        flat.insert(0, Nested::Constant(constant));
    }
    let mut product = flat.remove(0);
    for factor in flat {
        product = Nested::Product(Box::new(product), Box::new(factor));
    }
    product
}

/// The variable that the polynomial is.
#[must_use]
pub fn single_variable(polynomial: &Polynomial) -> Option<Var> {
    let variables = polynomial.variables();
    let [var] = variables.as_slice() else { return None };
    (*polynomial == polynomial.ring().variable(*var)).then_some(*var)
}
