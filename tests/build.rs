//! Lists the kernels with the names of their inputs and results, so that a judge can call all of them by name.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

const GENERATED: &str = "../kernels/src/generated";

fn main() {
    println!("cargo::rerun-if-changed={GENERATED}");
    let index = read(&Path::new(GENERATED).join("mod.rs"));
    let kernels = index.lines().filter_map(|line| line.trim().strip_prefix('&')?.strip_suffix("::KERNEL,"));
    let mut list = String::from("kernels! {\n");
    for kernel in kernels {
        let (family, name) = kernel.split_once("::").expect("family::kernel");
        let text = read(&Path::new(GENERATED).join(format!("{family}.rs")));
        let (inputs, returned) = signature(&text, name);
        _ = writeln!(list, "    {kernel} [{}] [{}]", inputs.join(" "), fields(&text, returned).join(" "));
    }
    list.push_str("}\n");
    let path = Path::new(&env::var("OUT_DIR").expect("cargo says where")).join("kernels.rs");
    fs::write(&path, list).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The inputs of a kernel, and the type that it returns.
fn signature<'a>(text: &'a str, kernel: &str) -> (Vec<&'a str>, &'a str) {
    let (_, function) = text.split_once(&format!("pub fn {kernel}(\n")).expect("the kernel is in its family's file");
    let (parameters, rest) = function.split_once("\n) -> ").expect("it returns something");
    let inputs = parameters.lines().filter_map(|line| Some(line.strip_suffix(": f64,")?.rsplit_once(' ')?.1));
    (inputs.collect(), rest.split(' ').next().expect("a type"))
}

/// The fields of a struct; none of a number.
fn fields<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let Some((_, body)) = text.split_once(&format!("pub struct {name} {{\n")) else { return Vec::new() };
    let (body, _) = body.split_once("\n}").expect("the struct ends");
    body.lines().filter_map(|line| line.trim().strip_prefix("pub ")?.strip_suffix(": f64,")).collect()
}
