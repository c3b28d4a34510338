//! `Table`: the program of a kernel as data, which one interpreter runs for all kernels.
//!
//! A table is a list of instructions over numbered registers. Conditions are kept on a stack of their own. The parts
//! of `max` and `min`, and the branch of an `if` that is taken, come in the order in which they are written; the other branch
//! is jumped over.

mod format;
mod machine;
mod settle;

pub use crate::rounded::Certified;
pub use format::{Instruction, Source, Sum, Table};
pub use settle::{Aim, Domain, settle};
