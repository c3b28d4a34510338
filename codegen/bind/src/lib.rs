//! Kernels in other languages: what is common to all of them, and a folder for each language.
//!
//! A [`Library`] is what a language needs to know: names, quantities, documentation, the trees of the programs. A language
//! turns it into a [`Tree`] of files, and decides nothing about kernels. The next language is a folder beside `c/` and
//! a line in the command.

pub mod c;
mod docs;
mod error;
mod library;
mod lines;
mod names;
mod package;
mod tree;

pub use error::BindError;
pub use library::{Bound, Library, Quantity};
pub use tree::Tree;
