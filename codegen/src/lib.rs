//! From Maxima reference expressions to Rust kernels: the stages of the generator, and the commands.

pub mod algebra;
pub mod bound_proof;
pub mod catalogue;
pub mod command;
#[cfg(test)]
mod drawn;
pub mod expression;
pub mod field;
pub mod folder;
pub mod hunt;
pub mod kept;
pub mod kernel;
pub mod ledger;
pub mod markdown;
pub mod measure;
pub mod mutate;
pub mod own_crate;
pub mod pipeline;
pub mod processor;
pub mod program;
pub mod root;
pub mod rust;
pub mod scratch;
pub mod stable;
pub mod stated;
pub mod verdict;
pub mod worker;
pub mod worksheet;
