//! The field of closed forms over a domain: signs, and canonical forms in which equal expressions are the same.

mod interval;
mod set;
mod sign;
mod tower;

pub use set::Sign;
pub use sign::{Facts, Slack};
pub use tower::surd::{parts, powers};
pub use tower::{Element, Radical, Tower, TowerError};
