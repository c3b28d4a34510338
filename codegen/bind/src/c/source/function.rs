//! A kernel as a function of C: checks of the inputs, the domain, the steps, the results.

use super::expression::{Arithmetic, Printer};
use crate::c::names::{KernelNames, scope_with};
use crate::library::Bound;
use crate::lines::Lines;
use closedform_syntax::{Expr, Precision};

/// Names of variables besides inputs, steps and results.
const OWN: [&str; 2] = ["escalate", "inside"];

/// The head of the function.
pub fn signature(names: &KernelNames) -> String {
    let inputs = names.inputs.iter().map(|input| format!("double {input}"));
    let results = names.results.iter().map(|result| format!("double *{result}"));
    format!("int {}({})", names.tier1, inputs.chain(results).collect::<Vec<_>>().join(", "))
}

/// The function; its constants begin with `constants`.
pub fn function(lines: &mut Lines, kernel: &Bound, names: &KernelNames, constants: &str) {
    let arithmetic = match kernel.kernel.meta.precision {
        Precision::Double => Arithmetic::Double,
        Precision::DoubleDouble | Precision::Certified => Arithmetic::DoubleDouble,
    };
    let variables = Variables::new(kernel, names, arithmetic);
    lines.wrapped("", &signature(names)).line("{").indented(|lines| {
        lines.line(format!("unsigned {} = 0;", variables.escalate)).line(format!("int {};", variables.inside));
        let printer = Printer { arithmetic, names: &variables.names, escalate: &variables.escalate };
        checks(lines, kernel, names, &variables, constants);
        domain(lines, kernel, names, &variables, &printer, constants);
        steps(lines, kernel, &variables, &printer);
        let refused = format!("return {constants}_NOT_SETTLED;");
        lines.line(format!("if ({}) {{", variables.escalate)).indented(|lines| _ = lines.line(refused)).line("}");
        results(lines, names, &variables, arithmetic);
        lines.line(format!("return {constants}_SETTLED;"));
    });
    lines.line("}");
}

/// The names of a function's variables.
struct Variables {
    /// Of inputs and steps, by their slots.
    names: Vec<String>,
    /// The variable that is raised, and the one that says whether the domain holds the inputs.
    escalate: String,
    inside: String,
    /// Of results.
    values: Vec<String>,
}

impl Variables {
    fn new(kernel: &Bound, names: &KernelNames, arithmetic: Arithmetic) -> Self {
        let taken: Vec<String> = names.inputs.iter().chain(&names.results).cloned().collect();
        let mut scope = scope_with(&taken);
        let [escalate, inside] = OWN.map(|own| scope.name(own));
        let inputs = names.inputs.iter().map(|input| match arithmetic {
            Arithmetic::Double => input.clone(),
            Arithmetic::DoubleDouble => scope.name(&format!("{input}_dd")),
        });
        let mut all: Vec<String> = inputs.collect();
        all.extend(kernel.kernel.lets.iter().map(|step| scope.name(&own(&step.name.to_string()))));
        let values = kernel.results.iter().map(|result| scope.name(&own(&format!("{}_value", result.name)))).collect();
        Self { names: all, escalate, inside, values }
    }
}

/// A name that is none of `arithmetic.h`.
fn own(name: &str) -> String {
    if name.to_lowercase().starts_with("cf_") { format!("{name}_own") } else { name.to_owned() }
}

/// That results can be written and inputs are finite and of ordinary magnitudes.
fn checks(lines: &mut Lines, kernel: &Bound, names: &KernelNames, variables: &Variables, constants: &str) {
    let null: Vec<String> = names.results.iter().map(|result| format!("!{result}")).collect();
    leave(lines, &null.join(" || "), &format!("{constants}_NULL"));
    names.results.iter().for_each(|result| _ = lines.line(format!("*{result} = (double)NAN;")));
    let infinite: Vec<String> = names.inputs.iter().map(|input| format!("!cf_is_finite({input})")).collect();
    leave(lines, &infinite.join(" || "), &format!("{constants}_OUTSIDE"));
    for input in &names.inputs {
        let (k, escalate) = (kernel.ordinary, &variables.escalate);
        lines.line(format!("{escalate} |= (unsigned)!cf_ordinary({input}, 0x1p-{k}, 0x1p+{k});"));
    }
}

fn leave(lines: &mut Lines, condition: &str, status: &str) {
    lines.wrapped("", &format!("if ({condition}) {{"));
    lines.indented(|lines| _ = lines.line(format!("return {status};"))).line("}");
}

fn domain(
    lines: &mut Lines,
    kernel: &Bound,
    names: &KernelNames,
    variables: &Variables,
    printer: &Printer,
    constants: &str,
) {
    if printer.arithmetic == Arithmetic::DoubleDouble {
        for (input, variable) in names.inputs.iter().zip(&variables.names) {
            lines.line(format!("const cf_dd {variable} = cf_dd_input({input}, &{});", variables.escalate));
        }
    }
    let inside = &variables.inside;
    lines.line(format!("{inside} = 1;"));
    for require in &kernel.kernel.requires {
        lines.wrapped("", &format!("{inside} &= {};", printer.condition(&require.condition)));
    }
    leave(lines, &variables.escalate, &format!("{constants}_NOT_SETTLED"));
    leave(lines, &format!("!{inside}"), &format!("{constants}_OUTSIDE"));
}

fn steps(lines: &mut Lines, kernel: &Bound, variables: &Variables, printer: &Printer) {
    let number = printer.arithmetic.number();
    let steps = variables.names.iter().skip(kernel.inputs.len()).zip(kernel.kernel.lets.iter().map(|step| &step.value));
    let results = variables.values.iter().zip(kernel.kernel.output.values());
    for (name, value) in steps.chain(results) {
        lines.wrapped("", &format!("const {number} {name} = {};", printer.expression(value)));
    }
    let mut used = vec![false; variables.names.len()];
    kernel.kernel.visit(&mut |expr| {
        if let Expr::Name(name) = expr {
            used[name.slot] = true;
        }
    });
    for (name, _) in variables.names.iter().zip(used).filter(|(_, used)| !used) {
        lines.line(format!("(void){name};"));
    }
}

fn results(lines: &mut Lines, names: &KernelNames, variables: &Variables, arithmetic: Arithmetic) {
    let part = if arithmetic == Arithmetic::DoubleDouble { ".high" } else { "" };
    for (result, value) in names.results.iter().zip(&variables.values) {
        lines.line(format!("*{result} = {value}{part};"));
    }
}
