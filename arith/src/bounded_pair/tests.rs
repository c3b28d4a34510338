//! Pairs against MPFR: each operation at the ends of its intervals, and random expressions.

#[path = "../../tests/common/random.rs"]
mod random;

use random::Random;
use rug::Float;
use std::vec::Vec;

use super::BoundedPair;
use crate::error_model::UNIT;
use crate::error_model::compensated::{Part, threshold};

/// More than the exponents of what is added are apart.
const BITS: u32 = 2400;

/// The margin of the rounding test for terms of higher order.
const MARGIN: f64 = 1.01;

impl Random {
    fn sign(&mut self) -> f64 {
        if self.below(2) == 0 { 1.0 } else { -1.0 }
    }

    /// A number of 53 random bits, or of few.
    fn number(&mut self, most: i32) -> f64 {
        let fraction = if self.below(4) == 0 { self.below(8) << 49 } else { self.bits() >> 12 };
        let significand = 1.0 + fraction as f64 * f64::EPSILON;
        self.sign() * significand * f64::powi(2.0, self.below(2 * most as u64 + 1) as i32 - most)
    }
}

/// A pair, what is counted of it, what it stands for, and the sum of the magnitudes of its terms.
#[derive(Clone)]
struct Known {
    pair: BoundedPair<true>,
    part: Part,
    exact: Float,
    size: Float,
}

impl Known {
    fn operand(value: f64) -> Self {
        let exact = Float::with_val(BITS, value);
        let pair = BoundedPair { high: value, low: 0.0, size: value.abs() };
        Known { pair, part: Part::OPERAND, size: exact.clone().abs(), exact }
    }

    /// A pair that is as far off as its counts allow.
    fn at_an_end(random: &mut Random) -> Self {
        let high = random.number(20);
        let low_count = [0, 1, 2, 5, 20][random.below(5) as usize];
        if low_count == 0 {
            return Self::operand(high);
        }
        let (low_count, error_count) = (f64::from(low_count), [0, 3, 40][random.below(3) as usize].into());
        let size = high.abs() * f64::powi(2.0, random.below(20) as i32);
        let least = 1.0 - random.below(3) as f64 / 8.0;
        let low = random.sign() * low_count * UNIT * size * least;
        let error = random.sign() * error_count * UNIT * UNIT * size;
        let exact = Float::with_val(BITS, high) + low + error;
        let part = Part { low: low_count, error: error_count };
        Known { pair: BoundedPair { high, low, size }, part, exact, size: Float::with_val(BITS, size) }
    }

    fn is_operand(&self) -> bool {
        self.part == Part::OPERAND
    }

    fn sum(&self, other: &Self) -> Self {
        let pair = match (self.is_operand(), other.is_operand()) {
            (true, true) => BoundedPair::two_sum(self.pair.high, other.pair.high),
            (false, true) => self.pair + other.pair.high,
            (true, false) => other.pair + self.pair.high,
            (false, false) => self.pair + other.pair,
        };
        let exact = Float::with_val(BITS, &self.exact + &other.exact);
        Known { pair, part: self.part.sum(other.part), exact, size: Float::with_val(BITS, &self.size + &other.size) }
    }

    fn product(&self, other: &Self) -> Self {
        let pair = match (self.is_operand(), other.is_operand()) {
            (true, true) => BoundedPair::two_product(self.pair.high, other.pair.high),
            (false, true) => self.pair * other.pair.high,
            (true, false) => other.pair * self.pair.high,
            (false, false) => self.pair * other.pair,
        };
        let exact = Float::with_val(BITS, &self.exact * &other.exact);
        let size = Float::with_val(BITS, &self.size * &other.size);
        Known { pair, part: self.part.product(other.part), exact, size }
    }

    /// The product with a power of two, which changes no count.
    fn scaled(&self, power: f64) -> Self {
        let pair = match self.is_operand() {
            true => BoundedPair::scaled(self.pair.high, power),
            false => self.pair.times_power(power),
        };
        let [exact, size] = [&self.exact, &self.size].map(|number| Float::with_val(BITS, number * power));
        Known { pair, part: self.part, exact, size: size.abs() }
    }

    fn value(&self) -> Float {
        Float::with_val(BITS, self.pair.high) + self.pair.low
    }

