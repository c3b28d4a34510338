//! Stable forms: from canonical elements to programs that keep their digits, by named rules in three phases.
//!
//! Forms and solvers make steps of mathematics by a builder; passes make other steps of a finished program.
//! [`strategy`] alone names them all, and says in which order they are tried.

pub mod builder;
pub mod candidate;
mod comparison;
pub mod forms;
pub mod nest;
pub mod passes;
mod quotient;
pub mod rule;
pub mod solvers;
pub mod strategy;
mod surd;

pub use comparison::compared_with_zero;
