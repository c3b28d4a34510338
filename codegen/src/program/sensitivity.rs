//! How a step's relative error follows from the roundings behind it.
//!
//! Each rounding multiplies a step by 1+d, |d| below its size, and moves the logarithm of every later step by some factor
//! times its own logarithm. Those factors add up in a product, subtract in a quotient, are halved in a square root, and
//! in a sum of terms of one sign are averaged, with positive weights that nobody needs to know: the factors of all
//! roundings together lie in the convex hull of some vectors, the corners. The largest sum of sizes times factors at a
//! corner bounds the logarithm of what the step is off by: exactly so, not to first order, because the hull holds on
//! the whole way from the exact to the computed values. A rounding that reaches a step on two ways, as in t/(t+s), counts
//! with what is left of it.

use std::collections::BTreeMap;

/// A rounding, by position in [`Roundings`].
type Rounding = usize;

/// The factors of the roundings at one corner; those left out are 0.
type Corner = BTreeMap<Rounding, f64>;

/// More corners are not kept: then a step's whole error becomes one rounding.
const CORNERS: usize = 64;

/// The sizes of all roundings of a program, in units of 2^-53.
#[derive(Default)]
pub struct Roundings(Vec<f64>);

/// The factors of the roundings behind a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity(Vec<Corner>);

impl Sensitivity {
    /// Of a step without error.
    pub fn exact() -> Self {
        Self(vec![Corner::new()])
    }

    /// Whether there is no rounding behind the step.
    pub fn is_exact(&self) -> bool {
        self.0.iter().all(Corner::is_empty)
    }

    /// Of a sum of terms of one sign.
    pub fn between(&self, other: &Self) -> Self {
        let mut corners = self.0.clone();
        corners.extend(other.0.iter().filter(|corner| !self.0.contains(corner)).cloned());
        Self(corners)
    }

    /// Of a square root.
    pub fn halved(&self) -> Self {
        let half = |corner: &Corner| corner.iter().map(|(&rounding, factor)| (rounding, 0.5 * factor)).collect();
        Self(self.0.iter().map(half).collect())
    }
}

impl Roundings {
    /// One more, of this size.
    pub fn of(&mut self, size: f64) -> Sensitivity {
        self.0.push(size);
        Sensitivity(vec![Corner::from([(self.0.len() - 1, 1.0)])])
    }

    /// What a step is off by at most, relative to it, in units of 2^-53.
    pub fn bound(&self, sensitivity: &Sensitivity) -> f64 {
        let part = |(&rounding, factor): (&Rounding, &f64)| factor.abs() * self.0[rounding];
        let sum = |corner: &Corner| corner.iter().map(part).sum();
        sensitivity.0.iter().map(sum).fold(0.0, f64::max)
    }

    /// Of a product, or of a step and its own rounding.
    pub fn product(&mut self, a: &Sensitivity, b: &Sensitivity) -> Sensitivity {
        self.joined(a, b, 1.0)
    }

    /// Of a quotient.
    pub fn quotient(&mut self, a: &Sensitivity, b: &Sensitivity) -> Sensitivity {
        self.joined(a, b, -1.0)
    }

    fn joined(&mut self, a: &Sensitivity, b: &Sensitivity, sign: f64) -> Sensitivity {
        if a.0.len() * b.0.len() > CORNERS {
            let [a, b] = [a, b].map(|part| self.as_one(part));
            return self.joined(&a, &b, sign);
        }
        let mut corners: Vec<Corner> = Vec::new();
        for (left, right) in a.0.iter().flat_map(|left| b.0.iter().map(move |right| (left, right))) {
            let mut corner = left.clone();
            for (&rounding, factor) in right {
                *corner.entry(rounding).or_default() += sign * factor;
            }
            corner.retain(|_, factor| *factor != 0.0);
            if !corners.contains(&corner) {
                corners.push(corner);
            }
        }
        Sensitivity(corners)
    }

    /// The whole error as one rounding.
    fn as_one(&mut self, sensitivity: &Sensitivity) -> Sensitivity {
        if sensitivity.0.len() == 1 { sensitivity.clone() } else { self.of(self.bound(sensitivity)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounding_counts_with_what_is_left_of_it() {
        let mut roundings = Roundings::default();
        let (t, s) = (roundings.of(8.0), roundings.of(1.0));
        let square = roundings.product(&t, &t);
        assert_eq!(roundings.bound(&square), 16.0);
        let one = roundings.quotient(&t, &t);
        assert!(one.is_exact() && !s.is_exact());
        // t/(t+s): nothing where t is much larger, 8 and 1 where s is
        let share = roundings.quotient(&t, &t.between(&s));
        assert_eq!(roundings.bound(&share), 9.0);
        let mean = roundings.product(&t, &s).halved();
        assert_eq!(roundings.bound(&mean), 4.5);
    }

    #[test]
    fn a_sum_is_no_worse_than_its_worst_term() {
        let mut roundings = Roundings::default();
        let (a, b) = (roundings.of(3.0), roundings.of(5.0));
        assert_eq!(roundings.bound(&a.between(&b)), 5.0);
    }

    #[test]
    fn too_many_corners_become_one() {
        let mut roundings = Roundings::default();
        let mut product = Sensitivity::exact();
        for _ in 0..10 {
            let sum = roundings.of(1.0).between(&roundings.of(2.0));
            product = roundings.product(&product, &sum);
            assert!(product.0.len() <= CORNERS);
        }
        assert_eq!(roundings.bound(&product), 20.0);
    }
}
