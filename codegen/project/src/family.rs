//! Families: a contract and the reference expressions that fulfil it.

mod natural_domain;
mod reference;
mod stranger;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use closedform_maxima::Definition;
use miette::Diagnostic;
use thiserror::Error;

pub use reference::{ReferenceError, ReferenceMistake};
pub use stranger::{Passed, Sheet, Summary, WorksheetError, WorksheetMistake};

use super::contract::{self, Contract, ContractError, KernelContract, ResultContract, module_name};
use super::script::ScriptError;
use super::source::{self, ReadError};

/// Everything about a family that kernels are made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// The stem of its files, a Rust module name.
    pub name: String,
    /// What it promises.
    pub contract: Contract,
    /// One definition a result, in contract order.
    pub references: Vec<Definition>,
    /// Where each of them stands: `path:line:column`.
    pub places: Vec<String>,
    /// Its files.
    pub paths: Paths,
}

/// The files of a family.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Paths {
    /// `NAME.mac`, or another worksheet of that name
    pub worksheet: PathBuf,
    /// `NAME.toml`
    pub contract: PathBuf,
    /// `NAME.ref`
    pub reference: PathBuf,
    /// `NAME.tsv`
    pub golden: PathBuf,
}

/// Why there is no family.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum FamilyError {
    /// A file or folder cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// The worksheet's file gives no text.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Script(#[from] ScriptError),
    /// The contract is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Contract(#[from] ContractError),
    /// The reference expressions are wrong, or do not fit the contract.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Reference(#[from] ReferenceError),
    /// The worksheet is more than definitions, or its definitions do not fit.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Worksheet(#[from] WorksheetError),
    /// What Maxima derived from an earlier text of a worksheet.
    #[error("{} was derived from another {} than there is now", reference.display(), worksheet.display())]
    #[diagnostic(help("run `closedform derive {}`; or delete {}", worksheet.display(), reference.display()))]
    Stale {
        /// What was derived.
        reference: PathBuf,
        /// The worksheet.
        worksheet: PathBuf,
    },
    /// Two worksheets of one contract.
    #[error("the contract {} has two worksheets: {} and {}", contract.display(), first.display(), second.display())]
    #[diagnostic(help("rename one of them, or remove it"))]
    Twice {
        /// The contract.
        contract: PathBuf,
        /// The one.
        first: PathBuf,
        /// The other.
        second: PathBuf,
    },
}

impl Paths {
    /// The files of the family `name` in a folder, whether they exist or not.
    pub fn new(folder: &Path, name: &str) -> Self {
        let file = |extension: &str| folder.join(format!("{name}.{extension}"));
        Self {
            worksheet: closedform_build::worksheet(folder, name),
            contract: file("toml"),
            reference: file("ref"),
            golden: file("tsv"),
        }
    }
}

impl Family {
    /// Reads contract and reference expressions of a family; both must fit.
    pub fn load(folder: &Path, name: &str) -> Result<Self, FamilyError> {
        let paths = Paths::new(folder, name);
        let contract = contract::load(&paths.contract)?;
        Self::derived(name, contract, paths)
    }

    /// With the reference expressions that Maxima derived.
    fn derived(name: &str, contract: Contract, paths: Paths) -> Result<Self, FamilyError> {
        let remedy = format!("say `closedform derive {name}`, which runs the worksheet and writes this file");
        let text = source::read(&paths.reference, remedy)?;
        let references = reference::check(&paths.reference, &text, &contract)?;
        let places = source::places(&paths.reference, &text, references.iter().map(|reference| reference.span.start));
        Ok(Self { name: name.to_owned(), contract, references, places, paths })
    }

    /// Reads a worksheet that may stand alone: without a contract beside it every definition becomes a kernel of one
    /// result, without conditions on its inputs.
    pub fn from_worksheet(path: &Path) -> Result<Self, FamilyError> {
        Self::sheet(path)?.whole()
    }

    /// As [`from_worksheet`](Self::from_worksheet), of the formulas with which nothing is wrong, and what is wrong with the
    /// others.
    pub fn sheet(path: &Path) -> Result<Sheet, FamilyError> {
        stranger::load(path)
    }

    /// Where the first formula of a kernel stands: `path:line:column`.
    pub fn place(&self, kernel: &str) -> &str {
        let mut owners = self.contract.results().map(|(owner, _)| owner.name.as_str()).zip(&self.places);
        owners.find(|(owner, _)| *owner == kernel).map_or("", |(_, place)| place)
    }

