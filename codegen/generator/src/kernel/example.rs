//! Examples for documentation: a golden value of a kernel whose numbers read well.

use crate::rust::ExampleText;
use closedform_project::contract::KernelContract;
use closedform_project::golden::GoldenValue;
use std::ops::Range;

/// Magnitudes of results that no digit is lost of.
const NORMAL: Range<f64> = 1e-290..1e290;

/// The example of a kernel among golden values: all results of one point.
#[must_use]
pub fn golden_example(kernel: &KernelContract, golden: &[GoldenValue]) -> Option<ExampleText> {
    let first = kernel.results.first()?;
    let points = golden.iter().filter(|value| value.worksheet == first.worksheet).map(|value| &value.inputs);
    let examples = points.filter_map(|point| example_at(kernel, golden, point));
    examples.min_by_key(|example| (!reads_well(example), letters(example)))
}

fn example_at(kernel: &KernelContract, golden: &[GoldenValue], point: &[(String, f64)]) -> Option<ExampleText> {
    let number = |name: &String| point.iter().find(|(known, _)| known == name).map(|(_, number)| *number);
    let result = |worksheet: &str| {
        let value = golden.iter().find(|value| value.worksheet == worksheet && value.inputs == point)?;
        value.value.parse::<f64>().ok()
    };
    Some(ExampleText {
        inputs: kernel.inputs.iter().map(number).collect::<Option<_>>()?,
        results: kernel.results.iter().map(|contract| result(&contract.worksheet)).collect::<Option<_>>()?,
    })
}

fn reads_well(example: &ExampleText) -> bool {
    example.results.iter().all(|result| NORMAL.contains(&result.abs()))
}

fn letters(example: &ExampleText) -> usize {
    example.inputs.iter().chain(&example.results).map(|number| format!("{number:?}").len()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_project::contract::parse;
    use closedform_project::golden;
    use std::path::Path;

    const CONTRACT: &str = "[family]\ntitle = \"t\"\nsource = \"s\"\n[inputs]\na = { name = \"a\", unit = \"1\", typical = [0.1, \
                            1.0] }\n[[kernel]]\nname = \"k\"\ndoc = \"d\"\nreturns = \"R\"\ninputs = [\"a\"]\ndomain = [\"a > 0\"]\n\
                            [[kernel.result]]\nname = \"x\"\nworksheet = \"x\"\nunit = \"1\"\n\
                            [[kernel.result]]\nname = \"y\"\nworksheet = \"y\"\nunit = \"1\"\n";

    #[test]
    fn the_shortest_point_with_all_results_is_the_example() {
        let contract = parse(Path::new("k.toml"), CONTRACT).unwrap();
        let example =
            |text: &str| golden_example(&contract.kernels[0], &golden::parse(Path::new("k.tsv"), text).unwrap());
        let long = "x\ta=0x1.921fb54442d18p+1\t1.5e0\ny\ta=0x1.921fb54442d18p+1\t2.5e0\n";
        let short = "x\ta=0x1p-1\t7.5e-1\ny\ta=0x1p-1\t1e-1\n";
        let lost = "x\ta=0x1p+0\t0e0\ny\ta=0x1p+0\t1e0\n";
        let half = "x\ta=0x1p+1\t1e0\n";
        let found = example(&[long, short, lost, half].concat()).unwrap();
        assert_eq!(found, ExampleText { inputs: vec![0.5], results: vec![0.75, 0.1] });
        assert_eq!(example(&[lost, half].concat()).unwrap().results, [0.0, 1.0]);
        assert_eq!((example(half), example("")), (None, None));
    }
}
