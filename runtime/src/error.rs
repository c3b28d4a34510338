//! Why a kernel has no value to give.

use core::error::Error;
use core::fmt;

use closedform_arith::limits::MAX_INPUTS;
use closedform_arith::tier::{Fate, Rounded};

use crate::info::Info;

/// A point of a kernel: names and values of its inputs. Inputs beyond [`MAX_INPUTS`] are left off.
#[derive(Clone, Copy, PartialEq)]
struct Point {
    info: &'static Info,
    values: [f64; MAX_INPUTS],
}

impl Point {
    fn new(info: &'static Info, inputs: &[f64]) -> Self {
        let mut values = [0.0; MAX_INPUTS];
        values.iter_mut().zip(inputs).for_each(|(slot, value)| *slot = *value);
        Point { info, values }
    }

    fn inputs(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.info.inputs.iter().map(|input| input.name).zip(self.values)
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, (name, value)) in self.inputs().enumerate() {
            let separator = if position == 0 { "" } else { ", " };
            // Debug prints the shortest digits that round-trip, and an exponent where that is shorter.
            write!(f, "{separator}{name} = {value:?}")?;
        }
        Ok(())
    }
}

/// Inputs outside the domain of a kernel: which condition they violate, and their values.
#[derive(Clone, Copy, PartialEq)]
pub struct DomainError {
    point: Point,
    condition: &'static str,
}

impl DomainError {
    /// That `inputs` violate `condition`. Inputs beyond [`MAX_INPUTS`] are left off.
    #[cold]
    pub fn new(info: &'static Info, condition: &'static str, inputs: &[f64]) -> Self {
        DomainError { point: Point::new(info, inputs), condition }
    }

    /// The name of the kernel.
    pub fn kernel(&self) -> &'static str {
        self.point.info.name
    }

    /// The first condition that the inputs violate.
    pub fn condition(&self) -> &'static str {
        self.condition
    }

    /// Names and values of all inputs, in order.
    pub fn inputs(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.point.inputs()
    }
}

impl fmt::Debug for DomainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "DomainError({self})")
    }
}

impl fmt::Display for DomainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: outside the domain: `{}` does not hold for {}", self.kernel(), self.condition, self.point)
    }
}

impl Error for DomainError {}

/// Inputs inside the domain of a kernel for which `f64` cannot hold a result.
#[derive(Clone, Copy, PartialEq)]
pub struct RangeError {
    point: Point,
    result: &'static str,
    value: f64,
    reason: RangeReason,
}

/// Why `f64` cannot hold a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RangeReason {
    /// It is beyond the largest `f64`.
    Overflow,
    /// It is not zero, but so far below the smallest normal `f64` that it loses digits.
    Underflow,
    /// There is none: the formula divides by zero there, or takes the root of a negative number. No kernel that
    /// `closedform` generates has such inputs in its domain.
    Undefined,
    /// Whether the formula has a value there, or which, is not told by 4,096 bits: a part of it may be exactly zero.
    Undecided,
}

impl RangeError {
    /// That the result of this name is lost; `None` if it is not.
    #[cold]
    pub(crate) fn new(info: &'static Info, result: &'static str, rounded: Rounded, inputs: &[f64]) -> Option<Self> {
        let reason = match rounded.fate {
            Fate::Kept => return None,
            Fate::Overflows => RangeReason::Overflow,
            Fate::Underflows => RangeReason::Underflow,
            Fate::Missing => RangeReason::Undefined,
            Fate::Undecided => RangeReason::Undecided,
        };
        Some(RangeError { point: Point::new(info, inputs), result, value: rounded.value, reason })
    }

    /// The name of the kernel.
    pub fn kernel(&self) -> &'static str {
        self.point.info.name
    }

    /// The name of the first result that is lost.
    pub fn result(&self) -> &'static str {
        self.result
    }

    /// Why it is lost.
    pub fn reason(&self) -> RangeReason {
        self.reason
    }

    /// What the default call returns for it: an infinity, the nearest number of few digits or none, or NaN.
    pub fn rounded(&self) -> f64 {
        self.value
    }

    /// Names and values of all inputs, in order.
    pub fn inputs(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.point.inputs()
    }
}

impl fmt::Debug for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "RangeError({self})")
    }
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kernel, result, point) = (self.kernel(), self.result, self.point);
        let (what, remedy) = match self.reason {
            RangeReason::Overflow => ("is beyond the largest f64", "take other units"),
            RangeReason::Underflow => ("is below the smallest normal f64 and loses digits", "take other units"),
            RangeReason::Undefined => (
                "has no value, since the formula divides by zero or takes the root of a negative number",
                "exclude such inputs by a `require!`",
            ),
            RangeReason::Undecided => (
                "is not decided by 4,096 bits: a part of it may be exactly zero",
                "exclude such inputs by a `require!`",
            ),
        };
        write!(f, "{kernel}: the result `{result}` {what} for {point}; {remedy}")
    }
}

impl Error for RangeError {}

/// Why a checked call has no value to give.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ValueError {
    /// The inputs lie outside the domain.
    Domain(DomainError),
    /// `f64` cannot hold a result.
    Range(RangeError),
}

impl ValueError {
    /// The first condition that the inputs violate, where they lie outside the domain.
    pub fn condition(&self) -> Option<&'static str> {
        match self {
            ValueError::Domain(error) => Some(error.condition()),
            ValueError::Range(_) => None,
        }
    }
}

impl From<DomainError> for ValueError {
    fn from(error: DomainError) -> Self {
        ValueError::Domain(error)
    }
}

impl From<RangeError> for ValueError {
    fn from(error: RangeError) -> Self {
        ValueError::Range(error)
    }
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ValueError::Domain(error) => error.fmt(f),
            ValueError::Range(error) => error.fmt(f),
        }
    }
}

impl Error for ValueError {}

/// A slice of the wrong length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthError {
    /// The name of the kernel.
    pub kernel: &'static str,
    /// The input or result whose slice it is, or `inputs` or `results` where their number is wrong.
    pub name: &'static str,
    /// The length that it must have.
    pub expected: usize,
    /// The length that it has.
    pub found: usize,
}

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let LengthError { kernel, name, expected, found } = self;
        write!(f, "{kernel}: `{name}` must have length {expected}, not {found}")
    }
}

impl Error for LengthError {}

/// Why a call of a [`Kernel`](crate::Kernel) by slices failed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CallError {
    /// The inputs lie outside the domain.
    Domain(DomainError),
    /// `f64` cannot hold a result.
    Range(RangeError),
    /// A slice has the wrong length.
    Length(LengthError),
}

impl From<ValueError> for CallError {
    fn from(error: ValueError) -> Self {
        match error {
            ValueError::Domain(error) => CallError::Domain(error),
            ValueError::Range(error) => CallError::Range(error),
        }
    }
}

impl From<LengthError> for CallError {
    fn from(error: LengthError) -> Self {
        CallError::Length(error)
    }
}

impl fmt::Display for CallError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CallError::Domain(error) => error.fmt(f),
            CallError::Range(error) => error.fmt(f),
            CallError::Length(error) => error.fmt(f),
        }
    }
}

impl Error for CallError {}
