//! The functions that kernels may call, as data: what holds of each, and how every arithmetic evaluates it.
//!
//! A function is a file of this folder, which implements `Definition`, and a line of the table below. All else asks the
//! table: no arithmetic, no tree and no text for people names a function.
//!
//! They are functions of one number. `max` and `min` are none of them: they choose one of any number of values, which
//! needs comparisons and no arithmetic, and rounds nothing.

mod abs;
mod acos;
mod asin;
mod atan;
mod cbrt;
mod ceiling;
mod cos;
mod cost;
mod elementary;
mod exp;
mod floor;
mod log;
mod operations;
mod properties;
mod round;
mod signs;
mod sin;
mod sqrt;
mod stepped;
mod tan;
mod truncate;

use core::cmp::Ordering;

use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;
pub use cost::Cost;
pub use properties::{Domain, Parity, Properties};

/// A function: what holds of it, and its value in every arithmetic.
trait Definition {
    /// What holds of it.
    const PROPERTIES: Properties;

    /// In `f64`, with the error that [`Properties::error`] says.
    fn double(x: f64) -> f64;

    /// In double-double, with the error that [`Properties::double_double_error`] says where [`Range`](crate::range::STEP)
    /// holds of both argument and value.
    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED>;

    /// In integers with an endless exponent, right to 2^-120.
    fn soft(x: SoftFloat) -> SoftFloat;

    /// In balls: one that holds the value at every number of the ball `x`.
    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L>;

    /// At least |f(x + d) - f(x)| for every |d| <= `error`, but for a factor of 1 + 2^-40 of rounding, with the value `y` in `f64` at `x`.
    /// Nobody asks it of a power.
    #[inline(always)]
    fn spread(_: f64, _: f64, _: f64) -> f64 {
        f64::INFINITY
    }

    /// In MPFR, correctly rounded.
    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float);
}

/// Declares the functions; each is a file of this folder, in which a type of the same name is its definition. What costs
/// something is counted, under the name given.
macro_rules! functions {
    ($($name:ident in $file:ident $(counted as $field:ident)?,)*) => {
        operations::operations! { $($($field: $name,)?)* }

        /// A function of one number.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Function {
            $(#[doc = concat!("`", stringify!($file), "(e)`")] $name,)*
        }

        impl Function {
            /// All of them.
            pub const ALL: [Self; [$(stringify!($name)),*].len()] = [$(Self::$name),*];

            /// What holds of it.
            #[inline(always)]
            #[must_use]
            pub const fn properties(self) -> &'static Properties {
                match self {
                    $(Self::$name => &<$file::$name as Definition>::PROPERTIES,)*
                }
            }

            /// Its value in `f64`.
            #[inline(always)]
            pub(crate) fn double(self, x: f64) -> f64 {
                match self {
                    $(Self::$name => $file::$name::double(x),)*
                }
            }

            /// At least what an error of the argument `x` is of the value `y`, of a function that is no power.
            #[inline(always)]
            pub(crate) fn spread(self, x: f64, y: f64, error: f64) -> f64 {
                match self {
                    $(Self::$name => $file::$name::spread(x, y, error),)*
                }
            }

            /// Its value in double-double.
            #[inline(always)]
            pub(crate) fn double_double<const FUSED: bool>(self, x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
                match self {
                    $(Self::$name => $file::$name::double_double(x),)*
                }
            }

            /// Its value in integers with an endless exponent.
            #[inline(always)]
            pub(crate) fn soft(self, x: SoftFloat) -> SoftFloat {
                match self {
                    $(Self::$name => $file::$name::soft(x),)*
                }
            }

            /// Its value in balls.
            #[inline(always)]
            pub(crate) fn ball<'a, const L: usize>(self, x: &Ball<'a, L>) -> Ball<'a, L> {
                match self {
                    $(Self::$name => $file::$name::ball(x),)*
                }
            }

            /// Its value in MPFR, in place.
            #[cfg(any(test, feature = "mpfr"))]
            pub fn mpfr(self, x: &mut rug::Float) {
                match self {
                    $(Self::$name => $file::$name::mpfr(x),)*
                }
            }
        }
    };
}

