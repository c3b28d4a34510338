//! What a kernel needs when it runs: the shapes of its calls, metadata and errors.
//!
//! A kernel is a closed formula in one straight-line function. `#[kernel]` checks it and makes it available in every
//! arithmetic and shape that callers ask for:
//!
//! ```
//! use closedform::kernel;
//!
//! /// Hypotenuse of a right triangle.
//! #[kernel(family = "triangle")]
//! pub fn hypotenuse(a: f64, b: f64) -> f64 {
//!     require!(a >= 0.0 && b >= 0.0);
//!     sqrt(compensated!(a * a + b * b))
//! }
//!
//! # fn main() -> Result<(), closedform::LengthError> {
//! assert_eq!(hypotenuse(3.0, 4.0), 5.0);
//! assert!(hypotenuse(-3.0, 4.0).is_nan());
//!
//! let error = hypotenuse::checked(-3.0, 4.0).unwrap_err();
//! assert_eq!(error.condition(), Some("a >= 0.0 && b >= 0.0"));
//!
//! let mut lengths = [0.0; 2];
//! hypotenuse::batch(&[3.0, 5.0], &[4.0, 12.0], &mut lengths)?;
//! assert_eq!(lengths, [5.0, 13.0]);
//!
//! // The same by name: one point, many columns, many rows.
//! use hypotenuse::{Columns, Inputs};
//! assert_eq!(Inputs { a: 3.0, b: 4.0 }.call(), 5.0);
//! Columns { a: &[6.0, 9.0], b: &[8.0, 12.0] }.batch(&mut lengths)?;
//! assert_eq!(lengths, [10.0, 15.0]);
//! hypotenuse::rows(&[Inputs { a: 3.0, b: 4.0 }, Inputs { a: 5.0, b: 12.0 }], &mut lengths)?;
//! assert_eq!(lengths, [5.0, 13.0]);
//! # Ok(())
//! # }
//! ```
//!
//! Targets: all with floats that round once, as IEEE 754 demands; 32-bit x86 without SSE2 is refused.
//!
//! The arithmetics that kernels run in are those of `closedform-arith`.
//!
//! Stack: kernels never allocate and never recurse. Most calls need a kilobyte or two; one that ends in the arithmetic of
//! last resort, and sums a compensated expression exactly there, some 14 kB (the largest frames of a release build for
//! x86-64: 6.8 kB and 4.7 kB), as any call of any kernel may. A batch of less than 32 rows copies them into columns of 256
//! bytes, one an input and one a result.
//!
//! Features: `std` (default) takes `sqrt` from the standard library instead of `libm`; `large-balls` (default) lets
//! [`settle`] take more than 256 bits; `serde` serialises and deserialises every [`Record`]; `mpfr` adds `Mpfr`, the
//! arithmetic of arbitrary precision in which judges run kernels.

#![no_std]
#![allow(
    clippy::result_large_err,
    reason = "a DomainError or RangeError carries all inputs, since nothing may allocate; it ends a call"
)]

#[cfg(feature = "std")]
extern crate std;

mod batch;
mod blocks;
mod error;
mod fast;
mod info;
mod kernel;
mod program;
mod record;
mod rows;
#[cfg(feature = "serde")]
mod serde;
mod shape;

#[cfg(feature = "mpfr")]
pub use closedform_arith::Mpfr;
pub use closedform_arith::error_model::bounded::PROMISE as FAST_PROMISE;
pub use closedform_arith::limits::{MAX_DEGREE, MAX_INPUTS};
pub use closedform_arith::table::{Aim, Certified, Domain, Table, settle};
pub use closedform_arith::tier::{Fate, Rounded};
pub use closedform_arith::{DoubleDouble, Function, Operations, Precision, Real, Signs, positive_root};
pub use closedform_derive::{Record, kernel};
pub use error::{CallError, DomainError, LengthError, RangeError, RangeReason, ValueError};
pub use info::{Info, Input, ResultInfo};
pub use kernel::Kernel;
pub use program::{Fast, Program};
pub use record::Record;

/// What expansions of `#[kernel]` call; not for people.
#[doc(hidden)]
pub mod __private {
    pub use crate::batch::{batch, fast_batch};
    pub use crate::fast::{fast, with_bound};
    pub use crate::rows::rows;
    #[cfg(feature = "serde")]
    pub use crate::serde::{deserialize, serialize};
    pub use crate::shape::{checked, faithful, single, value};
    pub use closedform_arith::table::{Instruction, Source, Sum, Table};
    pub use closedform_arith::{Function, Relation, Terms};
    #[cfg(feature = "serde")]
    pub use serde_core;
}

/// Without the feature `serde` a record is a struct, and nothing else; not for people.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serialized {
    ($record:ident, $name:literal, $count:literal) => {};
}
