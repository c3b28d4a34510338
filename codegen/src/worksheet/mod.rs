//! The first stage: a family on disk (worksheet, contract, references, golden values) becomes values in memory.

pub mod contract;
pub mod derive;
pub mod domain;
pub mod family;
mod files;
pub mod golden;
pub mod hexfloat;
pub mod maxima_process;
pub mod sample;
pub mod source;
mod statements;

pub use files::{WriteError, replaceable, write_all};
pub use source::ReadError;
