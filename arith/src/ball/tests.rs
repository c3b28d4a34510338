//! Balls hold the exact values, operation by operation, at operands of all sizes.

extern crate std;

mod ends;

use core::cmp::Ordering;
use std::vec::Vec;

use rug::float::Constant;
use rug::ops::Pow;
use rug::{Float, Integer};

use super::limbs::Limbs;
use super::radius::Radius;
use super::{Ball, Decisions, Kind, Separation};
use crate::function::Function;
use crate::real::Real;

/// More bits than any sum of two operands has.
const BITS: u32 = 12_000;

fn float_of<const L: usize>(number: &Limbs<L>) -> Float {
    let (negative, words, exponent) = number.parts();
    let integer = words.iter().rev().fold(Integer::new(), |integer, word| (integer << 64) + *word);
    let float = Float::with_val(BITS, integer) << i32::try_from(exponent - 64 * L as i64).unwrap();
    if negative { -float } else { float }
}

/// Whether the value lies in the ball.
fn holds<const L: usize>(ball: &Ball<L>, exact: &Float) -> bool {
    let (value, exponent) = ball.radius.parts();
    let radius = Float::with_val(BITS, value) << i32::try_from(exponent).unwrap();
    Float::with_val(BITS, float_of(&ball.middle) - exact).abs() <= radius
}

/// Numbers that follow no pattern, and patterns that carry, cancel and lie side by side.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 ^ self.0 >> 31).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    }

    fn below(&mut self, count: u64) -> u64 {
        (self.next() >> 11) % count
    }

    fn word(&mut self) -> u64 {
        match self.below(6) {
            0 => 0,
            1 => u64::MAX,
            2 => 1 << 63,
            3 => self.below(4),
            _ => self.next(),
        }
    }

    /// A ball, and a value in it: in the middle, at an end or in between.
    fn ball<'a, const L: usize>(&mut self, decisions: &'a Decisions) -> (Ball<'a, L>, Float) {
        let words: Vec<u64> = (0..L).map(|_| self.word()).collect();
        let range = [400, 400, 4_000][self.below(3) as usize];
        let exponent = self.below(range) as i64 - range as i64 / 2;
        let (middle, _) = Limbs::<L>::from_fraction(exponent, &words);
        let middle = if self.below(2) == 0 { middle.negated() } else { middle };
        let radius = match self.below(3) {
            0 => Radius::ZERO,
            _ => Radius::new(1.0 + self.below(1 << 20) as f64 / (1 << 20) as f64, exponent - self.below(300) as i64),
        };
        let ball = Ball { middle, radius, ..Ball::new(0.0, decisions) }.without_separation();
        let (value, power) = radius.parts();
        let radius = Float::with_val(BITS, value) << i32::try_from(power).unwrap();
        let part = Float::with_val(BITS, self.below(5)) / 2 - 1u32;
        let inside = float_of(&ball.middle) + radius * part;
        (ball, inside)
    }

    /// A second ball, sometimes so near that the difference cancels.
    fn near<'a, const L: usize>(&mut self, of: &Ball<'a, L>) -> (Ball<'a, L>, Float) {
        if self.below(3) != 0 {
            return self.ball(of.decisions);
        }
        let step =
            Limbs::from_integer(false, 1 + self.below(3), of.middle.exponent() - 64 * L as i64 + self.below(70) as i64);
        let (middle, _) = of.middle.plus(step);
        let ball = Ball { middle, radius: Radius::ZERO, number: of.decisions.next(), ..of.clone() };
        let value = float_of(&ball.middle);
        (ball, value)
    }
}

