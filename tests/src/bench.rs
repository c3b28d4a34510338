//! The text of the bench's formulas: those of the references as they are written, compiled beside the kernels.

use std::fmt::Write as _;

use closedform_maxima::double_rust;

use crate::check::Judge;
use crate::kernels;

/// Where the text stands, from the root of the workspace.
pub const PATH: &str = "tests/benches/ratios/as_written.rs";

/// The formulas of all kernels whose references have plain forms, one rule of the macro each.
pub fn text() -> String {
    let mut text = String::from(
        "//! The formulas of the references as they are written, in Rust: what kernels are timed against.\n//!\n\
         //! Printed by `closedform_tests::bench::text`; a test of the documents tells when it is stale.\n\n\
         formulas! {\n",
    );
    for judge in kernels::judges() {
        let inputs: Vec<&str> = judge.kernel.info.inputs.iter().map(|input| input.name).collect();
        let Some(results) = results(&judge, &inputs) else { continue };
        _ = writeln!(text, "    \"{}\" [{}] => [", judge.kernel.info.name, inputs.join(", "));
        results.iter().for_each(|result| _ = writeln!(text, "        {result},"));
        text.push_str("    ];\n");
    }
    text.push_str("}\n");
    text
}

/// The results of a kernel, as expressions.
fn results(judge: &Judge, inputs: &[&str]) -> Option<Vec<String>> {
    judge.oracle.bodies().iter().map(|body| double_rust(body, judge.oracle.names(), inputs)).collect()
}