    /// The same without some kernels.
    #[must_use]
    pub fn without(&self, kernels: &BTreeSet<String>) -> Self {
        let is_left = |kernel: &KernelContract| !kernels.contains(&kernel.name);
        let of_results: Vec<bool> = self.contract.results().map(|(kernel, _)| is_left(kernel)).collect();
        let mut left = self.clone();
        left.contract.kernels.retain(is_left);
        let mut each = of_results.iter();
        left.references.retain(|_| each.next().copied().unwrap_or_default());
        let mut each = of_results.iter();
        left.places.retain(|_| each.next().copied().unwrap_or_default());
        left
    }

    /// A kernel's contract whose domain has every condition that its reference expressions need besides.
    pub fn completed(&self, kernel: &KernelContract) -> KernelContract {
        let own = self.results().filter(|(owner, ..)| owner.name == kernel.name);
        completed(kernel, own.map(|(.., reference)| reference))
    }

    /// Every result with its kernel and reference expression, in contract order.
    pub fn results(&self) -> impl Iterator<Item = (&KernelContract, &ResultContract, &Definition)> {
        self.contract.results().zip(&self.references).map(|((kernel, result), reference)| (kernel, result, reference))
    }
}

/// A kernel's contract whose domain has every condition that these reference expressions, its own, need besides.
pub(super) fn completed<'a>(kernel: &KernelContract, own: impl Iterator<Item = &'a Definition>) -> KernelContract {
    let natural = own.flat_map(|reference| natural_domain::natural_domain(&reference.body, &kernel.inputs));
    KernelContract { domain: kernel.domain.clone().with_natural(natural), ..kernel.clone() }
}

/// The families of a folder, by name: those with a contract, and worksheets of definitions alone.
pub fn families(folder: &Path) -> Result<Vec<Family>, FamilyError> {
    let contracts = family_names(folder)?;
    let worksheets = files(folder, &closedform_build::WORKSHEETS)?;
    let (owned, mut alone): (Vec<_>, Vec<_>) = worksheets.into_iter().partition(|file| contracts.contains(&stem(file)));
    one_each(folder, &owned)?;
    // a worksheet that is called as its module keeps that name, whatever others come
    alone.sort_by_key(|file| module_name(&stem(file)).is_err());
    let mut families = contracts.iter().map(|name| Family::load(folder, name)).collect::<Result<Vec<_>, _>>()?;
    for file in &alone {
        let taken = |name: &str| families.iter().any(|family| family.name == name);
        let name = contract::free_module_name_beside(&stem(file), taken);
        families.push(Family { name, ..Family::from_worksheet(file)? });
    }
    families.sort_by(|one, other| one.name.cmp(&other.name));
    Ok(families)
}

/// The worksheets of a folder, by their names.
pub fn worksheets_in(folder: &Path) -> Result<Vec<PathBuf>, ReadError> {
    files(folder, &closedform_build::WORKSHEETS)
}

/// Refuses two worksheets of one contract.
fn one_each(folder: &Path, worksheets: &[PathBuf]) -> Result<(), FamilyError> {
    let mut pairs = worksheets.windows(2).filter_map(|pair| Some((pair.first()?, pair.get(1)?)));
    match pairs.find(|(first, second)| stem(first) == stem(second)) {
        None => Ok(()),
        Some((first, second)) => {
            let (contract, first, second) = (Paths::new(folder, &stem(first)).contract, first.clone(), second.clone());
            Err(FamilyError::Twice { contract, first, second })
        }
    }
}

/// The names of the families of a folder that have a contract `NAME.toml`, sorted.
pub fn family_names(folder: &Path) -> Result<Vec<String>, ReadError> {
    Ok(files(folder, &["toml"])?.iter().map(|file| stem(file)).collect())
}

fn stem(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// The files of a folder with one of these endings, by their names and in the order of the endings.
fn files(folder: &Path, endings: &[&str]) -> Result<Vec<PathBuf>, ReadError> {
    let unreadable = |cause| {
        let remedy = "go to a project, or name one with --root; `closedform new NAME` makes one".to_owned();
        ReadError { path: folder.to_owned(), cause, remedy }
    };
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let ending = path.extension().and_then(|extension| endings.iter().position(|ending| extension == *ending));
        files.extend(ending.map(|ending| (stem(&path), ending, path)));
    }
    files.sort();
    Ok(files.into_iter().map(|(.., path)| path).collect())
}

/// The definitions of a reference text, in contract order, if they are what the contract promises.
pub(super) fn check_references(
    path: &Path,
    text: &str,
    contract: &Contract,
) -> Result<Vec<Definition>, ReferenceError> {
    reference::check(path, text, contract)
}

#[cfg(test)]
mod tests;
