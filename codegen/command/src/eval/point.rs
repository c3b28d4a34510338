//! One point: its results as text or JSON.

use std::fmt::Write as _;

use closedform_syntax::Violation;
use miette::Diagnostic;
use rug::Float;
use serde::Serialize;
use thiserror::Error;

use super::{digits, inputs};
use closedform_measure::accuracy::{self, Reference, ulp_error, ulp_text};
use closedform_measure::catalogue::{Entry, unit_of};
use closedform_project::hexfloat;
use closedform_system::output;

/// A point outside of the domain.
#[derive(Debug, Error, Diagnostic)]
#[error("`{kernel}`: outside the domain: {violated} does not hold for {inputs}")]
#[diagnostic(help("the kernel promises values where {domain}"))]
pub struct OutsideDomain {
    /// The kernel.
    pub kernel: String,
    /// The condition.
    pub violated: String,
    /// Names and values.
    pub inputs: String,
    /// All conditions.
    pub domain: String,
}

/// What a kernel returns at a point.
#[derive(Debug, Serialize)]
struct Evaluation {
    kernel: String,
    inputs: Vec<Number>,
    results: Vec<Outcome>,
    /// Whether the promise of the bound covers the point.
    covered: bool,
}

/// A named number, exactly.
#[derive(Debug, Serialize)]
struct Number {
    name: String,
    unit: String,
    value: f64,
    hex: String,
}

/// A result, and what it should be.
#[derive(Debug, Serialize)]
struct Outcome {
    #[serde(flatten)]
    number: Number,
    worksheet: Option<String>,
    bound_ulp: Option<f64>,
    #[serde(flatten)]
    truth: Option<Truth>,
}

/// The true value of a result.
#[derive(Debug, Serialize)]
struct Truth {
    exact: String,
    ulp: f64,
}

/// Evaluates the kernel at the point that `name=value` arguments describe.
///
/// # Errors
///
/// When the arguments do not fit, or the point lies outside of the domain.
pub fn run(entry: &Entry, arguments: &[String], digits: Option<u32>, json: bool) -> miette::Result<()> {
    let point = inputs::point(entry, arguments)?;
    let evaluation = evaluate(entry, &point, digits)?;
    if json {
        output::print_json(&evaluation)?
    } else {
        output::print(&evaluation.text())?
    }
    Ok(())
}

fn evaluate(entry: &Entry, point: &[f64], digits: Option<u32>) -> miette::Result<Evaluation> {
    let kernel = &entry.kernel;
    let results = accuracy::results(kernel, point).map_err(|violation| outside(entry, point, violation))?;
    let truths = match digits {
        Some(digits) => Reference::of(kernel)?.values(point, digits::bits(digits))?.into_iter().map(Some).collect(),
        None => vec![None; results.len()],
    };
    let outcome = |(position, (value, truth)): (usize, (f64, Option<Float>))| {
        let meta = &kernel.meta.results[position];
        Outcome {
            number: Number::new(meta.name.to_string(), unit_of(&meta.unit), value),
            worksheet: meta.worksheet.clone(),
            bound_ulp: meta.bound,
            truth: truth.zip(digits).map(|(truth, digits)| Truth::new(value, &truth, digits)),
        }
    };
    let inputs = kernel.inputs.iter().zip(point);
    Ok(Evaluation {
        kernel: entry.full_name(),
        inputs: inputs
            .map(|(input, value)| Number::new(input.name.to_string(), unit_of(&input.unit), *value))
            .collect(),
        results: results.into_iter().zip(truths).enumerate().map(outcome).collect(),
        covered: accuracy::covers(kernel, point),
    })
}

/// Why the kernel refuses the point.
pub fn outside(entry: &Entry, point: &[f64], violation: Violation) -> OutsideDomain {
    let domain: Vec<&str> = entry.kernel.requires.iter().map(|require| require.text.as_str()).collect();
    let all = ["all inputs are finite"].into_iter().chain(domain).collect::<Vec<_>>().join("; ");
    OutsideDomain {
        kernel: entry.full_name(),
        violated: violated_text(entry, violation),
        inputs: values_text(entry, point),
        domain: all,
    }
}

