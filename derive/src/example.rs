//! Examples: a call of a kernel as its documentation shows it, which `cargo test` compiles and runs.

use closedform_syntax::{Example, Kernel, Output, ResultMeta};
use std::fmt::Write as _;

/// The relative error that `fast` keeps in kernels without a bound, too.
const PROMISE: f64 = 1e-13;

/// The longest line of code.
const WIDTH: usize = 100;

/// The section with the example; `None` where cargo does not say what users call the crate.
pub fn of(kernel: &Kernel, example: &Example) -> Option<String> {
    std::env::var("CARGO_CRATE_NAME").ok().map(|name| section(kernel, example, &name))
}

fn section(kernel: &Kernel, example: &Example, users_crate: &str) -> String {
    let path = &example.path;
    let name = path.rsplit("::").next().unwrap_or(path).trim();
    let result = if name == "result" { "value" } else { "result" };
    let metas = &kernel.meta.results;
    let call = if metas.iter().all(|meta| meta.bound.is_some()) { "call" } else { "fast" };
    let literal = literal(kernel, example, name);
    let mut code = format!("use {users_crate}::{path};\n\nlet {result} = {literal}.{call}();\n");
    if example.results.is_empty() {
        let _ = writeln!(code, "println!(\"{{{result}:?}}\");");
    }
    for (meta, expected) in metas.iter().zip(&example.results) {
        let found = match &kernel.output {
            Output::Value(_) => result.to_owned(),
            Output::Struct { .. } => format!("{result}.{}", meta.name),
        };
        let _ = writeln!(code, "{}", assertion(&found, meta, *expected));
    }
    format!("\n# Example\n\n```\n{code}```\n")
}

/// The struct of the inputs, in one line if that is not too long.
fn literal(kernel: &Kernel, example: &Example, name: &str) -> String {
    let fields = kernel.inputs.iter().zip(&example.inputs).map(|(input, value)| format!("{}: {value:?}", input.name));
    let fields: Vec<String> = fields.collect();
    let line = format!("{name}::Inputs {{ {} }}", fields.join(", "));
    if line.len() <= WIDTH - "let result = .call();".len() {
        return line;
    }
    format!("{name}::Inputs {{\n    {},\n}}", fields.join(",\n    "))
}

/// That a result is as near to what is known of it as is promised, and as that is rounded.
fn assertion(found: &str, meta: &ResultMeta, expected: f64) -> String {
    if expected == 0.0 {
        return format!("assert_eq!({found}, 0.0);");
    }
    let near = match meta.bound {
        Some(ulp) => (ulp + 0.5) * unit_in_the_last_place(expected),
        None => PROMISE * expected.abs(),
    };
    // two digits, rounded up
    format!("assert!(({found} - {expected:?}).abs() <= {:.1e});", near * 1.05).replace("- -", "+ ")
}

fn unit_in_the_last_place(value: f64) -> f64 {
    let exponent = (value.abs().to_bits() >> 52).max(1);
    f64::from_bits(exponent << 52) * f64::EPSILON
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernel(text: &str) -> Kernel {
        closedform_syntax::parse_file(text).unwrap().remove(0)
    }

    #[test]
    fn an_example_calls_by_name_and_holds_the_result_to_its_bound() {
        let text = "#[kernel(bound = 0.5, example(path = \"a::half\", inputs(3.0), results(1.5)))] fn half(x: f64) -> f64 { x / 2.0 }";
        let kernel = kernel(text);
        let example = kernel.meta.example.clone().unwrap();
        assert_eq!(
            section(&kernel, &example, "mine"),
            "\n# Example\n\n```\nuse mine::a::half;\n\nlet result = half::Inputs { x: 3.0 }.call();\n\
             assert!((result - 1.5).abs() <= 2.3e-16);\n```\n"
        );
    }

    #[test]
    fn what_is_negative_zero_or_unknown_is_no_less_readable() {
        let text = "#[kernel(example(path = \"f\", inputs(-1.0), results(-2.0, 0.0)))] fn f(x: f64) -> R { R { a: 2.0 * x, b: x + 1.0 } }";
        let mut kernel = kernel(text);
        let example = kernel.meta.example.take().unwrap();
        let section = |example: &Example| section(&kernel, example, "mine");
        assert!(
            section(&example).contains("f::Inputs { x: -1.0 }.fast();\nassert!((result.a + 2.0).abs() <= 2.1e-13);\n")
        );
        assert!(section(&example).contains("assert_eq!(result.b, 0.0);"));
        let unknown = Example { results: Vec::new(), ..example };
        assert!(section(&unknown).ends_with(".fast();\nprintln!(\"{result:?}\");\n```\n"));
    }
}
