//! A worksheet that nobody wrote a contract for: its definitions are its reference expressions.

mod inline;
mod judged;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use closedform_maxima::Definition;
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::contract::{self, Contract, FamilyInfo, Input, KernelContract, ResultContract, TYPICAL};
use super::super::domain::Domain;
use super::super::source::{self, Text};
use super::reference::ReferenceMistake;
use super::{Family, FamilyError, Paths};
use judged::Judged;

/// Why a worksheet is not a list of definitions that kernels can be made of.
#[derive(Debug, Error, Diagnostic)]
#[error("{} cannot be read as a list of definitions: {count}", path.display())]
pub struct WorksheetError {
    /// The worksheet.
    pub path: std::path::PathBuf,
    /// How much is wrong.
    count: String,
    /// Its text.
    #[source_code]
    pub text: Text,
    /// What is wrong, the first of it.
    #[related]
    pub mistakes: Vec<WorksheetMistake>,
}

/// One mistake in a worksheet, with its place.
#[derive(Debug, Error, Diagnostic)]
pub enum WorksheetMistake {
    /// The text is not Maxima.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Text(#[from] closedform_maxima::Error),
    /// A definition that no kernel can be made of.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Body(#[from] ReferenceMistake),
    /// Statements that compute.
    #[error("{}", computing(*statements))]
    #[diagnostic(help(
        "a worksheet that computes needs Maxima: write a contract NAME.toml beside it, run `closedform derive --folder DIR \
         NAME`, and then this command again; book/src/contract.md shows a contract"
    ))]
    Computes {
        /// How many.
        statements: usize,
        /// Where the first one is.
        #[label("only Maxima can run this")]
        span: SourceSpan,
    },
    /// Nothing at all.
    #[error("the worksheet defines no function")]
    #[diagnostic(help("define one, e.g. f(x,y):=sqrt(x^2+y^2)$"))]
    Nothing,
    /// A function without parameters.
    #[error("`{name}` has no parameters")]
    #[diagnostic(help("a kernel needs an input; a constant needs no kernel"))]
    Constant {
        /// The function.
        name: String,
        /// Where.
        #[label("a constant")]
        span: SourceSpan,
    },
    /// A parameter that occurs twice.
    #[error("`{name}` has the parameter `{parameter}` twice")]
    #[diagnostic(help("give each parameter a name of its own"))]
    Parameter {
        /// The function.
        name: String,
        /// The parameter.
        parameter: String,
        /// Where.
        #[label("this definition")]
        span: SourceSpan,
    },
    /// Definitions that need each other.
    #[error("these definitions call each other without end: {}", cycle.join(" -> "))]
    #[diagnostic(help("kernels are closed forms; write the function without recursion"))]
    Recursion {
        /// The functions, the first again at the end.
        cycle: Vec<String>,
        /// Where.
        #[label("calls itself in the end")]
        span: SourceSpan,
    },
    /// A call with another number of arguments than the definition has parameters.
    #[error("`{name}` takes {expected} arguments, but is called with {found}")]
    #[diagnostic(help("correct the call or the definition"))]
    Arguments {
        /// The function called.
        name: String,
        /// Number of parameters.
        expected: usize,
        /// Number of arguments.
        found: usize,
        /// Where.
        #[label("called here")]
        span: SourceSpan,
    },
    /// A formula without measure.
    #[error("the formulas grow to more than {} terms when all definitions are put in", inline::SIZE_LIMIT)]
    #[diagnostic(help("make the functions that it calls smaller"))]
    TooLarge {
        /// The function called.
        name: String,
        /// Where.
        #[label("putting in `{name}` is too much")]
        span: SourceSpan,
    },
}

fn computing(statements: usize) -> String {
    match statements {
        1 => "this statement defines no function".to_owned(),
        _ => format!("{statements} statements define no function; the first of them"),
    }
}

/// What of a worksheet can become kernels.
#[derive(Debug)]
pub struct Sheet {
    /// The kernels with whose formulas nothing is wrong so far; perhaps none.
    pub family: Family,
    /// What is wrong with the others, if there are any.
    pub error: Option<WorksheetError>,
}

