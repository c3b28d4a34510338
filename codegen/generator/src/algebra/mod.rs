//! Exact algebra: polynomials over the rationals, and a limit to the work that they take.

mod polynomial;
pub mod sparse;
mod work;

pub use polynomial::{Algebra, Factors, Implementation, Polynomial, Ring, Term, Var};
pub use sparse::Sparse;
pub use work::{TooMuchWork, limited};
