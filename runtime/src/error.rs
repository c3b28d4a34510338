//! Why a kernel refuses to evaluate.

use core::error::Error;
use core::fmt;

use crate::info::{Info, MAX_INPUTS};

/// Inputs outside the domain of a kernel: which condition they violate, and their values.
#[derive(Clone, Copy, PartialEq)]
pub struct DomainError {
    info: &'static Info,
    condition: &'static str,
    values: [f64; MAX_INPUTS],
}

impl DomainError {
    /// That `inputs` violate `condition`. Inputs beyond [`MAX_INPUTS`] are left off.
    #[cold]
    pub fn new(info: &'static Info, condition: &'static str, inputs: &[f64]) -> Self {
        let mut values = [0.0; MAX_INPUTS];
        values.iter_mut().zip(inputs).for_each(|(slot, value)| *slot = *value);
        DomainError { info, condition, values }
    }

    /// The name of the kernel.
    pub fn kernel(&self) -> &'static str {
        self.info.name
    }

    /// The first condition that the inputs violate.
    pub fn condition(&self) -> &'static str {
        self.condition
    }

    /// Names and values of all inputs, in order.
    pub fn inputs(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.info.inputs.iter().map(|input| input.name).zip(self.values)
    }
}

impl fmt::Debug for DomainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "DomainError({self})")
    }
}

impl fmt::Display for DomainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: outside the domain: `{}` does not hold for", self.kernel(), self.condition)?;
        for (position, (name, value)) in self.inputs().enumerate() {
            let separator = if position == 0 { "" } else { "," };
            // Debug prints the shortest digits that round-trip, and an exponent where that is shorter.
            write!(f, "{separator} {name} = {value:?}")?;
        }
        Ok(())
    }
}

impl Error for DomainError {}

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
pub enum CallError {
    /// The inputs lie outside the domain.
    Domain(DomainError),
    /// A slice has the wrong length.
    Length(LengthError),
}

impl From<DomainError> for CallError {
    fn from(error: DomainError) -> Self {
        CallError::Domain(error)
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
            CallError::Length(error) => error.fmt(f),
        }
    }
}

impl Error for CallError {}
