//! Signs of polynomials, from what is known of their atoms and of other polynomials.

mod boxes;
mod facts;
mod prove;
mod range;
mod set;

pub use facts::Facts;
pub use set::Sign;
