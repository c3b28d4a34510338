//! A project on disk (worksheets, contracts, references, golden values) as values in memory, and Maxima as a process.

mod beside;
mod construct;
pub mod contract;
pub mod derive;
pub mod domain;
#[cfg(any(test, feature = "fixtures"))]
pub mod drawn;
pub mod expression;
pub mod family;
mod files;
pub mod folder;
pub mod fpcore;
pub mod generated;
pub mod golden;
pub mod hexfloat;
pub mod kept;
pub mod layout;
pub mod markdown;
pub mod maxima_process;
pub mod sample;
pub mod script;
pub mod source;
mod statements;
mod worksheet;

pub use files::{WriteError, replaceable, write_all};
pub use layout::{Project, ProjectError};
pub use source::ReadError;
