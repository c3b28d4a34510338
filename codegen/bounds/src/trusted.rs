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

/// The count of a step in double-double: its error is at most 15 units of 2^-106 and terms of higher order.
#[must_use]
pub fn double_double_step() -> BigRational {
    BigRational::new(1.into(), 1_000_000.into())
}

/// The count of a `compensated!` slice of exact operands whose value stays in double-double.
#[must_use]
pub fn compensated_in_double_double() -> BigRational {
    thousandths(1)
}

/// The count of a result in certified arithmetic, whatever its program: each call bounds the error that it has made, and
/// does not return before that is below 2^-60 of the result, which is then rounded.
#[must_use]
pub fn certified() -> BigRational {
    thousandths(1008)
}

fn thousandths(value: i64) -> BigRational {
    BigRational::new(value.into(), 1000.into())
}
