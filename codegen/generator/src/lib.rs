//! From Maxima reference expressions to Rust kernels: the stages of the generator.

pub mod algebra;
pub mod field;
pub mod kernel;
pub mod pipeline;
pub mod program;
pub mod rust;
pub mod stable;
