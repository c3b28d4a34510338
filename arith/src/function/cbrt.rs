//! The real cube root, of numbers of any sign.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::{DoubleDouble, DoubleDoubleWith};
use crate::error_model::{CUBE_ROOT, double_double};
use crate::range::power_of_two;
use crate::soft_float::SoftFloat;

/// The real cube root: the real number whose cube is the argument.
pub(super) struct Cbrt;

/// What it takes in `f64`: two divisions and some forty additions and multiplications.
const IN_DOUBLE: u32 = 2 * Cost::DIVISION + 40;

impl Definition for Cbrt {
    const PROPERTIES: Properties = Properties {
        name: "cbrt",
        noun: "cube root",
        maxima: "x^(1/3)",
        exponent: Some((1, 3)),
        domain: Domain::All,
        signs: [signs::NEGATIVE, signs::ZERO, signs::POSITIVE],
        parity: Parity::Odd,
        increases: true,
        derivative: Some("1.0 / (3.0 * y * y)"),
        error: CUBE_ROOT,
        double_double_error: double_double::CUBE_ROOT,
        cost: Cost { double: IN_DOUBLE, double_double: IN_DOUBLE + Cost::DIVISION + 60, ball: 1_700 },
    };

    /// Arithmetic that rounds once an operation, and bits: the same on every machine. See [`of_reduced`] for the error.
    #[inline(always)]
    fn double(x: f64) -> f64 {
        if x == 0.0 || !x.is_finite() {
            return x;
        }
        let (m, third) = reduced(x.abs());
        let root = of_reduced(m) * power_of_two(third.into());
        if x < 0.0 { -root } else { root }
    }

    /// One step of Newton from y, the cube root of the leading part h of x = h + l, with a remainder in double-double.
    ///
    /// In units of u and relative to the root s of x, y is off by at most d = 1.34: by 1.001 from the root of h, which is
    /// off by 1/3 since l is at most u of h. Newton's step leaves d^2 u^2 = 1.8 u^2. The cube of y is off by 1.5 u^2, hence
    /// the root by 0.5 u^2; the remainder is at most 3 d u and is rounded once; the square, its multiple and the quotient
    /// are rounded once each, and the quotient is at most d u: 4 d u^2 = 5.4 u^2. The last sum is exact. Together
    /// 7.7 u^2, and terms of higher order. Scaling by powers of two keeps all products in range.
    #[inline(always)]
    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        let high = x.round();
        if high == 0.0 || !high.is_finite() {
            return x;
        }
        let (scale, back) = scales(high.abs());
        let x = x * scale;
        let y = Self::double(x.round());
        let remainder = x - DoubleDoubleWith::two_product(y, y) * y;
        let correction = remainder.round() / (3.0 * (y * y));
        DoubleDoubleWith::two_sum(y, correction) * back
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.root(3, Self::double)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.root(3, Self::double)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.cbrt_mut();
    }
}

/// `m` from 1 to 8 and `third`: the number, which is positive and finite, is m 2^(3 third).
#[inline(always)]
fn reduced(x: f64) -> (f64, i32) {
    let subnormal = x < f64::MIN_POSITIVE;
    let normal = if subnormal { x * power_of_two(54) } else { x };
    let exponent = (normal.to_bits() >> 52) as i32 - 1023;
    let third = exponent.div_euclid(3);
    let m = f64::from_bits(normal.to_bits().wrapping_sub(((3 * i64::from(third)) << 52) as u64));
    (m, if subnormal { third - 18 } else { third })
}

/// The cube roots of 1, 2 and 4, rounded.
const ROOTS_OF_TWOS: [f64; 3] = [1.0, 1.259_921, 1.587_401];

/// The cube root of a number m from 1 to 8.
///
/// 1. A polynomial for m in [1, 2), times the root of a power of two, is off by e = 2^-13 of it at most.
/// 2. Halley's step `y (y^3 + 2 m)/(2 y^3 + m)` leaves (2/3) e^3 and terms of higher order, less than 2^-38, and a few
///    roundings.
/// 3. Newton's step `y + (m - y^3)/(3 y^2)` leaves the square of that, less than 2^-76. The cube is taken in double-double
///    and off by 1.5 u^2; the remainder, less than 2^-36 of m, and the quotient are rounded, which adds less than 2^-86.
///
/// What is rounded at the end is therefore right to 2^-75, and the value to u (1 + 2^-22): [`CUBE_ROOT`] is more. Where the
/// root is a number of 53 bits, as those of cubes of short numbers are, it is the value.
#[inline(always)]
fn of_reduced(m: f64) -> f64 {
    let twos = (m.to_bits() >> 52) as usize - 1023;
    let fraction = f64::from_bits(m.to_bits() & ((1 << 52) - 1) | 1023 << 52);
    let polynomial = 0.555_791 + fraction * (0.580_826 + fraction * (-0.158_662 + fraction * 0.022_149));
    let y = polynomial * ROOTS_OF_TWOS.get(twos).copied().unwrap_or(1.0);
    let cube = y * y * y;
    let y = y * ((cube + (m + m)) / (cube + cube + m));
    let remainder = (DoubleDouble::two_product(y, y) * -y + m).round();
    y + remainder / (3.0 * (y * y))
}

/// A power of 8 by which a magnitude comes far from the ends of the range, and the root of its reciprocal.
#[inline(always)]
fn scales(size: f64) -> (f64, f64) {
    if size < power_of_two(-300) {
        (power_of_two(600), power_of_two(-200))
    } else if size > power_of_two(300) {
        (power_of_two(-600), power_of_two(200))
    } else {
        (1.0, 1.0)
    }
}
