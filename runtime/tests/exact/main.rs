//! Arithmetic and roots against exact arithmetic.

mod numbers;
mod root;
mod wide;
