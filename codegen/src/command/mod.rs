//! The commands of `closedform`.

pub mod check;
pub mod derive;
pub mod description;
pub mod eval;
pub mod generate;
pub mod list;
pub mod mutants;
pub mod output;
pub mod readme;
pub mod show;
pub mod verify;