    /// Its low part and its error, as shares of what they may be.
    fn shares(&self) -> [f64; 2] {
        let unit = Float::with_val(BITS, &self.size * UNIT);
        let error = (self.value() - &self.exact).abs();
        let low = (Float::with_val(BITS, self.pair.low.abs()) / &unit).to_f64() / self.part.low;
        let error = (error / (unit * UNIT)).to_f64();
        [low, if error == 0.0 { 0.0 } else { error / self.part.error }]
    }
}

#[test]
fn each_operation_keeps_its_counts_and_comes_near_them() {
    let mut random = Random::new(0x9e37_79b9_7f4a_7c15);
    let mut largest = [[0.0_f64; 2]; 2];
    for _ in 0..200_000 {
        let (a, b) = (Known::at_an_end(&mut random), Known::at_an_end(&mut random));
        for (largest, result) in largest.iter_mut().zip([a.sum(&b), a.product(&b)]) {
            let shares = result.shares();
            assert!(shares.iter().all(|share| *share <= MARGIN), "{shares:?}: {:?} {:?}", a.pair, b.pair);
            *largest = [largest[0].max(shares[0]), largest[1].max(shares[1])];
        }
    }
    // counts that are needlessly large would show here
    assert!(largest.iter().flatten().all(|share| *share > 0.7), "{largest:?}");
}

#[test]
fn expressions_that_pass_their_rounding_test_are_right_to_a_thousandth_of_a_unit() {
    let mut random = Random::new(0x2545_f491_4f6c_dd1d);
    let [mut passed, mut cancelled] = [0, 0];
    for _ in 0..20_000 {
        let operands: Vec<f64> = (0..4).map(|_| random.number(3)).collect();
        let mut parts: Vec<Known> = operands.iter().map(|value| Known::operand(*value)).collect();
        for _ in 0..random.below(9) + 2 {
            let [a, b] = [0; 2].map(|_| parts[random.below(parts.len() as u64) as usize].clone());
            // near differences: what cancels
            let turned = Known { pair: -b.pair, exact: -b.exact.clone(), ..b.clone() };
            parts.push(match random.below(5) {
                4 => a.scaled(-0.5),
                0 => a.sum(&b),
                1 => a.sum(&turned),
                _ => a.product(&b),
            });
        }
        let Some(result) = parts.pop().filter(|part| !part.is_operand()) else { continue };
        let shares = result.shares();
        assert!(shares.iter().all(|share| share.is_nan() || *share <= MARGIN), "{shares:?} of {operands:?}");
        if !result.pair.passes(threshold(result.part.error())) {
            cancelled += 1;
            continue;
        }
        passed += 1;
        let off = (result.value() - &result.exact).abs();
        let allowed = Float::with_val(BITS, result.exact.abs_ref()) * (UNIT / 1000.0);
        assert!(off <= allowed, "{off:e} of {operands:?}");
    }
    assert!(passed > 10_000 && cancelled > 100, "{passed} {cancelled}");
}

#[test]
fn zeros_pass_where_they_are_exact_and_are_positive() {
    let product = Part::OPERAND.product(Part::OPERAND);
    let sum_of_products = threshold(product.sum(product).error());
    let of_zeros = BoundedPair::<false>::two_product(0.0, -3.0) + BoundedPair::two_product(-0.0, 5.0);
    assert!(of_zeros.passes(sum_of_products) && of_zeros.round().to_bits() == 0);
    assert!((-of_zeros).value().round().to_bits() == 0);
    let cancelled = BoundedPair::<false>::two_product(3.0, 5.0) + BoundedPair::two_product(-3.0, 5.0);
    assert!(!cancelled.passes(sum_of_products));
    // an error that underflows is an error
    assert!(!BoundedPair::<true>::two_product(1e-200, 1e-200).passes(threshold(product.error())));

    let difference = Part::OPERAND.sum(Part::OPERAND);
    assert!(BoundedPair::<false>::two_sum(2.0, -2.0).passes(threshold(difference.error())));
    assert!(!BoundedPair::<true>::two_sum(f64::INFINITY, -f64::INFINITY).passes(threshold(difference.error())));
    assert_eq!(threshold(difference.scaled(4.0).error()), threshold(0.0));
    assert!(threshold(difference.scaled(0.5).error()) > 0.0);
}
