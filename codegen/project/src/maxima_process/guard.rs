//! The guard: a worksheet computes, and does nothing else with the machine, unless that is allowed.
//!
//! Twice: names that a text calls are refused before Maxima starts, with their place; and Maxima runs with these functions
//! replaced, because names can be put together at run time. It keeps worksheets of others from what they have no business
//! with. It is no sandbox: Maxima is a Lisp with the rights of its user.

use std::collections::BTreeMap;
use std::path::Path;

use closedform_maxima::{Mention, mentions};
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::beside::Beside;
use super::super::script::Script;
use super::super::source::Text;

/// Functions of Maxima that start programs, read or write files, or run Lisp.
const REFUSED: [&str; 71] = [
    "appendfile",
    "autoload",
    "bug_report",
    "chdir",
    "closefile",
    "compfile",
    "compile_file",
    "copy_file",
    "demo",
    "delete_file",
    "directory",
    "example",
    "fassave",
    "fassmbl",
    "getcurrentdirectory",
    "getenv",
    "geomview_command",
    "gnuplot_close",
    "gnuplot_reset",
    "gnuplot_restart",
    "gnuplot_start",
    "implicit_plot",
    "julia",
    "kill_gnuplot",
    "loadfile",
    "logfile",
    "make_output_stream",
    "mandelbrot",
    "mkdir",
    "numericalio",
    "opena",
    "opena_binary",
    "openplot_curves",
    "openr",
    "openr_binary",
    "openw",
    "openw_binary",
    "plotdf",
    "printfile",
    "putenv",
    "read_array",
    "read_binary_array",
    "read_binary_list",
    "read_binary_matrix",
    "read_hashed_array",
    "read_list",
    "read_matrix",
    "read_nested_list",
    "remove_file",
    "rename_file",
    "rmdir",
    "run_testsuite",
    "run_viewer",
    "save",
    "setup_autoload",
    "stringout",
    "system",
    "to_lisp",
    "translate_file",
    "with_stdout",
    "write_binary_data",
    "write_data",
    "writefile",
    "xmaxima",
    "contour_plot",
    "ploteq",
    "scene",
    "graph2d",
    "showtime_file",
    "batcon",
    "unlink_file",
];

/// What the names of functions that draw begin with: they start a program that does.
const DRAWING: [&str; 6] = ["plot2d", "plot3d", "draw", "gnuplot_", "wxplot", "wxdraw"];

/// Functions that run a file.
const LOADING: [&str; 3] = ["load", "batch", "batchload"];

/// What Maxima loads first: messages to us, and the guard.
const LISP: &str = include_str!("guard.lisp");

/// A worksheet that wants more of the machine than to compute.
#[derive(Debug, Error, Diagnostic)]
#[error("the worksheet calls `{name}`, which reaches beyond it: {what}")]
#[diagnostic(help(
    "take it out; or, if you trust whoever wrote the worksheet as you trust a program of theirs, run the command with \
     --allow-system"
))]
pub struct Reaching {
    name: String,
    what: &'static str,
    #[source_code]
    text: Text,
    #[label("here")]
    place: SourceSpan,
}

/// What a worksheet may do besides computing.
pub(super) struct Allowed<'a> {
    /// Start programs, touch files and run Lisp.
    pub(super) system: bool,
    /// Load these files, which are checked as it is.
    pub(super) beside: &'a BTreeMap<String, Beside>,
}

/// Refuses a worksheet that calls, quotes or hands on a name that reaches beyond it, and the worksheets beside it that it
/// loads.
pub(super) fn check(script: &Script, beside: &BTreeMap<String, Beside>) -> Result<(), Box<Reaching>> {
    let scripts = std::iter::once(script).chain(beside.values().map(|file| &file.script));
    for script in scripts {
        let reaching =
            mentions(script.text()).into_iter().find_map(|mention| Some((reach(&mention, beside)?, mention)));
        if let Some((what, mention)) = reaching {
            let (text, place) = (script.shown(), mention.span.into());
            return Err(Box::new(Reaching { name: mention.name, what, text, place }));
        }
    }
    Ok(())
}

