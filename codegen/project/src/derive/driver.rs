//! The driver: Maxima statements that make a worksheet tell its functions and their values.

use std::fmt::Write;

use num_rational::BigRational;

use super::super::contract::Contract;

/// Values to compute: some results of one kernel at points.
pub(super) struct Task {
    /// Worksheet functions.
    pub(super) results: Vec<String>,
    /// Their parameters.
    pub(super) inputs: Vec<String>,
    /// Points, one coordinate a parameter.
    pub(super) points: Vec<Vec<f64>>,
    /// How many points must have values before the rest is left.
    pub(super) wanted: usize,
}

/// Says the version, and defines `string` of a value: of an expression it would evaluate what stands there once more.
const PROLOGUE: &str = "closedform_say(sconcat(\"version|\", closedform_version()))$\n\
                        closedform_spell(closedform_value) := string(closedform_value)$\n";

/// Functions that compute values at points: `closedform_value(expression, symbols, numbers)` and what it needs.
pub const VALUES: &str = include_str!("evaluate.mac");

/// Statements that say Maxima's version, every result of the contract, and the values of the tasks.
pub(super) fn driver(contract: &Contract, tasks: &[Task]) -> String {
    let mut driver = String::from(PROLOGUE);
    for (kernel, result) in contract.results() {
        driver += &reference(&result.worksheet, &kernel.inputs);
    }
    if !tasks.is_empty() {
        driver += VALUES;
    }
    for (index, task) in tasks.iter().enumerate() {
        driver += &values(index, task);
    }
    driver
}

/// The head of a function, to compare its parameters, and its value for plain symbols.
fn reference(worksheet: &str, inputs: &[String]) -> String {
    let expression = expression(worksheet);
    format!(
        "closedform_head: errcatch(string(part(fundef({worksheet}), 1)))$\n\
         closedform_say(simplode(cons(\"head|{worksheet}|\", closedform_head)))$\n\
         {expression}: errcatch({worksheet}({symbols}))$\n\
         closedform_say(simplode(cons(\"reference|{worksheet}|\", map(closedform_spell, {expression}))))$\n",
        symbols = symbols(inputs),
    )
}

fn values(index: usize, task: &Task) -> String {
    let results: Vec<String> = task.results.iter().map(|result| expression(result)).collect();
    let mut points = String::new();
    for point in &task.points {
        let separator = if points.is_empty() { "" } else { ",\n" };
        let exact: Vec<String> = point.iter().map(|value| spell(*value)).collect();
        _ = write!(points, "{separator}[{}]", exact.join(", ")); // writing to a String cannot fail
    }
    let (results, symbols, wanted) = (results.join(", "), symbols(&task.inputs), task.wanted);
    format!(
        "if not member([], [{results}]) then closedform_golden({index}, map(first, [{results}]), [{symbols}], \
         [{points}], {wanted})$\n"
    )
}

/// The variable that holds a list of the function's expression, empty if it failed.
fn expression(worksheet: &str) -> String {
    format!("closedform_expression_{worksheet}")
}

/// Quoted, so that a value that the worksheet gave a variable is not put in.
fn symbols(inputs: &[String]) -> String {
    inputs.iter().map(|input| format!("'{input}")).collect::<Vec<_>>().join(", ")
}

/// The exact value of a finite float as a fraction.
fn spell(value: f64) -> String {
    BigRational::from_float(value).map_or_else(|| value.to_string(), |exact| format!("({exact})"))
}
