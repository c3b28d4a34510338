//! The generator with Symbolica for its algebra, as the program that `closedform` runs.

mod polynomial;
pub mod worker;

use closedform_generator::algebra::Algebra;

/// Polynomials by Symbolica, which allows one process and one thread on a machine if it has no licence key.
pub const ALGEBRA: Algebra = Algebra::by::<polynomial::Polynomial>();
