//! `closedform list`: every kernel in one table.

use std::path::Path;

use super::description::{Description, with_unit};
use super::output;
use crate::catalogue::Catalogue;

/// List every kernel with its inputs, domain, bound and rules
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Write JSON: an array with everything that is known of every kernel
    #[arg(long)]
    json: bool,
}

/// Lists the kernels.
///
/// # Errors
///
/// When there are none, or they cannot be read.
pub fn run(args: &Args, root: &Path) -> miette::Result<()> {
    let catalogue = Catalogue::open(root)?;
    let kernels: Vec<Description> = catalogue.entries().iter().map(Description::of).collect();
    if args.json {
        output::print_json(&kernels)?
    } else {
        output::print(&text(&kernels))?
    }
    Ok(())
}

fn text(kernels: &[Description]) -> String {
    let mut table = output::table(["kernel", "inputs", "domain", "results", "bound (ulp)", "rules"]);
    table.add_rows(kernels.iter().map(row));
    format!("{table}\n{} kernels\n", kernels.len())
}

fn row(kernel: &Description) -> [String; 6] {
    let lines = |parts: Vec<String>| parts.join("\n");
    [
        kernel.kernel.clone(),
        lines(kernel.inputs.iter().map(|input| with_unit(&input.name, &input.unit)).collect()),
        lines(kernel.domain.clone()),
        lines(kernel.results.iter().map(|result| with_unit(&result.name, &result.unit)).collect()),
        lines(kernel.results.iter().map(|result| bound_text(result.bound_ulp)).collect()),
        lines(kernel.rules.clone()),
    ]
}

fn bound_text(bound: Option<f64>) -> String {
    bound.map_or_else(|| "none".to_owned(), |bound| bound.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;

    #[test]
    fn every_kernel_has_a_row() {
        let (_folder, catalogue) = fixture::catalogue();
        let kernels: Vec<Description> = catalogue.entries().iter().map(Description::of).collect();
        let text = text(&kernels);
        for part in ["line::root", "a_max [s]", "aMax >= 0", "3.5", "conjugate", "plane::slope", "d [m]", "3 kernels"] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
    }
}
