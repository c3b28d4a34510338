//! `src/about.rs` of the binding crate: what is known of every kernel.

use super::text::{number, rust_c_string};
use crate::library::{Bound, Library, Quantity};
use crate::lines::Lines;

/// The tables.
pub fn about(library: &Library) -> String {
    let mut lines = Lines::default();
    lines.line("//! What is known of every kernel, in the order of the crate's root.").line("");
    lines.line("use crate::info::{Constant, Info, Input, ResultInfo, Words};").line("use core::ffi::CStr;").line("");
    lines.line("const fn words(text: &'static CStr) -> Words {");
    lines.indented(|lines| _ = lines.line("Constant(text.as_ptr())")).line("}").line("");
    for (position, kernel) in library.kernels.iter().enumerate() {
        parts(&mut lines, position, kernel);
    }
    lines.line(format!("pub static ABOUT: [Info; {}] = [", library.kernels.len()));
    lines.indented(|lines| {
        library.kernels.iter().enumerate().for_each(|(position, kernel)| whole(lines, position, kernel));
    });
    lines.line("];");
    lines.text()
}

fn parts(lines: &mut Lines, position: usize, kernel: &Bound) {
    table(lines, &format!("INPUTS_{position}: [Input; {}]", kernel.inputs.len()), kernel.inputs.iter().map(input));
    let domain = kernel.domain.iter().map(|condition| words(condition));
    table(lines, &format!("DOMAIN_{position}: [Words; {}]", kernel.domain.len()), domain);
    let results = kernel.results.iter().map(result);
    table(lines, &format!("RESULTS_{position}: [ResultInfo; {}]", kernel.results.len()), results);
}

fn table(lines: &mut Lines, declared: &str, entries: impl Iterator<Item = String>) {
    lines.line(format!("static {declared} = ["));
    lines.indented(|lines| entries.for_each(|entry| _ = lines.line(entry + ",")));
    lines.line("];");
}

fn whole(lines: &mut Lines, position: usize, kernel: &Bound) {
    let meta = &kernel.kernel.meta;
    let optional = |text: &Option<String>| words(text.as_deref().unwrap_or_default());
    lines.line("Info {").indented(|lines| {
        lines.line(format!("name: {},", words(&kernel.full_name())));
        lines.line(format!("summary: {},", words(&meta.summary)));
        lines.line(format!("maxima: {},", optional(&meta.maxima)));
        lines.line(format!("latex: {},", optional(&meta.latex)));
        lines.line(format!("source: {},", optional(&meta.source)));
        lines.line(format!("precision: {},", words(meta.precision.name())));
        for (field, table, count) in
            [("input", "inputs", "INPUTS"), ("domain", "domain", "DOMAIN"), ("result", "results", "RESULTS")]
        {
            lines.line(format!("{table}: Constant({count}_{position}.as_ptr()),"));
            lines.line(format!("{field}_count: {count}_{position}.len(),"));
        }
        lines.line(format!("ordinary: {},", kernel.ordinary));
    });
    lines.line("},");
}

fn input(input: &Quantity) -> String {
    let [least, most] = input.typical.map(number);
    format!("Input {{ {}, typical_least: {least}, typical_most: {most} }}", common(input))
}

fn result(result: &Quantity) -> String {
    let bound = result.bound.map_or_else(|| "f64::NAN".to_owned(), number);
    format!("ResultInfo {{ {}, bound_ulp: {bound} }}", common(result))
}

fn common(quantity: &Quantity) -> String {
    let [name, worksheet, unit] = [&quantity.name, &quantity.worksheet, &quantity.unit].map(|text| words(text));
    format!("name: {name}, worksheet: {worksheet}, unit: {unit}")
}

fn words(text: &str) -> String {
    format!("words({})", rust_c_string(text))
}
