//! What the runtime promises of its operations.

use num_rational::BigRational;

/// The count of a `compensated!` slice of exact operands: it is right to a thousandth of a unit, and rounded once.
#[must_use]
pub fn compensated() -> BigRational {
    thousandths(1001)
}

/// The count of a `positive_root` with respect to the root of its coefficients as they are.
#[must_use]
pub fn positive_root() -> BigRational {
    thousandths(1010)
}

/// How many units of 2^-106 of the sum of its terms' magnitudes one operation in double-double can add to the error of
/// a `residual!`.
#[must_use]
pub fn double_double_operation() -> BigRational {
    thousandths(10_000)
}

fn thousandths(value: i64) -> BigRational {
    BigRational::new(value.into(), 1000.into())
}
