//! What the commands need of the operating system: outputs that may close, temporary files that may be left behind, the
//! processor time of others and its limits, the turn to use what runs once a machine, and ways between folders.

#[cfg(not(unix))]
compile_error!(
    "this crate needs Unix: signals and permissions of files; the crates that do not are kernels, motion, bounds, maxima"
);

pub mod limit;
pub mod output;
pub mod processor;
pub mod scratch;
pub mod turn;
pub mod way;
