//! `src/lib.rs` of the binding crate: a table of what is exported; the macros that make functions of it stand beside it.

use super::names::{KernelNames, Names};
use crate::library::{Bound, Library, plain};
use crate::lines::Lines;
use syn::Ident;

/// The crate's root.
pub fn library(library: &Library, names: &Names) -> String {
    let mut lines = Lines::default();
    head(&mut lines, library);
    for (position, (kernel, names)) in library.kernels.iter().zip(&names.kernels).enumerate() {
        let module = format!("{}::{}", library.package.import, module(&kernel.family));
        if let Some(returned) = &kernel.returned {
            let fields = rust_names(&kernel.results.iter().map(|result| result.name.clone()).collect::<Vec<_>>());
            lines.line(format!("returned! {{ {} from {module}::{returned} {{ {fields} }} }}", names.returned));
        }
        exported(&mut lines, position, kernel, names, &module);
    }
    list(&mut lines, names);
    lines.text()
}

fn head(lines: &mut Lines, library: &Library) {
    let package = &library.package.name;
    lines.line(format!(
        "//! The kernels of `{package}` for C; `include/` has the header, which documents every function."
    ));
    lines.line("//!");
    lines.line("//! `unsafe` stands in `boundary.rs`, `info.rs` and `export.rs`, each with its reason.");
    lines.line("").line("#![no_std]").line("#![deny(unsafe_op_in_unsafe_fn)]");
    lines.line(
        "#![allow(non_camel_case_types, non_snake_case, clippy::too_many_arguments, clippy::useless_conversion)]",
    );
    lines.line("").line("#[cfg(feature = \"std\")]").line("extern crate std;").line("");
    lines.line("#[macro_use]").line("mod export;").line("mod about;").line("mod boundary;").line("mod info;").line("");
    lines.line("use about::ABOUT;").line("use boundary::{Span, Status, Text, View};");
    lines.line("use core::ffi::c_char;").line("use info::Info;").line("");
    lines.line("/// Without the standard library nobody else says what a panic does; no kernel panics.");
    lines.line("#[cfg(not(feature = \"std\"))]").line("#[panic_handler]");
    lines.line("fn panic(_: &core::panic::PanicInfo) -> ! {");
    lines.indented(|lines| {
        _ = lines.line("loop {").indented(|lines| _ = lines.line("core::hint::spin_loop();")).line("}")
    });
    lines.line("}").line("");
}

fn exported(lines: &mut Lines, position: usize, kernel: &Bound, names: &KernelNames, module: &str) {
    let (inputs, results) = (names.inputs.join(", "), names.results.join(", "));
    let returned = if kernel.returned.is_some() { &names.returned } else { "f64" };
    let KernelNames { call, faithful, checked, batch, info, .. } = names;
    lines.line("export! {").indented(|lines| {
        lines.line(format!("{:?} at {position} is {module}::{};", kernel.full_name(), kernel.name));
        lines.line(format!("({}) -> {returned}, [{}];", rust_names(&split(&inputs)), rust_names(&split(&results))));
        lines.line(format!("{call} {faithful} {checked} {batch} {info}"));
    });
    lines.line("}").line("");
}

/// How many kernels there are, and each by its position.
fn list(lines: &mut Lines, names: &Names) {
    let prefix = &names.prefix;
    lines.line("// As in `export.rs`: no other function has these names.");
    lines.line("#[unsafe(no_mangle)]");
    lines.line(format!("extern \"C\" fn {prefix}_count() -> usize {{"));
    lines.indented(|lines| _ = lines.line("ABOUT.len()")).line("}").line("");
    lines.line("#[unsafe(no_mangle)]");
    lines.line(format!("extern \"C\" fn {prefix}_at(position: usize) -> Option<&'static Info> {{"));
    lines.indented(|lines| _ = lines.line("ABOUT.get(position)")).line("}");
}

fn split(names: &str) -> Vec<String> {
    names.split(", ").map(str::to_owned).collect()
}

fn rust_names(names: &[String]) -> String {
    names.iter().map(|name| raw(name)).collect::<Vec<_>>().join(", ")
}

/// The name of a module, which is that of a file.
fn module(family: &str) -> String {
    raw(family)
}

/// A name that Rust takes: raw where it is a keyword.
fn raw(name: &str) -> String {
    match syn::parse_str::<Ident>(name) {
        Ok(_) => name.to_owned(),
        Err(_) => format!("r#{}", plain(name)),
    }
}
