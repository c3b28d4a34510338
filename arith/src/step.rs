//! What functions whose values are integers share: which integer it is, in every arithmetic, and where it is certain.

use core::cmp::Ordering;

use crate::double_double::DoubleDoubleWith;

/// How a number becomes an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// Down.
    Floor,
    /// Up.
    Ceiling,
    /// To the nearest one, and from the middle to the even one.
    Round,
    /// Towards zero.
    Truncate,
}

/// What lies behind the point of a magnitude, compared with 1/2; `None` of an integer.
pub(crate) type Fraction = Option<Ordering>;

impl Step {
    /// Whether the magnitude of the value is one more than the integer part, of which it is said whether it is odd.
    pub(crate) fn leaves_zero(self, is_negative: bool, is_odd: bool, fraction: Fraction) -> bool {
        match (self, fraction) {
            (_, None) | (Self::Truncate, _) => false,
            (Self::Floor, _) => is_negative,
            (Self::Ceiling, _) => !is_negative,
            (Self::Round, Some(Ordering::Equal)) => is_odd,
            (Self::Round, Some(order)) => order == Ordering::Greater,
        }
    }
}

/// The value in double-double, by that of both parts in `f64`: only where the high part is an integer does the low one count, and
/// then nothing else does. Exact.
///
/// No step lies between the sum and its high part, the nearest `f64`: integers, and the middles between them, are numbers of
/// `f64` where the high part is none.
pub(crate) fn double_double<const FUSED: bool>(
    x: DoubleDoubleWith<FUSED>,
    way: fn(f64) -> f64,
) -> DoubleDoubleWith<FUSED> {
    let high = way(x.round());
    if high == x.round() { DoubleDoubleWith::two_sum(high, way(x.low())) } else { high.into() }
}

/// What an error makes of the value `y` of a function in `f64` that never decreases: nothing where it has the same value at numbers
/// beyond both ends of the interval.
#[inline(always)]
pub(crate) fn spread(x: f64, y: f64, error: f64, function: fn(f64) -> f64) -> f64 {
    let (least, most) = (function((x - error).next_down()), function((x + error).next_up()));
    if least == y && most == y { 0.0 } else { f64::INFINITY }
}
