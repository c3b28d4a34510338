//! Intervals of rational numbers, and the sign that they leave a polynomial on a box.

use super::set::Sign;
use crate::algebra::Term;
use closedform_arith::Relation;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// How many terms are evaluated, on one part of a box after another, before a sign is given up. The bounds are proved with
/// more patience: what is found here must be found there again.
const TERMS: usize = 1024;

/// A number or an infinity.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Limit {
    MinusInfinity,
    Number(BigRational),
    PlusInfinity,
}

/// The numbers from one limit to another one; a limit belongs to them if it is reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    from: (Limit, bool),
    to: (Limit, bool),
}

impl Limit {
    fn zero() -> Self {
        Self::Number(BigRational::zero())
    }

    fn plus(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a + b),
            (Self::Number(_), infinity) | (infinity, _) => infinity.clone(),
        }
    }

    /// Zero times an infinity is zero here: it stands for products of zero and large numbers.
    fn times(&self, other: &Self) -> Self {
        let zero = Self::zero();
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a * b),
            _ if *self == zero || *other == zero => zero,
            _ if (*self < zero) == (*other < zero) => Self::PlusInfinity,
            _ => Self::MinusInfinity,
        }
    }
}

impl Interval {
    /// Every number.
    pub fn all() -> Self {
        Self { from: (Limit::MinusInfinity, false), to: (Limit::PlusInfinity, false) }
    }

    /// One number.
    fn of(value: &BigRational) -> Self {
        let limit = (Limit::Number(value.clone()), true);
        Self { from: limit.clone(), to: limit }
    }

    /// The part of the interval that stands so to a number; a single number cannot be left out of it.
    #[must_use]
    pub fn related(self, relation: Relation, value: &BigRational) -> Self {
        let reached = relation.holds(Ordering::Equal);
        let limit = (Limit::Number(value.clone()), reached);
        let narrower = |old: (Limit, bool), inner: Ordering| match limit.0.cmp(&old.0) {
            Ordering::Equal => (old.0, old.1 && reached),
            order if order == inner => limit.clone(),
            _ => old,
        };
        let from_above = relation.is_above() || relation == Relation::Equal;
        let to_below = relation.is_below() || relation == Relation::Equal;
        let from = if from_above { narrower(self.from, Ordering::Greater) } else { self.from };
        Self { from, to: if to_below { narrower(self.to, Ordering::Less) } else { self.to } }
    }

    /// Whether a number other than zero limits it.
    pub fn is_limited(&self) -> bool {
        [&self.from.0, &self.to.0].into_iter().any(|limit| matches!(limit, Limit::Number(value) if !value.is_zero()))
    }

    fn sign(&self) -> Sign {
        let zero = Limit::zero();
        let contains_zero = (self.from.0 < zero || self.from == (zero.clone(), true))
            && (self.to.0 > zero || self.to == (zero.clone(), true));
        let parts =
            [(self.from.0 < zero, Sign::NEGATIVE), (contains_zero, Sign::ZERO), (self.to.0 > zero, Sign::POSITIVE)];
        let impossible = parts.into_iter().filter(|(possible, _)| !possible);
        impossible.fold(Sign::ANY, |sign, (_, part)| sign & part.complement())
    }

    fn plus(&self, other: &Self) -> Self {
        let sum = |a: &(Limit, bool), b: &(Limit, bool)| (a.0.plus(&b.0), a.1 && b.1);
        Self { from: sum(&self.from, &other.from), to: sum(&self.to, &other.to) }
    }

