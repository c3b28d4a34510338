//! The error model: how far off every operation can be, each constant once, and what proves it.
//!
//! With u = 2^-53, the unit roundoff of `f64`, a step that is rounded once is the exact one times a factor between 1 - u
//! and 1 + u: theorem 2.2 of N. J. Higham, "Accuracy and Stability of Numerical Algorithms", 2nd edition, SIAM 2002. How
//! such factors add up is counted as in its section 3.4 ([`Units`]).
//!
//! Double-double is that of M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks
//! of double-word arithmetic", ACM TOMS 44(2), 2017 (JMP). J.-M. Muller, L. Rideau, "Formalization of double-word
//! arithmetic, and comments on \[JMP\]", ACM TOMS 48(1), 2022 (MR) proved its theorems by machine; they mended the proofs of
//! DWPlusFP and of products of two numbers in double-double, and sharpened the bounds of the latter. The root is that of
//! V. Lefevre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, "Accurate calculation of Euclidean norms using double-word
//! arithmetic", ACM TOMS 49(1), 2023.
//!
//! All of it holds where nothing over- or underflows: see [`range`].

use crate::range;

/// The unit roundoff u of `f64`.
pub const UNIT: f64 = range::power_of_two(-53);

/// A count of relative errors in units of u, as a fraction: proofs count exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Units {
    /// Above the bar.
    pub numerator: u32,
    /// Below the bar.
    pub denominator: u32,
}

impl Units {
    /// No error.
    pub const NONE: Self = Units::new(0, 1);

    const fn new(numerator: u32, denominator: u32) -> Self {
        Units { numerator, denominator }
    }

