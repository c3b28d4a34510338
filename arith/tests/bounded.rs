//! Numbers that bound their own errors, against MPFR: operation by operation at the ends of their intervals, and in expressions.
//!
//! Random expressions do not find a bound that lacks a rounding or two: their errors never all point the same way. So operations
//! are judged one by one, with operands that are as wrong as they may be.

#![cfg(feature = "mpfr")]

#[path = "common/random.rs"]
mod random;

use std::cell::Cell;

use closedform_arith::error_model::UNIT;
use closedform_arith::{Bounded, Function, Real, Signs};
use random::Random;
use rug::Float;
use rug::ops::Pow;

/// More than the exponents of any two numbers of `f64`, and of their products, are apart.
const BITS: u32 = 4400;

impl Random {
    fn exponent(&mut self, most: u64) -> f64 {
        f64::powi(2.0, self.below(2 * most + 1) as i32 - most as i32)
    }

    fn number(&mut self) -> f64 {
        let significand = 1.0 + (self.bits() >> 12) as f64 * f64::EPSILON;
        let size = match self.below(8) {
            0..=3 => significand * self.exponent(10),
            4 => self.exponent(10),
            5 => significand * self.exponent(500),
            6 => self.below(9) as f64,
            _ => 1.0 + self.below(1000) as f64 * f64::EPSILON,
        };
        if self.below(2) == 0 { size } else { -size }
    }

    /// A count and an error for a number.
    fn errors(&mut self, value: f64) -> (u32, f64) {
        let count = [0, 0, 1, 2, 17, 300][self.below(6) as usize];
        let error = match self.below(4) {
            0 | 1 => 0.0,
            2 => value.abs() * UNIT * (1 + self.below(10)) as f64,
            _ => value.abs() * self.exponent(60).min(1.0),
        };
        (count, error)
    }
}

/// A number, and what it stands for: an end of its interval.
struct Operand<'a, const WATCHED: bool> {
    number: Bounded<'a, WATCHED>,
    exact: Float,
}

fn operand<'a, const WATCHED: bool>(value: f64, random: &mut Random, escalate: &'a Cell<bool>) -> Operand<'a, WATCHED> {
    let (count, error) = random.errors(value);
    let signs = match value {
        _ if random.below(2) == 0 => Signs::ANY,
        _ if value >= 0.0 => Signs::NOT_NEGATIVE,
        _ => Signs::NOT_POSITIVE,
    };
    let number = Bounded::with_error(value, count, error, signs, escalate);
    let most = Float::with_val(BITS, 1.0 + Float::with_val(BITS, UNIT)).pow(count);
    let factor = if random.below(2) == 0 { most } else { 2 - most };
    let error = if random.below(2) == 0 { error } else { -error };
    Operand { number, exact: Float::with_val(BITS, value) * factor + error }
}

/// What a bound is of the true error; `None` where the number escalates or has no bound. A promise that it keeps is true.
fn share<const WATCHED: bool>(found: Bounded<'_, WATCHED>, exact: &Float, escalate: &Cell<bool>) -> Option<f64> {
    let bound = found.bound();
    if escalate.replace(false) || !bound.is_finite() || !found.value().is_finite() {
        return None;
    }
    let error = Float::with_val(BITS, exact - found.value()).abs();
    assert!(error <= bound, "{exact} is {} +- {bound:e}", found.value());
    for promise in [2.0, 4.0, 8.0, 24.0, 900.0, 1e6, 1e12].map(|units| units * UNIT) {
        found.keeping(promise);
        let kept = !escalate.replace(false);
        assert!(!kept || error <= exact.clone().abs() * promise, "{exact} is {} but for {promise:e}", found.value());
    }
    Some(if bound == 0.0 { 0.0 } else { (error / bound).to_f64() })
}

