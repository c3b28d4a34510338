//! Arithmetic and roots against exact arithmetic.

mod double_double;
mod numbers;
#[path = "../common/random.rs"]
mod random;
mod root;
