//! What can be wrong with a contract.

use std::ops::Range;
use std::path::{Path, PathBuf};

use closedform_syntax::UnitError;
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::domain::ConditionError;
use super::super::source::{self, ReadError, Text};
use super::names::RustNameError;

/// Why there is no contract.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ContractError {
    /// The file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// The file says something that cannot be.
    #[error("the contract {} has {}", path.display(), count(mistakes.len()))]
    Mistakes {
        /// The contract.
        path: PathBuf,
        /// Its text.
        #[source_code]
        text: Text,
        /// All that is wrong.
        #[related]
        mistakes: Vec<Mistake>,
    },
}

impl ContractError {
    pub(super) fn mistakes(path: &Path, text: &str, mistakes: Vec<Mistake>) -> Self {
        Self::Mistakes { path: path.to_owned(), text: source::named(path, text), mistakes }
    }
}

fn count(mistakes: usize) -> String {
    if mistakes == 1 { "a mistake".to_owned() } else { format!("{mistakes} mistakes") }
}

/// One mistake in a contract, with its place.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum Mistake {
    /// Not TOML, or not the tables and keys of a contract.
    #[error("{message}")]
    #[diagnostic(help("`closedform schema contract` describes every key that a contract may have"))]
    Toml {
        /// What the TOML reader says.
        message: String,
        /// Where.
        #[label("here")]
        span: Option<SourceSpan>,
    },
    /// The file's name is the name of a Rust module.
    #[error("the family name `{name}` {cause}")]
    #[diagnostic(help("rename the worksheet and its contract, e.g. to `{}`", super::free_module_name(name)))]
    FamilyName {
        /// Stem of the file.
        name: String,
        /// What is wrong with it.
        cause: RustNameError,
    },
    /// `[[kernel]]` is missing.
    #[error("the contract has no kernel")]
    #[diagnostic(help("add a [[kernel]] for each function of the worksheet that Rust shall have"))]
    NoKernel,
    /// A text that may not be empty.
    #[error("{what} is empty")]
    #[diagnostic(help("{remedy}"))]
    Empty {
        /// The key.
        what: &'static str,
        /// What to write.
        remedy: &'static str,
        /// Where.
        #[label("nothing here")]
        span: SourceSpan,
    },
    /// Two things of one name.
    #[error("{what} `{name}` occurs twice")]
    #[diagnostic(help("give each a name of its own"))]
    Duplicate {
        /// What they are.
        what: &'static str,
        /// Their name.
        name: String,
        /// The first.
        #[label("first here")]
        first: SourceSpan,
        /// The second.
        #[label("again here")]
        span: SourceSpan,
    },
    /// A name that generated Rust cannot carry.
    #[error("`{name}` {cause}")]
    #[diagnostic(help("choose a name that Rust accepts as it stands"))]
    Name {
        /// The name.
        name: String,
        /// What is wrong with it.
        cause: RustNameError,
        /// Where.
        #[label("this becomes a name in Rust")]
        span: SourceSpan,
    },
    /// A name that Maxima cannot read.
    #[error("`{name}` is not a name in Maxima")]
    #[diagnostic(help("letters, digits, `_` and `%`, a letter first"))]
    MaximaName {
        /// The name.
        name: String,
        /// Where.
        #[label("Maxima reads this")]
        span: SourceSpan,
    },
    /// A unit that nobody knows, and whose kernel could not be judged.
    #[error("the unit `{unit}`: {cause}")]
    #[diagnostic(help("{}", cause.remedy))]
    Unit {
        /// The unit.
        unit: String,
        /// What is wrong with it.
        cause: UnitError,
        /// Where.
        #[label("here")]
        span: SourceSpan,
    },
    /// Magnitudes that are no range.
    #[error("`typical` must be two finite magnitudes 0 < low <= high, but is [{low:e}, {high:e}]")]
    #[diagnostic(help("give the range of magnitudes; signs follow from the domain"))]
    Typical {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// Where.
        #[label("not a range of magnitudes")]
        span: SourceSpan,
    },
    /// A kernel takes what the family does not have.
    #[error("kernel `{kernel}` takes `{input}`, which [inputs] does not list")]
    #[diagnostic(help("{}", unknown_input(input, nearest.as_deref())))]
    UnknownInput {
        /// The kernel.
        kernel: String,
        /// The input.
        input: String,
        /// A listed input that it may have meant.
        nearest: Option<String>,
        /// Where.
        #[label("not an input of this family")]
        span: SourceSpan,
    },
    /// An input that nothing takes.
    #[error("no kernel takes the input `{input}`")]
    #[diagnostic(help("remove it from [inputs], or add it to the `inputs` of a kernel"))]
    UnusedInput {
        /// The input.
        input: String,
        /// Where.
        #[label("listed here only")]
        span: SourceSpan,
    },
    /// A domain condition that is none.
    #[error("kernel `{kernel}`: {cause}")]
    #[diagnostic(help("{}", cause.remedy()))]
    Condition {
        /// The kernel.
        kernel: String,
        /// What is wrong with it.
        cause: ConditionError,
        /// Where.
        #[label("{}", cause.label())]
        span: SourceSpan,
    },
    /// `[[kernel.result]]` is missing.
    #[error("kernel `{kernel}` has no result")]
    #[diagnostic(help("add a [[kernel.result]] with `name`, `worksheet` and `unit`"))]
    NoResult {
        /// The kernel.
        kernel: String,
        /// Where.
        #[label("this kernel")]
        span: SourceSpan,
    },
    /// Several results without a struct.
    #[error("kernel `{kernel}` has {results} results, but no `returns`")]
    #[diagnostic(help("name the struct that holds them, e.g. returns = \"{}\"", super::names::camel_case(kernel)))]
    NoStruct {
        /// The kernel.
        kernel: String,
        /// How many.
        results: usize,
        /// Where.
        #[label("several [[kernel.result]] belong to this kernel")]
        span: SourceSpan,
    },
    /// A struct for one result.
    #[error("kernel `{kernel}` returns the struct `{returns}`, but has one result")]
    #[diagnostic(help("remove `returns`: a kernel of one result returns f64"))]
    NeedlessStruct {
        /// The kernel.
        kernel: String,
        /// The struct.
        returns: String,
        /// Where.
        #[label("one [[kernel.result]] needs no struct")]
        span: SourceSpan,
    },
}

impl Mistake {
    pub(super) fn toml(error: &toml::de::Error) -> Self {
        Self::Toml { message: error.message().to_owned(), span: error.span().map(span) }
    }
}

fn unknown_input(input: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None => format!("add it: {input} = {{ name = \"{}\", unit = \"..\", doc = \"..\" }}", super::snake_case(input)),
    }
}

/// A range of bytes as miette draws it.
pub(super) fn span(range: Range<usize>) -> SourceSpan {
    (range.start, range.len()).into()
}