/// The largest share of its bound that the error of an operation has, and how often it has one.
fn judge<const WATCHED: bool>(
    operation: impl for<'a> Fn(&Bounded<'a, WATCHED>, &Bounded<'a, WATCHED>) -> Bounded<'a, WATCHED>,
    exactly: impl Fn(&Float, &Float) -> Float,
) -> (f64, u32) {
    let (mut random, escalate) = (Random::new(88_172_645_463_325_252), Cell::new(false));
    let (mut largest, mut judged) = (0.0_f64, 0);
    for _ in 0..60_000 {
        let (first, second) = (random.number(), random.number());
        // what cancels most
        let second = if random.below(4) == 0 { -first } else { second };
        let (a, b) = (operand(first, &mut random, &escalate), operand(second, &mut random, &escalate));
        let found = operation(&a.number, &b.number);
        if let Some(share) = share(found, &exactly(&a.exact, &b.exact), &escalate) {
            (largest, judged) = (largest.max(share), judged + 1);
        }
    }
    (largest, judged)
}

/// Every operation, in one of the two ways, keeps its bounds and comes near to them.
fn judge_all<const WATCHED: bool>() {
    let demand = |name, near: f64, (largest, judged): (f64, u32)| {
        assert!(judged > 15_000 && largest > near, "{name}: {judged} judged, {largest} of the bound at most");
    };
    demand("sum", 0.999, judge::<WATCHED>(|a, b| a.add(b), |a, b| Float::with_val(BITS, a + b)));
    demand("difference", 0.999, judge::<WATCHED>(|a, b| a.sub(b), |a, b| Float::with_val(BITS, a - b)));
    demand("product", 0.999, judge::<WATCHED>(|a, b| a.mul(b), |a, b| Float::with_val(BITS, a * b)));
    demand("quotient", 0.9, judge::<WATCHED>(|a, b| a.div(b), |a, b| Float::with_val(BITS, a / b)));
    let of_sum = judge::<WATCHED>(|a, b| a.add(b).mul(b), |a, b| Float::with_val(BITS, a + b) * b);
    demand("product of a sum", 0.99, of_sum);
    let root = judge::<WATCHED>(|a, _| a.call(Function::Abs).call(Function::Sqrt), |a, _| a.clone().abs().sqrt());
    demand("root", 0.3, root);
    demand("cube root", 0.3, judge::<WATCHED>(|a, _| a.call(Function::Cbrt), |a, _| a.clone().cbrt()));
}

#[test]
fn operations_keep_their_bounds_where_each_step_is_watched() {
    judge_all::<true>();
}

#[test]
fn operations_keep_their_bounds_at_ordinary_magnitudes() {
    judge_all::<false>();
}

#[test]
fn elementary_functions_keep_their_bounds() {
    for function in Function::ALL.into_iter().filter(|function| !function.is_power() && !function.has_steps()) {
        let (mut random, escalate) = (Random::new(88_172_645_463_325_252), Cell::new(false));
        let (mut largest, mut judged) = (0.0_f64, 0);
        for at in 0..4_000 {
            let size = f64::powi(2.0, at % 24 - 18) * (1.0 + random.below(1 << 20) as f64 / f64::from(1 << 20));
            let value = if random.below(2) == 0 { size } else { -size };
            if !function.properties().domain.holds(value) {
                continue;
            }
            let argument = operand::<true>(value, &mut random, &escalate);
            let mut exact = argument.exact;
            function.mpfr(&mut exact);
            if let Some(share) = share(argument.number.call(function), &exact, &escalate) {
                (largest, judged) = (largest.max(share), judged + 1);
            }
        }
        assert!(judged > 500 && largest > 0.3, "{function:?}: {judged} judged, {largest} of the bound at most");
    }
}

