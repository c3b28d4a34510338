//! The header: types, and five functions a kernel with their documentation.

use super::names::{KernelNames, Names};
use super::text::comment;
use crate::docs::paragraphs;
use crate::library::{Bound, Library};
use crate::lines::Lines;

/// The types, with the prefix and that of constants to be put in.
const TYPES: &str = include_str!("../../template/c/types.h");

/// How functions are called, said once.
const ABOUT: [&str; 6] = [
    "NAME returns the result, or a struct of the results; NaN outside the domain.",
    "NAME_faithful returns it with an error of less than one ulp where a bound is proved; slower.",
    "NAME_checked writes it to `result`, or says why there is none and leaves `result` as it is.",
    "NAME_batch does for arrays of one length what NAME does for numbers, with the same bits; results may share no memory with \
     anything. Where it returns a fault, nothing is written.",
    "NAME_info tells what is known of it.",
    "`text` has room for `size` bytes, in which a call that fails says why, in UTF-8, cut off where there is no more room, and \
     with a zero at the end; a call that succeeds leaves it empty. It may be null.",
];

/// The header.
pub fn header(library: &Library, names: &Names) -> String {
    let mut lines = Lines::default();
    let about = ABOUT.iter().map(|line| line.replace("NAME", &format!("{}_FAMILY_NAME", names.prefix)));
    let title = format!("The kernels of {} {}.", library.package.name, "for C");
    let rest = "All functions may be called from any thread at any time. None allocates or keeps anything.".to_owned();
    comment(&mut lines, &[vec![title], about.collect(), vec![rest]]);
    let guard = format!("{}_H", names.constants());
    lines.line(format!("#ifndef {guard}")).line(format!("#define {guard}"));
    let mut text = lines.text();
    text += &TYPES.replace("@PREFIX@", &names.prefix).replace("@CONSTANT@", &names.constants());
    let mut lines = Lines::default();
    for (kernel, own) in library.kernels.iter().zip(&names.kernels) {
        declared(&mut lines, &names.prefix, kernel, own);
    }
    lines.line("").line("#ifdef __cplusplus").line("}").line("#endif").line("").line("#endif");
    text + &lines.text()
}

fn declared(lines: &mut Lines, prefix: &str, kernel: &Bound, names: &KernelNames) {
    let KernelNames { call, faithful, checked, batch, info, returned, .. } = names;
    lines.line("");
    if kernel.returned.is_some() {
        lines.line(format!("/** What {call} returns. */")).line(format!("typedef struct {returned} {{"));
        lines.indented(|lines| names.fields.iter().for_each(|field| _ = lines.line(format!("double {field};"))));
        lines.line(format!("}} {returned};")).line("");
    }
    let inputs = || names.inputs.iter().map(|input| format!("double {input}"));
    let text = || ["char *text".to_owned(), "size_t size".to_owned()];
    comment(lines, &paragraphs(kernel));
    prototype(lines, &format!("{returned} {call}"), inputs());
    prototype(lines, &format!("{returned} {faithful}"), inputs());
    let result = [format!("{returned} *result")];
    prototype(lines, &format!("{prefix}_status {checked}"), inputs().chain(result).chain(text()));
    let views = names.inputs.iter().map(|input| format!("{prefix}_view {input}"));
    let spans = names.results.iter().map(|result| format!("{prefix}_span {result}"));
    prototype(lines, &format!("{prefix}_status {batch}"), views.chain(spans).chain(text()));
    lines.line(format!("const {prefix}_info *{info}(void);"));
}

/// A function with its arguments, in one line or wrapped.
fn prototype(lines: &mut Lines, name: &str, arguments: impl Iterator<Item = String>) {
    let arguments = arguments.collect::<Vec<_>>().join(", ");
    let flat = format!("{name}({arguments});");
    if flat.len() <= 120 {
        lines.line(flat);
    } else {
        lines.line(format!("{name}(")).indented(|lines| _ = lines.wrapped("", &arguments)).line(");");
    }
}
