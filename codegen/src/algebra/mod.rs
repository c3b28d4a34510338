//! Exact algebra by Symbolica: the only folder that names it.

mod polynomial;
mod session;

pub use polynomial::{Factors, Polynomial, Ring, Term, Var};
pub use session::{Session, SessionError};