fn operations_hold<const L: usize>(rounds: u32, seed: u64) {
    let decisions = Decisions::default();
    let mut random = Random(seed);
    let (mut quotients, mut values) = (0, 0);
    for round in 0..rounds {
        let (a, x) = random.ball::<L>(&decisions);
        let (b, y) = random.near(&a);
        assert!(holds(&a.plus(&b), &Float::with_val(BITS, &x + &y)), "sum, {round}");
        assert!(holds(&a.plus(&b.negated()), &Float::with_val(BITS, &x - &y)), "difference, {round}");
        assert!(holds(&a.times(&b), &Float::with_val(BITS, &x * &y)), "product, {round}");
        assert!(holds(&a.magnitude(), &x.clone().abs()), "magnitude, {round}");
        let (larger, smaller) = (a.extreme(&b, Ordering::Greater), a.extreme(&b, Ordering::Less));
        assert!(holds(&larger, &x.clone().max(&y)), "larger, {round}");
        assert!(holds(&smaller, &x.clone().min(&y)), "smaller, {round}");
        let quotient = a.over(&b);
        if quotient.kind == Kind::Number {
            quotients += 1;
            assert!(holds(&quotient, &Float::with_val(BITS, &x / &y)), "quotient, {round}");
        }
        for function in Function::ALL {
            let is_power = function.is_power();
            // MPFR takes a millisecond for each of the others
            if !is_power && round % 100 != 0 {
                continue;
            }
            let value = a.call(function);
            let mut exact = x.clone();
            function.mpfr(&mut exact);
            if value.kind == Kind::Number && value.middle.exponent().abs() < 1 << 30 && exact.is_finite() {
                values += 1;
                assert!(holds(&value, &exact), "{function:?}, {round}");
            }
            assert!(value.kind != Kind::Unknown || !function.is_total() || !is_power, "{function:?}, {round}");
        }
        if let Some(order) = a.partial_cmp(&b) {
            assert_eq!(Some(order), x.partial_cmp(&y), "order, {round}");
        }
    }
    assert!(quotients > rounds / 3 && values > 2 * rounds, "{quotients} quotients and {values} values of {rounds}");
}

#[test]
fn balls_hold_what_operations_give() {
    operations_hold::<1>(20_000, 1);
    operations_hold::<2>(20_000, 2);
    operations_hold::<4>(20_000, 3);
    operations_hold::<16>(2_000, 4);
    operations_hold::<64>(200, 5);
}

/// The digits, in bits, that elementary functions of exact ordinary numbers keep.
fn kept<const L: usize>(function: Function, x: f64) -> i64 {
    let decisions = Decisions::default();
    let value = Ball::<L>::new(x, &decisions).call(function);
    assert_eq!(value.kind, Kind::Number, "{function:?} of {x}");
    value.middle.exponent() - value.radius.parts().1
}

#[test]
fn elementary_functions_lose_few_digits() {
    for function in Function::ALL.into_iter().filter(|function| !function.is_power() && !function.has_steps()) {
        for x in
            [0.9, 0.5, 0.3, 1e-3, 2.2e-300, 1.0 - 1e-15].into_iter().filter(|x| function.properties().domain.holds(*x))
        {
            // 50 bits go where a logarithm is that near to 0, up to 32 by squaring
            for (words, kept) in
                [(4, kept::<4>(function, x)), (16, kept::<16>(function, x)), (64, kept::<64>(function, x))]
            {
                assert!(kept >= 64 * words - 100, "{function:?} of {x:e}: {kept} bits of {words} words");
            }
        }
    }
}

/// log(1 + e^x), whose argument is rounded to 1 where there are few words.
fn softplus_holds<const L: usize>(x: f64) {
    let decisions = Decisions::default();
    let [exp, log] = ["exp", "log"].map(|name| Function::named(name).unwrap());
    let one = Ball::<L>::new(1.0, &decisions);
    let found = Ball::<L>::new(x, &decisions).call(exp).plus(&one).call(log);
    let exact = Float::with_val(BITS, x).exp().ln_1p();
    assert!(holds(&found, &exact), "{L} words at {x}: {:?}, {exact:e}", found.accepted());
}

#[test]
fn functions_of_functions_hold() {
    for x in [-460.7507038689, -460.0, -177.5, -30.0, -1e-9, 3.0, 700.0, -5000.0] {
        softplus_holds::<1>(x);
        softplus_holds::<4>(x);
        softplus_holds::<16>(x);
        softplus_holds::<64>(x);
    }
}

