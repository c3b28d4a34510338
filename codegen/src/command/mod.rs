//! The commands of `closedform`.

pub mod bound;
pub mod check;
mod columns;
pub mod derive;
pub mod description;
pub mod eval;
pub mod generate;
pub mod ledger;
pub mod list;
pub mod motion;
pub mod mutants;
pub mod output;
pub mod readme;
pub mod show;
pub mod verdicts;
pub mod verify;