/// The places in a worksheet that reach beyond it, each with the name that does.
pub(crate) fn reaching(script: &Script, beside: &BTreeMap<String, Beside>) -> Vec<(usize, String)> {
    let reaching = mentions(script.text()).into_iter().filter(|mention| reach(mention, beside).is_some());
    reaching.map(|mention| (mention.span.start, mention.name)).collect()
}

/// Whether a function draws.
fn draws(name: &str) -> bool {
    DRAWING.iter().any(|start| name.starts_with(start))
}

/// What the name does that a worksheet has no need of.
fn reach(mention: &Mention, beside: &BTreeMap<String, Beside>) -> Option<&'static str> {
    let name = mention.name.as_str();
    if name.starts_with('?') || name == ":lisp" {
        return Some("it is Lisp, which can do anything");
    }
    if LOADING.contains(&name) {
        if mention.argument.as_ref().is_some_and(|name| beside.contains_key(name)) {
            return None;
        }
        let package = mention.argument.as_deref().is_some_and(|name| !name.contains(['/', '\\', '.']));
        return (!package)
            .then_some("only packages of Maxima are loaded, by their plain names, and worksheets beside this one");
    }
    (draws(name) || REFUSED.contains(&name)).then_some("it starts a program, touches files or runs Lisp")
}

/// The Lisp that Maxima loads before the worksheet: `mark` begins a message of the driver, which is one of our two files.
pub(super) fn lisp(mark: &str, driver: &Path, batch: &Path, allowed: &Allowed) -> String {
    let list = |names: &[&str]| names.iter().map(|name| string(name)).collect::<Vec<_>>().join(" ");
    let path = |path: &Path| string(&path.display().to_string());
    let whole = |file: &Beside| file.path.canonicalize().ok().map(|whole| path(&whole));
    let beside: Vec<String> = allowed.beside.values().filter_map(whole).collect();
    LISP.replace("@MARK@", &string(mark))
        .replace("@DRIVER@", &path(driver))
        .replace("@BATCH@", &path(batch))
        .replace("@REFUSED@", &list(&REFUSED))
        .replace("@DRAWING@", &list(&DRAWING))
        .replace("@BESIDE@", &beside.join(" "))
        .replace("@GUARDED@", if allowed.system { "nil" } else { "t" })
}

/// A string of Lisp.
fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawn::{drawn, has};

    fn script(text: &str) -> Script {
        Script::of(Path::new("my.mac"), text.as_bytes()).unwrap()
    }

    #[test]
    fn what_reaches_beyond_a_worksheet_is_shown() {
        for (text, name) in [
            ("f(x):=x$\nsystem(\"touch x\")$", "system"),
            ("apply('writefile, [\"x\"])$", "writefile"),
            ("load(\"../other.lisp\")$", "load"),
            ("load(\"other.mac\")$", "load"),
            ("batchload(concat(a,b))$", "batchload"),
            ("?sb\\-ext\\:quit()$", "?sb-ext:quit"),
            ("x: 1$\n:lisp (quit)\n", ":lisp"),
            ("plot2d(x,[x,0,1])$", "plot2d"),
            ("draw3d(explicit(x,x,0,1))$", "draw3d"),
            ("eval_string(\"system(1)\")$", "system"),
        ] {
            let said = drawn(check(&script(text), &BTreeMap::new()).expect_err(text).as_ref());
            has(&said, &[&format!("the worksheet calls `{name}`"), "my.mac", "--allow-system"]);
        }
    }

    #[test]
    fn what_computes_is_let_through() {
        let text = "load(facexp)$ load(\"diag\")$ system: [a=1]$ load: 3$ solve(system, a)$ printed(e):=eval_string(string(e))$";
        assert!(check(&script(text), &BTreeMap::new()).is_ok());
    }
}
