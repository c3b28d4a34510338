//! C99 source of tier 1: the program text of every kernel with a first tier, for those who have no Rust.

mod expression;
mod function;

use super::names::Names;
use super::text::comment;
use crate::library::{Bound, Library};
use crate::lines::Lines;
use closedform_syntax::Expr;

/// `arithmetic.h`, with the prefix of constants to be put in.
const ARITHMETIC: &str = include_str!("../../../template/c/arithmetic.h");

/// What stands above the functions.
const ABOUT: [&str; 4] = [
    "The first tier of the default calls: what most calls end in, without Rust, without allocation, in C99 and sqrt.",
    "SETTLED: every result has the bits of the default call of the library, and its bound. OUTSIDE: the inputs lie outside the \
     domain, or one is not finite; results are NaN. NOT_SETTLED: this tier does not tell, because inputs are of no ordinary \
     magnitude or digits cancel beyond double-double; results are NaN, and finer tiers are in the library only. NULL: a \
     pointer to a result is null; nothing is written.",
    "Results are written last, one after another. Functions may be called from any thread at any time.",
    "Without contraction, excess precision and -ffast-math: arithmetic.h sees to that, or ends the compilation.",
];

/// What the functions return.
const CONSTANTS: [&str; 4] = ["SETTLED", "OUTSIDE", "NOT_SETTLED", "NULL"];

/// Whether a kernel has a first tier, and C has its functions.
fn is_in_c(kernel: &Bound) -> bool {
    let mut known = true;
    kernel.kernel.visit(&mut |expr| match expr {
        Expr::Call(function, _) => known &= expression::has(*function),
        Expr::PositiveRoot(_) => known = false,
        _ => {}
    });
    known && kernel.ordinary > 0
}

/// The header.
pub fn header(library: &Library, names: &Names) -> String {
    let mut lines = Lines::default();
    let (guard, constants) = (format!("{}_TIER1_H", names.constants()), names.constants());
    let kernels = || library.kernels.iter().zip(&names.kernels);
    let about = ABOUT.map(|line| vec![line.to_owned()]);
    comment(&mut lines, &about);
    lines.line(format!("#ifndef {guard}")).line(format!("#define {guard}")).line("");
    lines.line("#ifdef __cplusplus").line("extern \"C\" {").line("#endif").line("");
    lines.line("enum {").indented(|lines| {
        for (value, name) in CONSTANTS.iter().enumerate() {
            let comma = if value + 1 < CONSTANTS.len() { "," } else { "" };
            lines.line(format!("{constants}_TIER1_{name} = {value}{comma}"));
        }
    });
    lines.line("};");
    for (kernel, own) in kernels().filter(|(kernel, _)| is_in_c(kernel)) {
        lines.line("");
        comment(&mut lines, &crate::docs::paragraphs(kernel));
        lines.wrapped("", &format!("{};", function::signature(own)));
    }
    let left: Vec<String> =
        kernels().filter(|(kernel, _)| !is_in_c(kernel)).map(|(kernel, _)| kernel.full_name()).collect();
    if !left.is_empty() {
        lines.line("");
        comment(&mut lines, &[vec![format!("Without a first tier, and in the library only: {}.", left.join(", "))]]);
    }
    lines.line("").line("#ifdef __cplusplus").line("}").line("#endif").line("").line("#endif").line("");
    lines.text()
}

/// The source.
pub fn source(library: &Library, names: &Names) -> String {
    let mut lines = Lines::default();
    lines.line(format!("#include \"{}_tier1.h\"", names.prefix)).line("#include \"arithmetic.h\"");
    let kernels = library.kernels.iter().zip(&names.kernels);
    for (kernel, own) in kernels.filter(|(kernel, _)| is_in_c(kernel)) {
        lines.line("");
        function::function(&mut lines, kernel, own, &format!("{}_TIER1", names.constants()));
    }
    lines.text()
}

/// The header of the arithmetic.
pub fn arithmetic(names: &Names) -> String {
    ARITHMETIC.replace("@CONSTANT@", &names.constants())
}
