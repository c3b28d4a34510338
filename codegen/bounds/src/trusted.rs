//! What the runtime promises of its operations: the constants of the error model as exact counts.

use closedform_arith::Function;
use closedform_arith::error_model::{self, Units};
use num_rational::BigRational;

/// The count of a step in `f64`.
#[must_use]
pub fn rounding() -> BigRational {
    exact(error_model::ROUNDING)
}

/// The count of a function of an exact argument, in `f64`.
#[must_use]
pub fn call(function: Function) -> BigRational {
    exact(function.properties().error)
}

/// The count of a `compensated!` expression of exact operands.
#[must_use]
pub fn compensated() -> BigRational {
    exact(error_model::COMPENSATED)
}

/// The count of a `positive_root` with respect to the root of its coefficients as they are.
#[must_use]
pub fn positive_root() -> BigRational {
    exact(error_model::POSITIVE_ROOT)
}

/// What a proved Newton step onto a root leaves before it is rounded.
#[must_use]
pub fn correction() -> BigRational {
    exact(error_model::CORRECTION)
}

/// How many units of 2^-106 of the sum of its terms' magnitudes the error of a `residual!` of so many operations can be.
#[must_use]
pub fn residual(operations: usize) -> BigRational {
    exact(error_model::RESIDUAL) * BigRational::from_integer((operations * operations).into())
}

/// The count of a step in double-double.
#[must_use]
pub fn double_double_step() -> BigRational {
    exact(error_model::DOUBLE_DOUBLE_STEP)
}

/// The count of a `compensated!` expression of exact operands whose value stays in double-double.
#[must_use]
pub fn compensated_in_double_double() -> BigRational {
    exact(error_model::COMPENSATED_IN_DOUBLE_DOUBLE)
}

/// The count of a result in certified arithmetic, whatever its program: each call bounds the error that it has made, and
/// does not return before that is small enough.
#[must_use]
pub fn certified() -> BigRational {
    exact(error_model::CERTIFIED)
}

fn exact(units: Units) -> BigRational {
    BigRational::new(units.numerator.into(), units.denominator.into())
}