#[test]
fn elementary_functions_are_exact_where_they_are_rational() {
    let decisions = Decisions::default();
    let value = |function: &str, x| Ball::<4>::new(x, &decisions).call(Function::named(function).unwrap()).accepted();
    for (function, x, expected) in [
        ("exp", 0.0, 1.0),
        ("log", 1.0, 0.0),
        ("sin", 0.0, 0.0),
        ("cos", 0.0, 1.0),
        ("tan", 0.0, 0.0),
        ("asin", 0.0, 0.0),
        ("acos", 1.0, 0.0),
        ("atan", 0.0, 0.0),
    ] {
        assert_eq!(value(function, x), Some((expected, true)), "{function}({x})");
    }
}

#[test]
fn balls_of_exact_operands_are_small() {
    let decisions = Decisions::default();
    let mut random = Random(6);
    for _ in 0..5_000 {
        let number = |random: &mut Random| {
            let value = 1.0 + random.below(1 << 52) as f64 / (1_u64 << 52) as f64;
            Ball::<4>::new(value, &decisions)
        };
        let (a, b) = (number(&mut random), number(&mut random));
        for (result, what) in [(a.over(&b), "quotient"), (a.call(Function::Sqrt), "root"), (a.times(&b), "product")] {
            let unit = result.middle.exponent() - 64 * 4;
            assert!(result.radius.is_less_than(0.5, unit + 5), "{what}: {:?}", result.radius);
        }
        assert!(a.times(&b).radius.is_zero() && a.plus(&b).radius.is_zero(), "106 bits are exact");
    }
}

#[test]
fn the_circle_constant_is_right_to_all_words() {
    let decisions = Decisions::default();
    let pi = Ball::<64>::new(1.0, &decisions).pi();
    assert!(holds(&pi, &Float::with_val(BITS, Constant::Pi)));
    assert!(pi.radius.is_less_than(0.5, 4 - 64 * 64));
}

#[test]
fn numbers_round_as_the_processor_rounds() {
    let decisions = Decisions::default();
    let mut random = Random(7);
    for _ in 0..20_000 {
        let (a, b) = (f64::from_bits(random.next()), f64::from_bits(random.next()));
        if a.is_finite() && b.is_finite() {
            let (x, y) = (Ball::<4>::new(a, &decisions), Ball::<4>::new(b, &decisions));
            assert_eq!(x.accepted(), Some((a, true)));
            let (product, _) = x.times(&y).accepted().unwrap();
            assert!(product == a * b || product.is_infinite(), "{a:e} * {b:e}");
        }
    }
}

/// The sum of the roots of the first two numbers less those of the others.
fn four_roots<'a, const L: usize>(numbers: [f64; 4], decisions: &'a Decisions) -> Ball<'a, L> {
    let [a, b, c, d] = numbers.map(|x| Ball::<L>::new(x, decisions).call(Function::Sqrt));
    a.plus(&b).plus(&c.negated()).plus(&d.negated())
}

#[test]
fn what_is_exactly_zero_is_shown_to_be() {
    let decisions = Decisions::default();
    for numbers in [[2.0, 3.0, 3.0, 2.0], [0.1, 7.3, 7.3, 0.1], [1e10, 3e-5, 3e-5, 1e10], [8.0, 2.0, 18.0, 0.0]] {
        assert_eq!(four_roots::<64>(numbers, &decisions).accepted(), Some((0.0, true)), "{numbers:?}");
    }
    // (sqrt(2) + sqrt(3))^2 - 5 - 2 sqrt(6), and 1/3 + 1/3 + 1/3 - 1
    let number = |x| Ball::<16>::new(x, &decisions);
    let sum = number(2.0).call(Function::Sqrt).plus(&number(3.0).call(Function::Sqrt));
    let rest = number(5.0).plus(&number(24.0).call(Function::Sqrt));
    assert_eq!(sum.times(&sum).plus(&rest.negated()).accepted(), Some((0.0, true)));
    let third = number(1.0).over(&number(3.0));
    assert_eq!(third.plus(&third).plus(&third).plus(&number(-1.0)).accepted(), Some((0.0, true)));
}

