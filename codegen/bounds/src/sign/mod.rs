//! Signs of polynomials, from what is known of their atoms and of other polynomials.

mod facts;
mod prove;
mod set;

pub use facts::Facts;
pub use set::Sign;
