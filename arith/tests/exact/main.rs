//! Arithmetic and roots against exact arithmetic.

mod double_double;
mod numbers;
mod root;