#[test]
fn a_value_is_equal_to_itself() {
    let decisions = Decisions::default();
    let pi = Ball::<4>::new(1.0, &decisions).pi();
    assert_eq!(pi.partial_cmp(&pi.clone()), Some(Ordering::Equal));
    assert_eq!(pi.partial_cmp(&Ball::<4>::new(1.0, &decisions).pi()), None, "another value");
    let nothing = Ball::<4>::new(-1.0, &decisions).call(Function::Sqrt);
    assert_eq!(nothing.partial_cmp(&nothing.clone()), None);
}

#[test]
fn what_is_nearly_zero_is_not_taken_for_zero() {
    // sqrt(a) + sqrt(b) - sqrt(c) - sqrt(d) at integers where it is small, and at the neighbours of where it vanishes
    let decisions = Decisions::default();
    let next = 7.3_f64.next_up();
    for numbers in [[0.1, 7.3, next, 0.1], [1e10, 3e-5, 3e-5, 1e10_f64.next_down()], [10.0, 11.0, 5.0, 18.0]] {
        let exact = numbers.map(|x| Float::with_val(BITS, x).sqrt());
        let exact = Float::with_val(BITS, &exact[0] + &exact[1]) - &exact[2] - &exact[3];
        let (found, _) = four_roots::<64>(numbers, &decisions).accepted().unwrap();
        assert_eq!(found, exact.to_f64(), "{numbers:?}");
        assert!(found != 0.0);
    }
}

/// The bound must hold for every value that is not zero: the powers of sqrt(2) - 1 come near it.
#[test]
fn separation_bounds_hold() {
    let decisions = Decisions::default();
    let one = Ball::<64>::new(1.0, &decisions);
    let small = Ball::<64>::new(2.0, &decisions).call(Function::Sqrt).plus(&one.negated());
    let mut power = one.clone();
    for exponent in 1..200 {
        power = power.times(&small);
        let least = power.separation.and_then(Separation::least).unwrap();
        let exact = (Float::with_val(BITS, 2).sqrt() - 1u32).pow(exponent);
        assert!(Float::with_val(BITS, exact) >= Float::with_val(BITS, 1) << i32::try_from(least).unwrap());
    }
}

/// Of roots of several degrees: (sqrt(2) + cbrt(3))^2 - 2 - cbrt(9) - 2 sqrt(2) cbrt(3) is zero, and with another last
/// number it is not.
#[test]
fn sums_of_roots_of_several_degrees_are_zero_or_not() {
    let decisions = Decisions::default();
    for (last, vanishes) in [(3.0, true), (3.0_f64.next_up(), false)] {
        let number = |x| Ball::<64>::new(x, &decisions);
        let root = |degree, x| number(x).call(Function::root(degree).unwrap());
        let (two, three) = (root(2, 2.0), root(3, 3.0));
        let square = two.plus(&three).times(&two.plus(&three));
        let doubled = number(2.0).times(&two).times(&root(3, last));
        let rest = square.plus(&number(-2.0)).plus(&root(3, 9.0).negated()).plus(&doubled.negated());
        let expected = if vanishes { Ordering::Equal } else { Ordering::Less };
        assert_eq!(rest.partial_cmp(&number(0.0)), Some(expected));
    }
    assert!(!decisions.is_undecided());
}

/// The same of cube roots: the powers of 2 - cbrt(7) come near zero.
#[test]
fn separation_bounds_hold_of_cube_roots() {
    let decisions = Decisions::default();
    let root = Ball::<64>::new(7.0, &decisions).call(Function::root(3).unwrap());
    let small = Ball::new(2.0, &decisions).plus(&root.negated());
    let mut power = Ball::new(1.0, &decisions);
    for exponent in 1..100 {
        power = power.times(&small);
        let least = power.separation.and_then(Separation::least).unwrap();
        let exact = (Float::with_val(BITS, 2) - Float::with_val(BITS, 7).cbrt()).pow(exponent);
        assert!(Float::with_val(BITS, exact) >= Float::with_val(BITS, 1) << i32::try_from(least).unwrap());
    }
}

