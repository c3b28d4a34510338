//! The examples: a record that is processed as EPICS does, and a task of a controller without an operating system.

use super::names::{KernelNames, Names};
use super::text::{c_string, number};
use crate::library::{Bound, Library};

const RECORD: &str = include_str!("../../template/c/record.c");
const CONTROLLER: &str = include_str!("../../template/c/controller.c");

/// The kernel of the examples: the first one that returns a number, else the first one.
fn shown<'a>(library: &'a Library, names: &'a Names) -> Option<(&'a Bound, &'a KernelNames)> {
    let kernels = || library.kernels.iter().zip(&names.kernels);
    kernels().find(|(kernel, _)| kernel.returned.is_none()).or_else(|| kernels().next())
}

/// The record.
pub fn record(library: &Library, names: &Names) -> String {
    filled(RECORD, library, names)
}

/// The task.
pub fn controller(library: &Library, names: &Names) -> String {
    filled(CONTROLLER, library, names)
}

fn filled(template: &str, library: &Library, names: &Names) -> String {
    let Some((kernel, own)) = shown(library, names) else { return String::new() };
    let inputs = (0..kernel.inputs.len()).map(|position| format!("inputs[{position}]")).collect::<Vec<_>>().join(", ");
    let typical = kernel.inputs.iter().map(|input| number(middle(input.typical))).collect::<Vec<_>>().join(", ");
    let field =
        own.fields.first().filter(|_| kernel.returned.is_some()).map_or_else(String::new, |field| format!(".{field}"));
    template
        .replace("@PREFIX@", &names.prefix)
        .replace("@CONSTANT@", &names.constants())
        .replace("@CHECKED@", &own.checked)
        .replace("@CALL@", &own.call)
        .replace("@RETURNED@", &own.returned)
        .replace("@FIELD@", &field)
        .replace("@INPUTS@", &inputs)
        .replace("@TYPICAL@", &typical)
        .replace("@COUNT@", &kernel.inputs.len().to_string())
        .replace("@NAME@", &c_string(&kernel.full_name()))
}

/// A number in the middle of a range of magnitudes, of few digits.
fn middle([least, most]: [f64; 2]) -> f64 {
    let middle = (least * most).abs().sqrt();
    format!("{middle:.1e}").parse().unwrap_or(1.0)
}
