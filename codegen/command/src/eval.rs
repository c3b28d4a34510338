//! `closedform eval KERNEL name=value ..`: what a kernel returns, beside the true value if asked for.

mod batch;
mod digits;
mod inputs;
mod point;

use std::path::PathBuf;

use closedform_measure::catalogue::Catalogue;
use closedform_project::Project;

pub use digits::{MAX_DIGITS, decimal};

/// Evaluate one kernel, at one point or at those of a CSV file
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// `family::name`, the name alone, or the worksheet's name of a result
    kernel: String,
    /// Every input by its Rust or Maxima name, in decimal (1.5e-3) or exactly (0x1.8p-3)
    #[arg(value_name = "NAME=VALUE")]
    inputs: Vec<String>,
    /// Add the true value with that many digits, and the error in ulp
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_DIGITS)))]
    digits: Option<u32>,
    /// Write JSON
    #[arg(long)]
    json: bool,
    /// Evaluate every row of a CSV file whose header names the inputs (- is standard input), and write CSV
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["inputs", "json"])]
    batch: Option<PathBuf>,
}

/// Evaluates a kernel.
///
/// # Errors
///
/// When there is no such kernel, inputs cannot be read or do not fit, or a single point lies outside of the domain.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let catalogue = Catalogue::open(project)?;
    let entry = catalogue.find(&args.kernel)?;
    match &args.batch {
        Some(file) => batch::run(entry, file, args.digits),
        None => point::run(entry, &args.inputs, args.digits, args.json),
    }
}