functions! {
    Sqrt in sqrt counted as sqrt,
    Abs in abs,
    Cbrt in cbrt counted as cbrt,
    Exp in exp counted as exp,
    Log in log counted as log,
    Sin in sin counted as sin,
    Cos in cos counted as cos,
    Tan in tan counted as tan,
    Asin in asin counted as asin,
    Acos in acos counted as acos,
    Atan in atan counted as atan,
    Floor in floor,
    Ceiling in ceiling,
    Round in round,
    Truncate in truncate,
}

impl Function {
    /// Its name in the kernel language.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.properties().name
    }

    /// The function of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.name() == name)
    }

    /// The function of this name in worksheets; those without one are written as powers.
    #[must_use]
    pub fn in_worksheets(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.properties().maxima.strip_suffix("(x)") == Some(name))
    }

    /// The real root of this degree.
    #[must_use]
    pub fn root(degree: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.degree() == Some(degree))
    }

    /// Whether its magnitude is a power of that of its argument.
    #[inline(always)]
    #[must_use]
    pub const fn is_power(self) -> bool {
        self.properties().exponent.is_some()
    }

    /// The degree, if it is a root.
    #[must_use]
    pub fn degree(self) -> Option<u32> {
        match self.properties().exponent {
            Some((1, degree @ 2..)) => Some(degree),
            _ => None,
        }
    }

    /// What an error of the argument is of the value, both relative and small; infinite where that depends on the argument.
    #[must_use]
    pub fn carried(self, error: f64) -> f64 {
        match self.properties().exponent {
            Some((p, q)) => f64::from(p) / f64::from(q) * error,
            None if error == 0.0 => 0.0,
            None => f64::INFINITY,
        }
    }

    /// The signs that the value can have at an argument of this sign; none where there is no value.
    #[must_use]
    pub const fn signs(self, of_argument: Ordering) -> &'static [Ordering] {
        let [negative, zero, positive] = self.properties().signs;
        match of_argument {
            Ordering::Less => negative,
            Ordering::Equal => zero,
            Ordering::Greater => positive,
        }
    }

    /// Whether it has a value at every number.
    #[must_use]
    pub const fn is_total(self) -> bool {
        matches!(self.properties().domain, Domain::All)
    }

    /// Whether it turns its sign with the argument's.
    #[must_use]
    pub const fn is_odd(self) -> bool {
        matches!(self.properties().parity, Parity::Odd)
    }

    /// Whether it is the same at the argument's negative.
    #[must_use]
    pub const fn is_even(self) -> bool {
        matches!(self.properties().parity, Parity::Even)
    }

    /// Whether it has a value there.
    #[inline(always)]
    pub(crate) fn is_defined(self, x: f64) -> bool {
        self.properties().domain.holds(x)
    }

    /// Whether a value of zero is one, not a value that underflows: powers vanish with their arguments, what has steps between
    /// two of them, all others at 0 and 1 only.
    #[inline(always)]
    pub(crate) fn may_vanish(self, x: f64) -> bool {
        self.is_power() | self.has_steps() | (x == 0.0) | (x == 1.0)
    }

    /// Whether its values are integers, the same from one step to the next: exact where the argument is, and otherwise certain
    /// only where no step lies within the argument's error. Nothing else that is no power is exact in `f64`.
    #[inline(always)]
    #[must_use]
    pub const fn has_steps(self) -> bool {
        matches!(self.properties().error, Units::NONE) && !self.is_power()
    }

    /// Whether the value has the sign of the argument, at every number.
    #[must_use]
    pub const fn keeps_sign(self) -> bool {
        matches!(self.properties().signs, [[Ordering::Less], [Ordering::Equal], [Ordering::Greater]])
    }

    /// Whether the value is the argument but for its sign, so that nothing is rounded.
    #[must_use]
    pub const fn is_exact(self) -> bool {
        matches!(self.properties().exponent, Some((1, 1)))
    }
}
