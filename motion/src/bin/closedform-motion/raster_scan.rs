//! `raster-scan`: a raster scan that flies along one axis and steps the other.

mod derived;
mod fastest;
mod input;

pub use input::Inputs;

use crate::error::Outcome;
use crate::input::merged;
use crate::output::Output;

/// Plans, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(inputs, output.file.as_deref())?;
    if inputs.is_derived() { derived::run(&inputs.derived()?, output) } else { fastest::run(&inputs, output) }
}
