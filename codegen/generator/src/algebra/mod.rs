//! Exact algebra: polynomials over the rationals, and a limit to the work that they take.

mod polynomial;
mod work;

pub use polynomial::{Algebra, Factors, Implementation, Polynomial, Ring, Term, Var};
pub use work::{TooMuchWork, limited};