    /// The nearest number.
    #[must_use]
    pub const fn to_f64(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

/// One step in `f64`, rounded to nearest.
pub const ROUNDING: Units = Units::new(1, 1);

/// The cube root in `f64`: one rounding of what is right to 2^-75, as its code proves step by step.
pub const CUBE_ROOT: Units = Units::new(1001, 1000);

/// An elementary function of the crate `libm` in `f64`: two ulp. Its authors state less than one for each; that is not proved, and the
/// largest error found at some 10^5 arguments is less than one ulp.
pub const ELEMENTARY: Units = Units::new(4, 1);

/// A compensated expression that [passes its rounding test](compensated::threshold) and goes on in double-double, or is exact.
pub const COMPENSATED_IN_DOUBLE_DOUBLE: Units = Units::new(1, 1000);

/// The same, rounded to `f64`.
pub const COMPENSATED: Units = Units::new(1001, 1000);

/// A step in double-double. Its error is at most that of a [quotient](double_double::QUOTIENT), 15 u of a unit; this is far
/// more, so that no terms of higher order need be followed, and still nothing beside a rounding.
pub const DOUBLE_DOUBLE_STEP: Units = Units::new(1, 1_000_000);

/// A residual of k operations, in units of k^2 u^2 and relative to the sum of the magnitudes of its terms: at least what
/// [`Part`](compensated::Part) counts. (By induction, m <= k and n <= 4 k^2: 4 (j^2 + k^2) + j k + 3 (j + k) + 2 <= 4 (j + k + 1)^2,
/// and 4 k^2 + 2 k + 1 <= 4 (k + 1)^2.)
pub const RESIDUAL: Units = Units::new(4, 1);

/// The iterate of [`positive_root`](crate::positive_root()), compared with the root of its coefficients as they are: it is the
/// rounded root but for a last doubt.
pub const POSITIVE_ROOT: Units = Units::new(101, 100);

/// What a Newton step from such an iterate leaves before it is rounded: a correction of at most some hundred units that is
/// itself right to a few units in 2^-40.
pub const CORRECTION: Units = Units::new(1, 100);

/// The same, rounded to `f64`.
pub const CORRECTED_ROOT: Units = Units::new(101, 100);

/// A certified result: what is [accepted](CERTIFIED_RADIUS), rounded to `f64`.
pub const CERTIFIED: Units = Units::new(1008, 1000);

/// The same as a bound in ulp: half of one by rounding, and 2^-7.
pub const CERTIFIED_ULP: f64 = 0.51;

/// The exponent of the relative error at which a certified call returns its result.
pub const CERTIFIED_RADIUS: i64 = -60;

/// Relative errors of operations on [`DoubleDouble`](crate::DoubleDouble), in units of u^2.
pub mod double_double {
    use crate::error_model::UNIT;

    /// Of two numbers in double-double, cancellation or not: JMP theorem 3.1 (algorithm 6, AccurateDWPlusDW), confirmed by MR.
    pub const SUM: f64 = 3.0 / (1.0 - 4.0 * UNIT);

    /// With an `f64`: JMP algorithm 4 (DWPlusFP). MR mended its proof and confirmed the bound.
    pub const SUM_WITH_F64: f64 = 2.0;

    /// Of two numbers in double-double: algorithm 10 (DWTimesDW1), which uses no fused operation outside 2Prod. JMP proved 7;
    /// MR found a gap in that proof, closed it, and proved less than 5 where ties round to even.
    pub const PRODUCT: f64 = 5.0;

    /// With an `f64`: JMP algorithm 7 (DWTimesFP1), confirmed by MR.
    pub const PRODUCT_WITH_F64: f64 = 1.5 + 4.0 * UNIT;

    /// Of two numbers in double-double: JMP theorem 7.1 (algorithm 17, DWDivDW2), confirmed by MR.
    pub const QUOTIENT: f64 = 15.0 + 56.0 * UNIT;

    /// The square root: Lefevre et al. (SQRTDWtoDW).
    pub const ROOT: f64 = 25.0 / 8.0;

    /// The cube root: one step of Newton from that of the leading part, as its code proves.
    pub const CUBE_ROOT: f64 = 8.0;

    /// Elementary functions: what is right to 2^-119 is cut off to two numbers.
    pub const ELEMENTARY: f64 = 1.0;
}

/// Errors of balls: floats of L words, each with a radius.
///
/// An operation on middles cuts off less than one unit of the last place, of the frame in which it works, and adds that
/// unit to the radius where bits were cut off. Besides, with numbers x, y in balls of middles a, b and radii r, s:
///
/// - |(x + y) - (a + b)| <= r + s
/// - |x y - a b| <= |x - a| |y| + |a| |y - b| <= r (|b| + s) + |a| s
/// - |x/y - a/b| = |(x - a) - (a/b)(y - b)|/|y| <= (r + |a/b| s)/|y|, and |y| >= |b|/2 is demanded
/// - |max(x, y) - max(a, b)| <= max(r, s), and the same of min
/// - of a root z of degree d, z = c^(1/d): |p - z| <= |p^d - c|/p^(d-1) for every p > 0, and |x^(1/d) - z| <= |x - c|/z^(d-1)
/// - |e^x - e^a| <= e^a r (1 + r) for r <= 1, |ln x - ln a| <= 2 r/a for r <= a/2; sine, cosine and arc tangent are no farther apart
///   than their arguments
/// - of the root of a polynomial, the polynomial has opposite signs at the ends of its ball
///
/// Nothing over- or underflows: exponents have 64 bits.
pub mod ball {
    use crate::range::power_of_two;

    /// By how much a radius is made larger after each operation on radii, which rounds at most four times, its own product
    /// with this included: (1 - u)^5 (1 + 2^-50) > 1.
    pub const UP: f64 = 1.0 + power_of_two(-50);

    /// The exponent of how many units in the last place the ends of a ball are moved apart before they are rounded: sums
    /// of two numbers cut off less than two units of the larger one's frame, which may be twice as large as before.
    pub const APART: i64 = 2;
}

/// Errors of parts of compensated expressions, which are unevaluated sums of two `f64`, a high one and a low one.
///
/// With S the sum of the magnitudes of the terms of a part, its low one is at most m u S, and its error n u^2 S: see [`Part`](compensated::Part).
/// An operand has neither. High ones are added by 2Sum and multiplied by 2Prod; the error e of that, at most u S, is added to what
/// becomes of the low ones, a rounded sum of magnitude (m + 1) u S. Before that,
///
/// - a sum adds two low ones, which rounds a sum of magnitude max(m, m') u S,
/// - a product takes the sum of two products of a high and a low one, of magnitudes m u S and m' u S, which are rounded, and leaves
///   off the product of two low ones, at most m m' u^2 S.
///
/// Where one of them is an operand there is nothing to add, and where both are nothing is rounded at all. The high one of a part
/// differs from S by its low one, and everything else is rounded as well: these factors of 1 + m u are within the margin of the
/// [rounding test](compensated::threshold). The proof is in the book, on the page on the error model.
pub mod compensated {
    use crate::error_model::UNIT;

    /// The m and n of a part.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Part {
        pub(crate) low: f64,
        pub(crate) error: f64,
    }

    impl Part {
        /// An input, a literal, or what counts as exact.
        pub const OPERAND: Self = Part { low: 0.0, error: 0.0 };

        /// Something of which nothing is known.
        pub const UNKNOWN: Self = Part { low: 0.0, error: f64::INFINITY };

        /// The sum of two parts.
        #[must_use]
        pub fn sum(self, other: Self) -> Self {
            let (larger, smaller) = if self.low > other.low { (self.low, other.low) } else { (other.low, self.low) };
            let lows = if smaller == 0.0 { 0.0 } else { larger };
            let errors = if self.error > other.error { self.error } else { other.error };
            Part { low: larger + 1.0, error: errors + lows + last_rounding(larger) }
        }

        /// The product of two parts.
        #[must_use]
        pub fn product(self, other: Self) -> Self {
            let low = self.low + other.low;
            // products of a high and a low part, and their sum where there are two
            let crossed = if self.low == 0.0 || other.low == 0.0 { low } else { 2.0 * low };
            let errors = self.error + other.error + self.low * other.low + crossed + last_rounding(low);
            Part { low: low + 1.0, error: errors + UNDERFLOW }
        }

        /// The product of a part and a power of two, which rounds nothing, but may underflow where it is less than one.
        #[must_use]
        pub fn scaled(self, power: f64) -> Self {
            let underflow = if power.abs() < 1.0 { UNDERFLOW } else { 0.0 };
            Part { error: self.error + underflow, ..self }
        }

        /// The n of: its error is at most n u^2 times the sum of the magnitudes of its terms.
        #[must_use]
        pub const fn error(self) -> f64 {
            self.error
        }
    }

    /// What the last step of an operation rounds, where there is a low part to be added to its error.
    fn last_rounding(low: f64) -> f64 {
        if low == 0.0 { 0.0 } else { low + 1.0 }
    }

    /// What a product adds for [what underflows](crate::range::UNDERFLOW).
    const UNDERFLOW: f64 = 1.0;

    /// How much larger than its error the value has to be, in units of 1/u: a thousand, and one percent for the roundings of
    /// sums of magnitudes and for terms of higher order.
    const MARGIN: f64 = 1010.0;

    /// How much larger than this times the sum of the magnitudes of its terms a compensated expression has to be, whose
    /// error is `units`: then it passes the rounding test, that is, it is right to u/1000. What is exact passes whatever it is.
    #[must_use]
    pub const fn threshold(units: f64) -> f64 {
        if units == 0.0 { -1.0 } else { units * MARGIN * UNIT }
    }
}

/// Constants of the [arithmetic that bounds its own error](crate::Bounded); the book's page on the error model proves what they
/// are used for.
pub mod bounded {
    use crate::error_model::UNIT;
    use crate::range::power_of_two;

