//! What elementary functions share: double-double and integers with an endless exponent by balls.
//!
//! In `f64` they are those of the crate `libm`, whose operations round once each: the same bits on every platform. The finer
//! arithmetics are asked where `f64` does not do; they take the digits from balls of as many words as it needs.

use crate::double_double::DoubleDoubleWith;
use crate::soft_float::SoftFloat;

/// The value at a number, of a function of balls that is called by its name there.
macro_rules! soft {
    ($x:expr, $function:ident) => {{
        let x = $x;
        let decisions = $crate::ball::Decisions::default();
        let few = || $crate::ball::Ball::<'_, 4>::of_soft(x, &decisions).$function().to_soft();
        let more = || $crate::ball::Ball::<'_, 16>::of_soft(x, &decisions).$function().to_soft();
        let most = || $crate::ball::Ball::<'_, 64>::of_soft(x, &decisions).$function().to_soft();
        few().or_else(more).or_else(most).unwrap_or($crate::soft_float::SoftFloat::NAN)
    }};
}
pub(super) use soft;

/// The exponential function; beyond all exponents of `f64` only that it is.
pub(super) fn exp(x: SoftFloat) -> SoftFloat {
    const FAR: i64 = 1 << 40;
    let near = soft!(x, exp);
    if !near.is_nan() || x.is_nan() {
        return near;
    }
    SoftFloat::new(false, 1, if x.is_negative() { -FAR } else { FAR }, true)
}

/// The value in double-double, by that in integers with an endless exponent.
pub(super) fn double_double<const FUSED: bool>(
    x: DoubleDoubleWith<FUSED>,
    function: fn(SoftFloat) -> SoftFloat,
) -> DoubleDoubleWith<FUSED> {
    let (high, low) = function(SoftFloat::from_f64(x.round()).plus(SoftFloat::from_f64(x.low()))).split();
    DoubleDoubleWith::two_sum(high, low)
}

/// What an error makes of the arc sine or cosine: the slope at the end that is nearer to -1 or 1. So far from these ends the
/// difference is right to 2^-32.
#[inline(always)]
pub(super) fn steepest(x: f64, error: f64) -> f64 {
    let rest = 1.0 - x.abs() - error;
    if rest > 1e-6 { 1.001 * error / crate::float::sqrt(rest) } else { f64::INFINITY }
}