#[test]
fn integers_are_right_or_escalate() {
    for function in Function::ALL.into_iter().filter(|function| function.has_steps()) {
        let (mut random, escalate) = (Random::new(88_172_645_463_325_252), Cell::new(false));
        let (mut judged, mut left) = (0, 0);
        for _ in 0..20_000 {
            // near multiples of 1/2, and anywhere
            let near =
                (random.below(40) as f64 - 20.0) / 2.0 + random.exponent(60).min(0.5) * (random.below(3) as f64 - 1.0);
            let value = if random.below(4) == 0 { random.number() } else { near };
            let argument = operand::<true>(value, &mut random, &escalate);
            let mut exact = argument.exact;
            function.mpfr(&mut exact);
            let found = argument.number.call(function);
            if escalate.replace(false) {
                left += 1;
            } else {
                assert_eq!((found.value(), found.bound()), (exact.to_f64(), 0.0), "{function:?} of {value:e}");
                judged += 1;
            }
        }
        assert!(judged > 8_000 && left > 2_000, "{function:?}: {judged} judged, {left} left");
    }
}

#[test]
fn comparisons_are_right_or_escalate() {
    let (mut random, escalate) = (Random::new(2_463_534_242), Cell::new(false));
    let mut decided = 0;
    for _ in 0..100_000 {
        let first = random.number();
        let second = if random.below(3) == 0 { first } else { random.number() };
        let (a, b) = (operand::<true>(first, &mut random, &escalate), operand(second, &mut random, &escalate));
        let found = (a.number < b.number, a.number <= b.number, a.number == b.number);
        if !escalate.replace(false) {
            decided += 1;
            assert_eq!(found, (a.exact < b.exact, a.exact <= b.exact, a.exact == b.exact), "{first:e} {second:e}");
        }
    }
    assert!(decided > 40_000, "{decided}");
}

#[test]
fn expressions_keep_their_bounds() {
    let (mut random, escalate) = (Random::new(362_436_069), Cell::new(false));
    let (mut judged, mut largest) = (0, 0.0_f64);
    for _ in 0..10_000 {
        let mut numbers: Vec<_> = (0..3)
            .map(|_| random.number())
            .map(|x| (Bounded::<true>::new(x, Signs::ANY, &escalate), Float::with_val(BITS, x)))
            .collect();
        for _ in 0..2 + random.below(8) {
            let ((a, x), (b, y)) = (&numbers[numbers.len() - 1], &numbers[random.below(numbers.len() as u64) as usize]);
            let next = match random.below(6) {
                0 | 1 => (a.add(b), Float::with_val(BITS, x + y)),
                2 => (a.sub(b), Float::with_val(BITS, x - y)),
                3 => (a.mul(b), Float::with_val(BITS, x * y)),
                4 => (a.div(b), Float::with_val(BITS, x / y)),
                _ => (a.call(Function::Sqrt), x.clone().sqrt()),
            };
            numbers.push(next);
        }
        let (found, exact) = &numbers[numbers.len() - 1];
        if let Some(share) = share(*found, exact, &escalate) {
            (judged, largest) = (judged + 1, largest.max(share));
        }
    }
    assert!(judged > 1_500 && largest > 0.5, "{judged} {largest}");
}

#[test]
fn roots_of_polynomials_are_enclosed() {
    let (mut random, escalate) = (Random::new(521_288_629), Cell::new(false));
    let mut judged = 0;
    for _ in 0..3_000 {
        let degree = 1 + random.below(6) as usize;
        let coefficients: Vec<_> = (0..=degree)
            .map(|power| {
                let size = random.number().abs().clamp(1e-3, 1e3);
                let value = if power == 0 { -size } else { size };
                let (count, error) = (random.below(3) as u32, [0.0, UNIT * value.abs()][random.below(2) as usize]);
                let number = Bounded::<true>::with_error(value, count, error, Signs::ANY, &escalate);
                let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
                (number, Float::with_val(400, value) + sign * (error + f64::from(count) * UNIT * value.abs() * 0.999))
            })
            .collect();
        let numbers: Vec<_> = coefficients.iter().map(|(number, _)| *number).collect();
        let root = numbers[0].positive_root(&numbers);
        if escalate.replace(false) {
            continue;
        }
        judged += 1;
        let at = |x: f64| coefficients.iter().rev().fold(Float::new(400), |value, (_, c)| value * x + c);
        assert!(at(root.value() - root.bound()) <= 0.0 && at(root.value() + root.bound()) >= 0.0);
        assert!(root.bound() <= 100.0 * UNIT * root.value());
    }
    assert!(judged > 2_500, "{judged}");
}