    fn times(&self, other: &Self) -> Self {
        let pairs = [&self.from, &self.to].into_iter().flat_map(|a| [(a, &other.from), (a, &other.to)]);
        let mut products: Vec<(Limit, bool)> = pairs.map(|(a, b)| product(a, b)).collect();
        // of equal products the one that is reached comes last on both sides
        products.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.cmp(&b.1)));
        let to = products[products.len() - 1].clone();
        let least = products.iter().take_while(|(limit, _)| *limit == products[0].0).last();
        Self { from: least.unwrap_or(&to).clone(), to }
    }

    fn power(&self, exponent: u16) -> Self {
        let whole = (0..exponent).fold(Self::of(&BigRational::one()), |power, _| power.times(self));
        // factors that are the same number are of the same sign
        if exponent.is_multiple_of(2) { whole.related(Relation::GreaterOrEqual, &BigRational::zero()) } else { whole }
    }

    fn limits(&self) -> Option<(&BigRational, &BigRational)> {
        match (&self.from.0, &self.to.0) {
            (Limit::Number(from), Limit::Number(to)) => Some((from, to)),
            _ => None,
        }
    }

    /// Some number inside.
    fn inner(&self) -> BigRational {
        match (&self.from.0, &self.to.0) {
            (Limit::Number(from), Limit::Number(to)) => (from + to) / BigRational::from_integer(2.into()),
            (Limit::Number(from), _) => from + BigRational::one(),
            (_, Limit::Number(to)) => to - BigRational::one(),
            _ => BigRational::zero(),
        }
    }
}

/// What is reached where both factors are, or where a factor is zero.
fn product(a: &(Limit, bool), b: &(Limit, bool)) -> (Limit, bool) {
    let at_zero = |limit: &(Limit, bool)| *limit == (Limit::zero(), true);
    (a.0.times(&b.0), a.1 && b.1 || at_zero(a) || at_zero(b))
}

/// The sign of a sum of terms on a box, one interval a variable. Halves of the box are looked at where the whole leaves it
/// open.
pub fn sign_on(ranges: &[Interval], terms: &[Term]) -> Sign {
    let mut parts = vec![ranges.to_vec()];
    let mut signs: Option<Sign> = None;
    let most = TERMS / terms.len().max(1);
    for looked in 1.. {
        let Some(part) = parts.pop() else { break };
        let mut sign = value(&part, terms).sign();
        if !sign.is_definite() {
            let wide = widest(&part, terms).filter(|_| looked + parts.len() < most);
            let Some(var) = wide else { return Sign::ANY };
            // points of both signs end the search
            let point: Vec<Interval> = part.iter().map(|interval| Interval::of(&interval.inner())).collect();
            sign = value(&point, terms).sign();
            parts.extend(halves(&part, var));
        }
        let all = signs.map_or(sign, |signs| signs.or(sign));
        if !all.is_definite() {
            return Sign::ANY;
        }
        signs = Some(all);
    }
    signs.unwrap_or(Sign::ANY)
}

fn halves(part: &[Interval], var: usize) -> [Vec<Interval>; 2] {
    [Relation::LessOrEqual, Relation::GreaterOrEqual].map(|side| {
        let mut half = part.to_vec();
        half[var] = half[var].clone().related(side, &part[var].inner());
        half
    })
}

fn value(ranges: &[Interval], terms: &[Term]) -> Interval {
    let of_term = |term: &Term| {
        let powers = term.exponents.iter().zip(ranges).filter(|(exponent, _)| **exponent > 0);
        powers.fold(Interval::of(&term.coefficient), |product, (exponent, base)| product.times(&base.power(*exponent)))
    };
    terms.iter().map(of_term).fold(Interval::of(&BigRational::zero()), |sum, term| sum.plus(&term))
}

/// The variable to be halved: of those that several terms share, the one whose interval is the widest.
fn widest(ranges: &[Interval], terms: &[Term]) -> Option<usize> {
    let shared = |var: &usize| terms.iter().filter(|term| term.exponents[*var] > 0).count() > 1;
    let width =
        |var: usize| ranges[var].limits().map(|(from, to)| (var, to - from)).filter(|(_, width)| !width.is_zero());
    (0..ranges.len()).filter(shared).filter_map(width).max_by(|a, b| a.1.cmp(&b.1)).map(|(var, _)| var)
}
