//! Exact algebra by Symbolica: the only folder that names it.

mod polynomial;
mod turn;
mod work;

pub use polynomial::{Factors, Polynomial, Ring, Term, Var};
pub use turn::{Patience, Turn, TurnError, WAIT};
pub use work::{TooMuchWork, limited};
