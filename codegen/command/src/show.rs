//! `closedform show KERNEL`: everything about one kernel on a page.

use std::fmt::Write as _;

use serde::Serialize;

use super::description::{Description, InputDescription, ResultDescription, with_unit};
use closedform_generator::stable::rule::Rule;
use closedform_generator::stable::strategy;
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_project::Project;
use closedform_system::output;

/// Show one kernel: formula, inputs, domain, bound, rules and Rust text
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// `family::name`, the name alone, or the worksheet's name of a result
    kernel: String,
    /// Write JSON
    #[arg(long)]
    json: bool,
}

/// A page about a kernel.
#[derive(Debug, Serialize)]
struct Page {
    #[serde(flatten)]
    description: Description,
    /// What its rules say, as far as they are the generator's.
    rules_in_words: Vec<RuleInWords>,
    rust: String,
}

/// A rule with what it does.
#[derive(Debug, Serialize)]
struct RuleInWords {
    name: &'static str,
    statement: &'static str,
    condition: &'static str,
}

/// Shows a kernel.
///
/// # Errors
///
/// When there is no such kernel, or kernels cannot be read.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let catalogue = Catalogue::open(project)?;
    let entry = catalogue.find(&args.kernel)?;
    let page = Page::of(entry);
    if args.json {
        output::print_json(&page)?
    } else {
        output::print(&page.text())?
    }
    Ok(())
}

impl Page {
    fn of(entry: &Entry) -> Self {
        let description = Description::of(entry);
        let rules = strategy::rules_named(description.rules.iter().map(String::as_str)).into_iter();
        let in_words = |&Rule { name, statement, condition }: &Rule| RuleInWords { name, statement, condition };
        Self { rules_in_words: rules.map(in_words).collect(), description, rust: entry.rust.clone() }
    }

    fn text(&self) -> String {
        let Description {
            kernel, summary, inputs, domain, results, maxima, source, rules, precision, operations, ..
        } = &self.description;
        let mut text = format!("{kernel}\n{summary}\n");
        section(&mut text, "Formula", maxima.iter().flat_map(|maxima| maxima.lines().map(str::to_owned)));
        section(&mut text, "Inputs", inputs.iter().map(input_line));
        let finite = "all inputs are finite".to_owned();
        section(&mut text, "Domain", [finite].into_iter().chain(domain.iter().cloned()));
        section(&mut text, "Results", results.iter().map(result_line));
        section(&mut text, "Rules", rules.iter().flat_map(|rule| self.rule_lines(rule)));
        section(&mut text, "Operations", [format!("{}, in {precision}", operations.in_words())]);
        section(&mut text, "Derived in", source.iter().filter(|source| !source.is_empty()).cloned());
        let _ = writeln!(text, "\nRust\n\n{}", self.rust);
        text
    }

    /// A rule's name, and what it says if it is known.
    fn rule_lines(&self, name: &str) -> Vec<String> {
        match self.rules_in_words.iter().find(|rule| rule.name == name) {
            Some(rule) => vec![format!("{name}: {}", rule.statement), format!("  when: {}", rule.condition)],
            None => vec![name.to_owned()],
        }
    }
}

/// A heading and its lines; nothing where there are no lines.
fn section(text: &mut String, heading: &str, lines: impl IntoIterator<Item = String>) {
    let lines: String = lines.into_iter().map(|line| format!("  {line}\n")).collect();
    if !lines.is_empty() {
        let _ = write!(text, "\n{heading}\n{lines}");
    }
}

fn input_line(input: &InputDescription) -> String {
    let typical = input.typical.map(|[low, high]| format!(", typically {low:?} to {high:?}")).unwrap_or_default();
    let name =
        if input.maxima == input.name { input.name.clone() } else { format!("{} ({})", input.name, input.maxima) };
    format!("{}{typical}", with_unit(&name, &input.unit))
}

fn result_line(result: &ResultDescription) -> String {
    let worksheet = result.worksheet.as_ref().map(|worksheet| format!(" ({worksheet})")).unwrap_or_default();
    let bound = result.bound_ulp.map(|bound| format!(", at most {bound} ulp")).unwrap_or_default();
    format!("{}{bound}", with_unit(&format!("{}{worksheet}", result.name), &result.unit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;

    fn page(kernel: &str) -> Page {
        let (_folder, catalogue) = fixture::catalogue();
        let entry = catalogue.find(kernel).unwrap();
        Page::of(entry)
    }

    #[test]
    fn the_page_says_everything() {
        let text = page("line::root").text();
        for part in [
            "line::root\nWhere a parabola ends.\n",
            "\nFormula\n  rootFn(aMax,b):=sqrt(aMax^2+b)-aMax\n",
            "  a_max (aMax) [s], typically 0.001 to 1000.0\n  b [s^2]",
            "\nDomain\n  all inputs are finite\n  aMax >= 0\n",
            "\nResults\n  root (rootFn) [s], at most 3.5 ulp\n",
            "\nRules\n  conjugate: a + b*sqrt(r) = (a^2 - b^2*r)/(a - b*sqrt(r))\n    when: a and b*sqrt(r) are of opposite signs",
            "\nDerived in\n  1.1 %o2\n",
            "\nRust\n\npub fn root(\n",
            "    b / (sqrt(a_max * a_max + b) + a_max)\n}\n",
        ] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
    }

    #[test]
    fn programs_read_the_same() {
        let json = serde_json::to_value(page("plane::slope")).unwrap();
        assert_eq!(json["kernel"], "plane::slope");
        assert_eq!(json["results"][1]["name"], "d");
        assert!(json["rust"].as_str().unwrap().starts_with("pub fn slope("));
        let json = serde_json::to_value(page("line::root")).unwrap();
        assert_eq!((&json["rules"][0], &json["rules_in_words"][0]["name"]), (&"conjugate".into(), &"conjugate".into()));
        assert!(json["rules_in_words"][0]["condition"].as_str().unwrap().contains("opposite signs"));
    }

    #[test]
    fn a_rule_of_somebody_else_has_its_name_only() {
        let mut page = page("line::root");
        page.description.rules = vec!["by hand".to_owned()];
        assert!(page.text().contains("\nRules\n  by hand\n\n"));
    }
}
