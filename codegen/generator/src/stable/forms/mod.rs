//! The first phase: forms, by which polynomials, surds, quotients and elements become steps.
//!
//! A form is a [`Form`](super::builder::Form): it makes the steps of its subject, or says that it does not apply. What it
//! needs of other forms it asks of the builder.

pub mod certified;
pub mod compensated;
pub mod conjugate;
pub mod cube_conjugate;
pub mod cube_quotient;
pub mod cubic;
pub mod differences_first;
pub mod divided;
pub mod double_double;
pub mod factored;
pub mod known_sum;
pub mod merge_cubes;
pub mod merge_roots;
pub mod plain;
pub mod same_sign_radicand;
pub mod sign_branch;
pub mod sum;
pub mod through_result;
