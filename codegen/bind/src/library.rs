//! What is bound, as every language needs it: names, quantities, and the kernels as trees.

use crate::error::BindError;
use crate::package::Package;
use closedform_measure::catalogue::{Catalogue, Entry, maxima_name, unit_of};
use closedform_project::Project;
use closedform_project::contract::TYPICAL;
use closedform_syntax::{Kernel, Output, ordinary};
use syn::Visibility;

/// Every kernel of a crate that others can call.
#[derive(Clone, Debug)]
pub struct Library {
    /// The crate.
    pub package: Package,
    /// Its kernels.
    pub kernels: Vec<Bound>,
}

/// A kernel that is bound.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The module that it is in.
    pub family: String,
    /// Its name there; `r#` before it where it is a keyword of Rust.
    pub name: String,
    /// Its inputs.
    pub inputs: Vec<Quantity>,
    /// The conditions that inputs must meet besides being finite.
    pub domain: Vec<String>,
    /// Its results.
    pub results: Vec<Quantity>,
    /// The struct of Rust that holds them, if it is one.
    pub returned: Option<String>,
    /// At which magnitudes of inputs no step over- or underflows; see `Info::ordinary`.
    pub ordinary: u32,
    /// All else.
    pub kernel: Kernel,
}

/// An input or a result.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in Rust.
    pub name: String,
    /// Its name in the worksheet; empty where there is none.
    pub worksheet: String,
    /// Its unit; empty where none is given.
    pub unit: String,
    /// The magnitudes to expect of an input.
    pub typical: [f64; 2],
    /// The error in ulp that a result never exceeds, where one is proved.
    pub bound: Option<f64>,
}

impl Library {
    /// The kernels of a project's crate.
    ///
    /// # Errors
    ///
    /// When there is no crate, or none of its kernels is `pub`.
    pub fn new(project: &Project, catalogue: &Catalogue) -> Result<Self, BindError> {
        let package = Package::of(project)?;
        let public = |entry: &&Entry| matches!(entry.kernel.visibility, Visibility::Public(_));
        let kernels: Vec<Bound> = catalogue.entries().iter().filter(public).map(Bound::new).collect();
        if kernels.is_empty() {
            return Err(BindError::NothingPublic { folder: package.folder });
        }
        Ok(Self { package, kernels })
    }
}

impl Bound {
    fn new(entry: &Entry) -> Self {
        let kernel = entry.kernel.clone();
        Self {
            family: entry.family.clone(),
            name: entry.name.clone(),
            inputs: kernel.inputs.iter().map(input).collect(),
            domain: kernel.requires.iter().map(|require| require.text.clone()).collect(),
            results: kernel.meta.results.iter().map(result).collect(),
            returned: match &kernel.output {
                Output::Value(_) => None,
                Output::Struct { name, .. } => Some(name.to_string()),
            },
            ordinary: ordinary(&kernel),
            kernel,
        }
    }

    /// `family::name`
    #[must_use]
    pub fn full_name(&self) -> String {
        format!("{}::{}", self.family, plain(&self.name))
    }
}

/// A Rust name without the mark of a raw one.
pub fn plain(name: &str) -> &str {
    name.strip_prefix("r#").unwrap_or(name)
}

fn input(input: &closedform_syntax::Input) -> Quantity {
    Quantity {
        name: plain(&input.name.to_string()).to_owned(),
        worksheet: plain(&maxima_name(input)).to_owned(),
        unit: input.unit.clone().unwrap_or_default(),
        typical: input.typical.map_or(TYPICAL, |(least, most)| [least, most]),
        bound: None,
    }
}

fn result(result: &closedform_syntax::ResultMeta) -> Quantity {
    Quantity {
        name: plain(&result.name.to_string()).to_owned(),
        worksheet: result.worksheet.clone().unwrap_or_default(),
        unit: result.unit.clone().unwrap_or_default(),
        typical: TYPICAL,
        bound: result.bound,
    }
}

impl Quantity {
    /// The unit, if it is not that of a number.
    #[must_use]
    pub fn unit(&self) -> Option<&str> {
        let unit = Some(self.unit.clone()).filter(|unit| !unit.is_empty());
        (unit_of(&unit) != "1").then_some(self.unit.as_str())
    }
}
