//! `closedform list`: every kernel, or those of a family, two lines each.

use std::fmt::Write as _;

use miette::miette;

use super::description::{Description, with_unit};
use super::words::counted;
use closedform_measure::catalogue::{Catalogue, CatalogueError, did_you_mean, nearest};
use closedform_project::Project;
use closedform_system::output;

/// How wide a line may be, if it has more than one name.
const WIDTH: usize = 80;

/// List every kernel with its inputs, results and bound; `show KERNEL` has the rest
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// The family whose kernels are listed; all if none is named
    family: Option<String>,
    /// Write JSON: an array with everything that is known of every kernel
    #[arg(long)]
    json: bool,
}

/// Lists the kernels.
///
/// # Errors
///
/// When there are none, or they cannot be read.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let catalogue = Catalogue::open(project)?;
    let kernels = kernels(&catalogue, args.family.as_deref())?;
    if args.json {
        output::print_json(&kernels)?
    } else {
        output::print(&text(&kernels))?
    }
    Ok(())
}

fn kernels(catalogue: &Catalogue, family: Option<&str>) -> miette::Result<Vec<Description>> {
    let asked = |name: &str| family.is_none_or(|family| family == name);
    let entries = catalogue.entries().iter().filter(|entry| asked(&entry.family));
    let kernels: Vec<Description> = entries.map(Description::of).collect();
    match family {
        Some(family) if kernels.is_empty() => Err(unknown(catalogue, family)),
        _ => Ok(kernels),
    }
}

fn unknown(catalogue: &Catalogue, family: &str) -> miette::Report {
    let families = catalogue.entries().iter().map(|entry| (entry.family.clone(), entry.family.clone()));
    let help = match catalogue.find(family) {
        Ok(kernel) => format!("it is a kernel: `closedform show {}` tells all of it", kernel.full_name()),
        Err(CatalogueError::Ambiguous { candidates, .. }) => {
            format!("it is the name of several kernels: `closedform show` tells of {}", candidates.join(", "))
        }
        Err(_) => did_you_mean(&nearest(family, families)),
    };
    miette!(help = help, "no family is called `{family}`")
}

fn text(kernels: &[Description]) -> String {
    let mut text = String::new();
    for kernel in kernels {
        let bound = kernel.results.iter().filter_map(|result| result.bound_ulp).fold(0.0, f64::max);
        let bound = if bound > 0.0 { format!("{bound} ulp") } else { "no bound".to_owned() };
        let _ = writeln!(text, "{}  {bound}", kernel.kernel);
        let inputs = kernel.inputs.iter().map(|input| with_unit(&input.name, &input.unit));
        let results = kernel.results.iter().map(|result| with_unit(&result.name, &result.unit));
        text += &wrapped("    ", inputs);
        text += &wrapped("    -> ", results);
    }
    let _ = writeln!(text, "{}", counted(kernels.len(), "kernel"));
    text
}

/// Names with commas between, in lines that break between names only.
fn wrapped(lead: &str, names: impl Iterator<Item = String>) -> String {
    let (mut text, mut line) = (String::new(), lead.to_owned());
    let mut names = names.peekable();
    while let Some(name) = names.next() {
        let name = if names.peek().is_some() { format!("{name},") } else { name };
        if !line.ends_with(lead) && line.chars().count() + 1 + name.chars().count() > WIDTH {
            let _ = writeln!(text, "{line}");
            line = " ".repeat(lead.len());
        } else if line != lead {
            line.push(' ');
        }
        line += &name;
    }
    let _ = writeln!(text, "{line}");
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;
    use closedform_project::drawn::{drawn, has};

    #[test]
    fn every_kernel_has_its_lines() {
        let (_folder, catalogue) = fixture::catalogue();
        let text = text(&kernels(&catalogue, None).unwrap());
        has(
            &text,
            &["line::root  3.5 ulp\n    a_max [s], b [s^2]\n    -> root [s]\n", "plane::slope", "d [m]", "3 kernels"],
        );
    }

    #[test]
    fn a_family_is_listed_alone_and_a_wrong_one_named() {
        let (_folder, catalogue) = fixture::catalogue();
        let names = |family: &str| kernels(&catalogue, Some(family)).map(|found| found.len());
        assert_eq!((names("line").unwrap(), names("plane").unwrap()), (2, 1));
        has(&drawn(names("lin").unwrap_err().as_ref()), &["no family is called `lin`", "did you mean line"]);
        let help = |name: &str| drawn(names(name).unwrap_err().as_ref());
        has(&help("root"), &["it is a kernel: `closedform show line::root`"]);
        has(&help("slope"), &["several kernels: `closedform show` tells of line::slope, plane::slope"]);
        assert!(!help("nothing_alike").contains("did you mean"));
    }

    #[test]
    fn lines_break_between_names() {
        let names: Vec<String> = (0..30).map(|number| format!("a_rather_long_name_{number} [m/s^2]")).collect();
        let text = wrapped("    -> ", names.iter().cloned());
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
        names.iter().for_each(|name| assert!(text.contains(name), "{name}"));
        assert!(
            text.starts_with("    -> a_rather_long_name_0 [m/s^2],")
                && text.lines().skip(1).all(|line| line.starts_with("       a"))
        );
        let long = "x".repeat(100);
        assert_eq!(wrapped("    ", [long.clone()].into_iter()), format!("    {long}\n"));
    }
}
