//! Descriptions: what is known of a kernel, as programs read it.

use serde::{Serialize, Serializer};

use closedform_measure::catalogue::{Entry, maxima_name, unit_of};
use closedform_project::domain::Condition;
use closedform_syntax::Operations;

/// What is known of a kernel.
#[derive(Clone, Debug, Serialize)]
pub struct Description {
    /// `family::name`
    pub kernel: String,
    /// One sentence.
    pub summary: String,
    /// The inputs, in order.
    pub inputs: Vec<InputDescription>,
    /// The conditions that inputs must meet besides being finite.
    pub domain: Vec<String>,
    /// The results, in order.
    pub results: Vec<ResultDescription>,
    /// The closed form as Maxima text, one definition a line.
    pub maxima: Option<String>,
    /// The closed form as LaTeX.
    pub latex: Option<String>,
    /// Where the formula is derived.
    pub source: Option<String>,
    /// The rewrites that keep its digits.
    pub rules: Vec<String>,
    /// What it computes in: `double`, or `double-double`, rounded once at the end.
    pub precision: &'static str,
    /// What one evaluation costs.
    pub operations: OperationCounts,
}

/// What is known of an input.
#[derive(Clone, Debug, Serialize)]
pub struct InputDescription {
    /// Its name in Rust.
    pub name: String,
    /// Its name in the worksheet.
    pub maxima: String,
    /// Its unit; `"1"` for a number.
    pub unit: String,
    /// The range of magnitudes to expect.
    pub typical: Option<[f64; 2]>,
    /// The conditions that mention only it.
    pub domain: Vec<String>,
}

/// What is known of a result.
#[derive(Clone, Debug, Serialize)]
pub struct ResultDescription {
    /// Its field, or the kernel.
    pub name: String,
    /// The function of the worksheet.
    pub worksheet: Option<String>,
    /// Its unit; `"1"` for a number.
    pub unit: String,
    /// The error in ulp that it never exceeds.
    pub bound_ulp: Option<f64>,
}

/// How many operations one evaluation takes, by their keys.
#[derive(Clone, Copy, Debug)]
pub struct OperationCounts(Operations);

impl Serialize for OperationCounts {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.named().map(|(key, _, count)| (key, count)))
    }
}

impl Description {
    /// Describes a kernel.
    pub fn of(entry: &Entry) -> Self {
        let meta = &entry.kernel.meta;
        Self {
            kernel: entry.full_name(),
            summary: meta.summary.clone(),
            inputs: inputs(entry),
            domain: entry.kernel.requires.iter().map(|require| require.text.clone()).collect(),
            results: results(entry),
            maxima: meta.maxima.clone(),
            latex: meta.latex.clone(),
            source: meta.source.clone(),
            rules: meta.rules.clone(),
            precision: meta.precision.name(),
            operations: OperationCounts::of(entry),
        }
    }
}

impl OperationCounts {
    fn of(entry: &Entry) -> Self {
        Self(closedform_syntax::operations(&entry.kernel))
    }

    /// The kinds that occur, with their numbers.
    pub fn in_words(&self) -> String {
        let present = self.0.named().filter(|(.., count)| *count > 0);
        let present: Vec<String> =
            present.map(|(_, kind, count)| format!("{count} {kind}{}", if count == 1 { "" } else { "s" })).collect();
        if present.is_empty() { "none".to_owned() } else { present.join(", ") }
    }
}

fn inputs(entry: &Entry) -> Vec<InputDescription> {
    let inputs = entry.kernel.inputs.iter().enumerate();
    inputs
        .map(|(position, input)| InputDescription {
            name: input.name.to_string(),
            maxima: maxima_name(input),
            unit: unit_of(&input.unit).to_owned(),
            typical: input.typical.map(|(low, high)| [low, high]),
            domain: conditions_on(entry, position),
        })
        .collect()
}

/// The conditions that mention this input and no other; a text that is not one of a contract is not counted.
fn conditions_on(entry: &Entry, input: usize) -> Vec<String> {
    let inputs = entry.kernel.inputs.len();
    let alone = entry
        .conditions()
        .filter(|(_, condition)| condition.as_ref().is_ok_and(|condition| mentions_only(condition, input, inputs)));
    alone.map(|(text, _)| text.to_owned()).collect()
}

fn mentions_only(condition: &Condition, input: usize, inputs: usize) -> bool {
    let comparisons = condition.comparisons();
    let mentioned = |variable: usize| comparisons.iter().any(|comparison| comparison.uses(variable));
    (0..inputs).all(|variable| mentioned(variable) == (variable == input))
}

fn results(entry: &Entry) -> Vec<ResultDescription> {
    let results = entry.kernel.meta.results.iter();
    results
        .map(|result| ResultDescription {
            name: result.name.to_string(),
            worksheet: result.worksheet.clone(),
            unit: unit_of(&result.unit).to_owned(),
            bound_ulp: result.bound,
        })
        .collect()
}

/// A name with its unit in brackets; a number has none.
pub fn with_unit(name: &str, unit: &str) -> String {
    if unit == "1" { name.to_owned() } else { format!("{name} [{unit}]") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;

    #[test]
    fn a_description_says_everything() {
        let (_folder, catalogue) = fixture::catalogue();
        let described = Description::of(catalogue.find("line::root").unwrap());
        assert_eq!(described.summary, "Where a parabola ends.");
        assert_eq!(described.inputs[0].domain, ["aMax >= 0"]);
        assert_eq!(described.inputs[1].domain, ["b > 0"]);
        assert_eq!(described.domain.len(), 3);
        let json = serde_json::to_value(&described).unwrap();
        assert_eq!(json["kernel"], "line::root");
        assert_eq!(json["inputs"][0]["maxima"], "aMax");
        assert_eq!(json["results"][0]["bound_ulp"], 3.5);
        assert_eq!(json["operations"]["sqrt"], 1);
        assert_eq!((&json["source"], &json["precision"]), (&"1.1 %o2".into(), &"double".into()));
        assert_eq!(described.operations.in_words(), "2 additions, 1 multiplication, 1 division, 1 square root");
    }
}