/// The condition that is violated.
pub fn violated_text(entry: &Entry, violation: Violation) -> String {
    match violation {
        Violation::NotFinite(input) => format!("`{} is finite`", entry.kernel.inputs[input].name),
        Violation::Require(position) => format!("`{}`", entry.kernel.requires[position].text),
    }
}

fn values_text(entry: &Entry, point: &[f64]) -> String {
    let values = entry.kernel.inputs.iter().zip(point);
    let values = values.map(|(input, value)| format!("{} = {value:?} ({})", input.name, hexfloat::print(*value)));
    values.collect::<Vec<_>>().join(", ")
}

impl Number {
    fn new(name: String, unit: &str, value: f64) -> Self {
        Self { name, unit: unit.to_owned(), value, hex: hexfloat::print(value) }
    }

    fn text(&self) -> String {
        let unit = if self.unit == "1" { "" } else { &self.unit };
        format!("{} = {:?} {unit}", self.name, self.value).trim_end().to_owned()
    }
}

impl Truth {
    fn new(value: f64, truth: &Float, digits: u32) -> Self {
        Self { exact: digits::decimal(truth, digits), ulp: ulp_error(value, truth) }
    }
}

impl Evaluation {
    fn text(&self) -> String {
        let mut text = String::new();
        for result in &self.results {
            let _ = writeln!(text, "{}\n    hex    {}", result.number.text(), result.number.hex);
            if let Some(truth) = &result.truth {
                let bound = result.bound_ulp.map(|bound| format!(" (bound {bound})")).unwrap_or_default();
                let _ = writeln!(text, "    exact  {}\n    error  {} ulp{bound}", truth.exact, ulp_text(truth.ulp));
            }
        }
        if !self.covered {
            text += "The bound does not cover this point: a result over- or underflows.\n";
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;

    fn evaluated(kernel: &str, point: &[f64], digits: Option<u32>) -> miette::Result<Evaluation> {
        let (_folder, catalogue) = fixture::catalogue();
        evaluate(catalogue.find(kernel).unwrap(), point, digits)
    }

    #[test]
    fn a_result_is_exact_in_hex() {
        let text = evaluated("line::root", &[0.0, 4.0], None).unwrap().text();
        assert_eq!(text, "root = 2.0 s\n    hex    0x1p+1\n");
    }

    #[test]
    fn digits_stand_beside_the_result() {
        let evaluation = evaluated("plane::slope", &[1.0], Some(30)).unwrap();
        let text = evaluation.text();
        assert!(text.contains("d = 0.3333333333333333 m\n    hex    0x1.5555555555555p-2\n"), "{text}");
        assert!(
            text.contains("    exact  3.33333333333333333333333333333e-1\n    error  0.334 ulp (bound 0.5)\n"),
            "{text}"
        );
        let json = serde_json::to_value(&evaluation).unwrap();
        assert_eq!(json["results"][0]["ulp"], 0.0);
        assert_eq!(json["results"][1]["name"], "d");
        assert_eq!(json["inputs"][0]["hex"], "0x1p+0");
    }

    #[test]
    fn points_outside_name_the_condition() {
        let message = |point: &[f64]| evaluated("line::root", point, None).unwrap_err().to_string();
        let expected =
            "`line::root`: outside the domain: `aMax >= 0` does not hold for a_max = -1.0 (-0x1p+0), b = 2.0 (0x1p+1)";
        assert_eq!(message(&[-1.0, 2.0]), expected);
        assert!(message(&[1.0, f64::INFINITY]).contains("`b is finite` does not hold"));
    }

    #[test]
    fn a_point_beyond_the_bound_says_so() {
        let text = evaluated("line::root", &[1e300, 1e-10], None).unwrap().text();
        assert!(text.contains("The bound does not cover this point"));
    }
}