impl Sheet {
    /// The family, if nothing is wrong with any formula.
    pub(super) fn whole(self) -> Result<Family, FamilyError> {
        self.error.map_or(Ok(self.family), |error| Err(error.into()))
    }
}

/// The formulas of a worksheet, with the contract and reference expressions beside it, if there are any.
pub(super) fn load(path: &Path) -> Result<Sheet, FamilyError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let paths = Paths { worksheet: path.to_owned(), ..Paths::new(folder, &stem) };
    let name = contract::free_module_name(&stem);
    let contract = match paths.contract.exists() {
        true => Some(contract::load_under_any_name(&paths.contract)?),
        false => None,
    };
    let contract = match contract {
        Some(contract) if paths.reference.exists() => {
            return Ok(Sheet { family: Family::derived(&name, contract, paths)?, error: None });
        }
        contract => contract,
    };
    let text = source::read(path, "name a Maxima worksheet: a text in UTF-8 of definitions f(x,y):=..$")?;
    let judged = Judged::new(&text);
    let mut contract = contract.unwrap_or_else(|| contract_of(&file_name(path), &judged.definitions));
    let ((kernels, references), mistakes) = judged.against(&contract);
    contract.kernels = kernels;
    let error = (!mistakes.is_empty()).then(|| WorksheetError::new(path, &text, mistakes));
    let places = source::places(path, &text, references.iter().map(|reference| reference.span.start));
    Ok(Sheet { family: Family { name, contract, references, places, paths }, error })
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

impl WorksheetError {
    fn new(path: &Path, text: &str, mistakes: Vec<WorksheetMistake>) -> Self {
        let count = source::count(mistakes.len());
        let mistakes = mistakes.into_iter().take(source::SHOWN).collect();
        Self { path: path.to_owned(), count, text: source::named(path, text), mistakes }
    }
}

impl WorksheetMistake {
    /// Where it is, if it has a place.
    fn span(&self) -> Option<SourceSpan> {
        match self {
            Self::Text(error) => Some(error.span().into()),
            Self::Body(mistake) => mistake.span(),
            Self::Nothing => None,
            Self::Computes { span, .. }
            | Self::Constant { span, .. }
            | Self::Parameter { span, .. }
            | Self::Recursion { span, .. }
            | Self::Arguments { span, .. }
            | Self::TooLarge { span, .. } => Some(*span),
        }
    }
}

/// What can be promised without anybody's word: every definition is a kernel, every quantity without a unit, and digits
/// go before time.
fn contract_of(file: &str, definitions: &[Definition]) -> Contract {
    let mut kernels: Vec<KernelContract> = Vec::new();
    let mut inputs: BTreeMap<String, Input> = BTreeMap::new();
    let (mut taken_kernels, mut taken_inputs) = (BTreeSet::new(), BTreeSet::new());
    for definition in definitions {
        kernels.push(kernel(definition, unused_name(&definition.name, &mut taken_kernels), file));
        for parameter in &definition.parameters {
            let unused = || input(unused_name(parameter, &mut taken_inputs));
            inputs.entry(parameter.clone()).or_insert_with(unused);
        }
    }
    let title = format!("The formulas of the worksheet {file}");
    Contract { family: FamilyInfo { title, source: String::new() }, inputs, kernels }
}

fn kernel(definition: &Definition, name: String, file: &str) -> KernelContract {
    let result = ResultContract { name: name.clone(), worksheet: definition.name.clone(), unit: "1".to_owned() };
    KernelContract {
        name,
        doc: format!("The function {} of {file}.", definition.name),
        source: file.to_owned(),
        inputs: definition.parameters.clone(),
        domain: Domain::new(definition.parameters.clone(), Vec::new()),
        branch: None,
        few_roundings: true,
        one_division: false,
        edges: None,
        returns: None,
        results: vec![result],
    }
}

fn input(name: String) -> Input {
    Input { name, unit: "1".to_owned(), typical: TYPICAL, doc: String::new() }
}

/// A Rust name for a Maxima name that is not taken yet, and is from then on.
fn unused_name(maxima: &str, taken: &mut BTreeSet<String>) -> String {
    let name = contract::free_name(maxima, |name| contract::rust_name(name).is_ok() && !taken.contains(name));
    taken.insert(name.clone());
    name
}
