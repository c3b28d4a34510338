//! The last phase: passes, which make a candidate with the same results of one that is finished.

pub mod distributed;
pub mod double_double;
pub mod fused;
pub mod one_reciprocal;
mod products;

use super::candidate::Candidate;
use crate::program::{Graph, Node};

/// A pass over a finished program.
pub trait Pass {
    /// The same results in other steps; `None` where the pass does not apply.
    fn apply(&self, candidate: &Candidate) -> Option<Candidate>;
}

/// Makes the product of two steps in a better way than as one step, if there is one.
pub type Product = fn(&mut Graph, Node, Node) -> Option<Node>;
