//! Exact expressions: what a reference expression means, free of Maxima's syntax and of any float.

mod choice;
mod derivative;
mod lower;
mod tree;

pub use lower::{
    LowerError, UNKNOWN_FUNCTION, is_function_of_one, is_known_constant, is_known_function, is_of_roots,
    known_functions, lower, lower_errors, remedy_of_constant, remedy_of_function,
};
pub use tree::{Expr, Test};
