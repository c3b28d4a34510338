//! A worksheet that nobody wrote a contract for: its definitions are its reference expressions.

mod inline;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use closedform_maxima::{Definition, worksheet};
use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error;

use super::super::contract::{self, Contract, FamilyInfo, Input, KernelContract, ResultContract, TYPICAL};
use super::super::domain::Domain;
use super::super::source;
use super::reference::{self, ReferenceMistake};
use super::{Family, FamilyError, Paths};

/// Why a worksheet is not a list of definitions that kernels can be made of.
#[derive(Debug, Error, Diagnostic)]
#[error("{} cannot be read as a list of definitions", path.display())]
pub struct WorksheetError {
    /// The worksheet.
    pub path: std::path::PathBuf,
    /// Its text.
    #[source_code]
    pub text: NamedSource<String>,
    /// All that is wrong.
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
    /// A statement that computes.
    #[error("this statement defines no function")]
    #[diagnostic(help(
        "a worksheet that computes needs Maxima: write a contract beside it and run `closedform derive`"
    ))]
    Computes {
        /// Where.
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

/// The family of a worksheet, with the contract and reference expressions beside it, if there are any.
pub(super) fn load(path: &Path) -> Result<Family, FamilyError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let paths = Paths { worksheet: path.to_owned(), ..Paths::new(folder, &stem) };
    if paths.contract.exists() && paths.reference.exists() {
        return Family::load(folder, &stem);
    }
    let text = source::read(path, "name a Maxima worksheet")?;
    let fail = |mistakes| {
        FamilyError::from(WorksheetError { path: path.to_owned(), text: source::named(path, &text), mistakes })
    };
    let definitions = closed_definitions(&text).map_err(fail)?;
    let contract = match paths.contract.exists() {
        true => contract::load(&paths.contract)?,
        false => contract_of(&stem, &definitions),
    };
    let promised = definitions.into_iter().filter(|d| contract.results().any(|(_, result)| result.worksheet == d.name));
    let references = reference::in_order(promised.collect(), &contract);
    let references = references.map_err(|mistakes| fail(mistakes.into_iter().map(Into::into).collect()))?;
    Ok(Family { name: unused_name(&stem, &BTreeSet::new()), contract, references, paths })
}

/// The definitions of a text, with every call of one in another replaced by its body.
fn closed_definitions(text: &str) -> Result<Vec<Definition>, Vec<WorksheetMistake>> {
    let sheet = worksheet(text).map_err(|errors| errors.errors.into_iter().map(Into::into).collect::<Vec<_>>())?;
    let computes = sheet.others.iter().map(|statement| statement.expression.span.clone().into());
    let mut mistakes: Vec<WorksheetMistake> = computes.map(|span| WorksheetMistake::Computes { span }).collect();
    if mistakes.is_empty() {
        mistakes = definitions_mistakes(text, &sheet.definitions);
    }
    if mistakes.is_empty() { inline::inline(&sheet.definitions) } else { Err(mistakes) }
}

fn definitions_mistakes(text: &str, definitions: &[Definition]) -> Vec<WorksheetMistake> {
    let mut mistakes = Vec::new();
    if definitions.is_empty() {
        mistakes.push(WorksheetMistake::Nothing);
    }
    if let Err(twice) = closedform_maxima::definitions(text) {
        mistakes.extend(twice.errors.into_iter().map(WorksheetMistake::from));
    }
    for definition in definitions {
        let (name, span) = (definition.name.clone(), SourceSpan::from(definition.span.clone()));
        if definition.parameters.is_empty() {
            mistakes.push(WorksheetMistake::Constant { name, span });
        } else if let Some(parameter) = repeated(&definition.parameters) {
            mistakes.push(WorksheetMistake::Parameter { name, parameter, span });
        }
    }
    mistakes
}

fn repeated(names: &[String]) -> Option<String> {
    let mut seen = BTreeSet::new();
    names.iter().find(|name| !seen.insert(*name)).cloned()
}

/// What can be promised without anybody's word: every definition is a kernel, every quantity without a unit, and digits
/// go before time.
fn contract_of(stem: &str, definitions: &[Definition]) -> Contract {
    let mut kernels: Vec<KernelContract> = Vec::new();
    let mut inputs: BTreeMap<String, Input> = BTreeMap::new();
    for definition in definitions {
        let name = unused_name(&definition.name, &kernels.iter().map(|kernel| kernel.name.clone()).collect());
        kernels.push(kernel(definition, name, stem));
        for parameter in &definition.parameters {
            let taken = inputs.values().map(|input| input.name.clone()).collect();
            inputs.entry(parameter.clone()).or_insert_with(|| input(parameter, unused_name(parameter, &taken)));
        }
    }
    Contract { family: FamilyInfo { title: stem.to_owned(), source: String::new() }, inputs, kernels }
}

fn kernel(definition: &Definition, name: String, stem: &str) -> KernelContract {
    let result = ResultContract { name: name.clone(), worksheet: definition.name.clone(), unit: "1".to_owned() };
    KernelContract {
        name,
        doc: format!("`{}` of the worksheet.", definition.name),
        source: format!("worksheet `{stem}`"),
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

fn input(parameter: &str, name: String) -> Input {
    Input { name, unit: "1".to_owned(), typical: TYPICAL, doc: format!("`{parameter}` of the worksheet") }
}

/// A Rust name for a Maxima name: the snake_case one, or one made of it if Rust or `taken` has that already.
fn unused_name(maxima: &str, taken: &BTreeSet<String>) -> String {
    let ascii: String =
        contract::snake_case(maxima).chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
    let letters = ascii.trim_matches('_');
    let plain =
        if letters.starts_with(|c: char| c.is_ascii_lowercase()) { letters.to_owned() } else { format!("x{letters}") };
    let free = |name: &String| contract::rust_name(name).is_ok() && !taken.contains(name);
    let others = std::iter::once(format!("{plain}_value")).chain((2_u64..).map(|number| format!("{plain}_{number}")));
    std::iter::once(plain.clone()).chain(others).find(free).unwrap_or(plain)
}