    /// The relative error that a `fast` call promises.
    pub const PROMISE: f64 = 1e-13;

    /// The largest count of which anything is proved: (1 + u)^count is at most 1 + 2^-32 then.
    pub const MOST: u32 = 1 << 20;

    /// One count, and [`ROOM`]: (1 + u)^n - 1 <= n u/(1 - n u) <= n u (1 + 2^-32), and one rounding.
    pub const RELATIVE: f64 = UNIT * (1.0 + ROUNDINGS) * ROOM;

    /// What a bound may be too small by where it was computed in [`MOST`] roundings, and those of a test. Errors are made larger by
    /// it where they begin, so that no test has to.
    pub const ROOM: f64 = 1.0 + ROUNDINGS;

    /// What is left of a promise, which is relative to the exact value, when it is tested against the computed one.
    pub const KEPT: f64 = 1.0 - ROUNDINGS;

    const ROUNDINGS: f64 = power_of_two(-30);

    /// What a product or quotient of bounds loses when it underflows, and far more. It is a normal number, since processors take
    /// long over others.
    pub const UNDERFLOW: f64 = power_of_two(-1000);

    /// The count of an absolute error that is taken for a relative one: a power of two, a quarter of the promise.
    pub const COLLAPSED: u32 = 256;

    /// How far from an iterate a root is searched for on both sides, as a share of it.
    pub const ROOT_SHARE: f64 = 64.0 * UNIT;

    /// The count of such a root: the share, and what the two places are rounded by.
    pub const ROOT: u32 = 68;

    const _: () = assert!(COLLAPSED.is_power_of_two() && 3.0 * COLLAPSED as f64 * UNIT < PROMISE);
}

// What the derived constants take from the theorems, held when this is compiled.
const _: () = {
    assert!(DOUBLE_DOUBLE_STEP.to_f64() > 2.0 * double_double::QUOTIENT * UNIT);
    assert!(double_double::CUBE_ROOT < double_double::QUOTIENT && double_double::ROOT < double_double::QUOTIENT);
    assert!(COMPENSATED.to_f64() >= ROUNDING.to_f64() + COMPENSATED_IN_DOUBLE_DOUBLE.to_f64());
    assert!(CORRECTED_ROOT.to_f64() >= ROUNDING.to_f64() + CORRECTION.to_f64());
    let accepted = range::power_of_two(CERTIFIED_RADIUS) / UNIT;
    assert!(CERTIFIED.to_f64() > 1.0 + accepted && CERTIFIED_ULP > 0.5 + accepted);
    assert!(ball::UP - 1.0 > 5.0 * UNIT);
};