#[test]
fn what_has_no_value_escalates() {
    let escalate = Cell::new(false);
    let number = |value| Bounded::<false>::new(value, Signs::ANY, &escalate);
    let escalates = |_: Bounded<'_, false>| escalate.replace(false);
    assert!(escalates(number(1.0).div(&number(0.0))));
    assert!(escalates(number(-1.0).call(Function::Sqrt)));
    assert!(escalates(number(1.0).nan()));
    assert!(!escalates(number(1.0).div(&number(3.0))));
    let watched = |value| Bounded::<true>::new(value, Signs::ANY, &escalate);
    let escalates = |_: Bounded<'_, true>| escalate.replace(false);
    assert!(escalates(watched(1e-200).mul(&watched(1e-200))));
    assert!(escalates(watched(1e200).mul(&watched(1e200))));
    assert!(!escalates(watched(0.0).mul(&watched(1e-200))));
}

#[test]
fn promises_that_are_kept_are_not_needlessly_large() {
    let (mut random, escalate) = (Random::new(1_597_334_677), Cell::new(false));
    let (mut largest, mut kept) = (0.0_f64, 0);
    for _ in 0..40_000 {
        let value = 1.0 + random.below(1 << 20) as f64 * UNIT;
        let (error, factor) = ((1 + random.below(1 << 20)) as f64 * UNIT, random.number());
        let number = Bounded::<false>::with_error(value, 0, error, Signs::POSITIVE, &escalate);
        let other = Bounded::<false>::new(factor, Signs::ANY, &escalate);
        let divides = random.below(2) == 0;
        let found = if divides { number.div(&other) } else { number.mul(&other) };
        let most = Float::with_val(BITS, value) + error;
        let exact = if divides { most / factor } else { most * factor };
        let promise = (error + 3.0 * UNIT) * 1.000_001;
        found.keeping(promise);
        if escalate.replace(false) || exact.is_zero() {
            continue;
        }
        let off = Float::with_val(BITS, &exact - found.value()).abs() / exact.abs();
        assert!(off <= promise);
        (largest, kept) = (largest.max(off.to_f64() / promise), kept + 1);
    }
    assert!(kept > 30_000 && largest > 0.99, "{kept} kept, {largest} of the promise at most");
}

#[test]
fn signs_that_a_program_tells_decide_comparisons_with_zero() {
    let escalate = Cell::new(false);
    let number = |value, signs| Bounded::<false>::with_error(value, 1, 1.0, signs, &escalate);
    let zero = number(0.0, Signs::ANY).literal(0.0);
    let (above, below) = (number(1.0, Signs::POSITIVE), number(-1.0, Signs::NOT_POSITIVE));
    assert_eq!([above > zero, zero < above, above >= zero, below <= zero, zero >= below], [true; 5]);
    assert!(!escalate.replace(false));
    let _ = (below < zero, zero > below);
    assert!(escalate.replace(false), "it may be zero");
    let _ = number(1.0, Signs::ANY) > zero;
    assert!(escalate.replace(false), "its error is as large as it is");
}

#[test]
fn a_promise_is_kept_or_escalates() {
    let escalate = Cell::new(false);
    let number = |error| Bounded::<true>::with_error(1.0, 3, error, Signs::ANY, &escalate);
    let kept = |error, promise| (number(error).keeping(promise), !escalate.replace(false)).1;
    assert!(kept(0.0, 4.0 * UNIT) && !kept(0.0, 2.0 * UNIT));
    assert!(kept(1e-14, 1e-13) && !kept(1e-13, 1e-13) && !kept(f64::INFINITY, 1e-13) && !kept(f64::NAN, 1e-13));
}