/// As many roots as there are make it smaller, and so do divisors.
#[test]
fn separation_bounds_hold_of_many_roots_and_of_quotients() {
    let decisions = Decisions::default();
    let below = |ball: &Ball<64>, exact: Float| {
        let least = ball.separation.and_then(Separation::least).unwrap();
        assert!(exact.abs() >= Float::with_val(BITS, 1) << i32::try_from(least).unwrap(), "{least}");
    };
    for numbers in [[10.0, 11.0, 5.0, 18.0], [2.0, 37.0, 15.0, 13.0], [1e6, 1e6 + 3.0, 1e6 + 1.0, 1e6 + 2.0]] {
        let exact = numbers.map(|x| Float::with_val(BITS, x).sqrt());
        below(&four_roots(numbers, &decisions), Float::with_val(BITS, &exact[0] + &exact[1]) - &exact[2] - &exact[3]);
    }
    for divisor in [3.0, 5.0, 7.0, 1e15 + 37.0] {
        let quotient = Ball::<64>::new(1.0, &decisions).over(&Ball::new(divisor, &decisions));
        let near = Ball::new(1.0 / divisor, &decisions);
        below(&quotient.plus(&near.negated()), Float::with_val(BITS, 1) / divisor - 1.0 / divisor);
    }
}

#[test]
fn what_has_no_value_and_what_is_unknown_are_told_apart() {
    let decisions = Decisions::default();
    let number = |x| Ball::<4>::new(x, &decisions);
    assert_eq!(number(-1.0).call(Function::Sqrt).kind, Kind::Nothing);
    assert_eq!(number(1.0).over(&number(0.0)).kind, Kind::Nothing);
    // a sum with pi that the circle constant's bits do not tell from zero
    let pi = number(1.0).pi();
    let rest = pi.plus(&pi.negated());
    assert_eq!((rest.call(Function::Sqrt).kind, number(1.0).over(&rest).kind), (Kind::Unknown, Kind::Unknown));
    assert!(!decisions.is_undecided());
    assert_eq!(rest.partial_cmp(&number(0.0)), None);
    assert!(decisions.is_undecided());
    assert_eq!(Ball::<4>::new(f64::NAN, &decisions).accepted().map(|(value, _)| value.is_nan()), Some(true));
}

#[test]
fn roots_of_polynomials_are_enclosed() {
    let decisions = Decisions::default();
    let mut random = Random(8);
    for _ in 0..300 {
        let degree = 1 + random.below(16) as usize;
        let turn = 1 + random.below(degree as u64) as usize;
        let coefficients: Vec<f64> = (0..=degree)
            .map(|power| {
                let size =
                    (1.0 + random.below(1 << 30) as f64 / (1 << 30) as f64) * 2_f64.powi(random.below(80) as i32 - 40);
                if power < turn { -size } else { size }
            })
            .collect();
        let balls: Vec<Ball<16>> = coefficients.iter().map(|c| Ball::new(*c, &decisions)).collect();
        let root = balls[0].positive_root(&balls);
        let (found, _) = root.accepted().unwrap();
        // the polynomial changes sign between the ends of the ball, and between the neighbours of what is rounded
        let sign = |x: Float| coefficients.iter().rev().fold(Float::new(BITS), |sum, c| sum * &x + *c);
        let changes = |below: Float, above: Float| sign(below) < 0 && sign(above) > 0;
        let (value, exponent) = root.radius.parts();
        let radius = Float::with_val(BITS, value) << i32::try_from(exponent).unwrap();
        let middle = float_of(&root.middle);
        assert!(changes(Float::with_val(BITS, &middle - &radius), middle + radius), "{coefficients:?}");
        let [below, above] = [found.next_down(), found.next_up()].map(|x| Float::with_val(BITS, x));
        assert!(changes(below, above), "{coefficients:?}");
    }
}
