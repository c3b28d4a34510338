//! The arithmetics that kernels run in, their limits, and one model of their errors.
//!
//! [`Real`] is what a program asks of an arithmetic. The tiers of a call ([`tier`]) are `f64` ([`Filtered`]), double-double
//! ([`FilteredDoubleDouble`]), integers with an exponent that never runs out ([`SoftFloat`]), and for certified kernels balls of more and
//! more words. [`Bounded`] numbers are `f64` with a bound of their error. What functions it can call is a [table](function). [`error_model`] says how far off their operations are, and
//! on what authority; [`range`] between which magnitudes that holds; [`limits`] how large a kernel may be. [`Relation`] is
//! how two numbers compare, in all languages.
//!
//! Everything else stands on this crate: what runs kernels, what reads them, and what proves their bounds.
//!
//! Targets: all with floats that round once, as IEEE 754 demands; 32-bit x86 without SSE2 is refused.
//!
//! Features: `std` (default) takes `sqrt` from the standard library instead of `libm`; `large-balls` (default) lets
//! [tables](table) run in more than 256 bits; `mpfr` adds `Mpfr`, the
//! arithmetic of arbitrary precision in which judges run kernels.

#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod ball;
mod bounded;
mod bounded_pair;
mod double;
mod double_double;
mod error_free;
pub mod error_model;
mod escalating_pair;
mod exact;
pub mod factored;
mod filtered;
mod filtered_double_double;
mod float;
pub mod function;
pub mod limits;
#[cfg(feature = "mpfr")]
mod mpfr;
mod operand;
mod polynomial;
mod precision;
pub mod range;
mod real;
mod relation;
mod root;
mod rounded;
mod soft_float;
mod step;
pub mod table;
mod terms;
pub mod tier;

pub use bounded::{Bounded, Signs};
pub use double_double::{DoubleDouble, DoubleDoubleWith};
pub use error_free::FUSED;
pub use filtered::Filtered;
pub use filtered_double_double::FilteredDoubleDouble;
pub use function::{Function, Operations};
#[cfg(feature = "mpfr")]
pub use mpfr::Mpfr;
pub use precision::Precision;
pub use real::Real;
pub use relation::Relation;
pub use root::positive_root;
pub use soft_float::SoftFloat;
pub use terms::{Term, Terms};
