//! Kernels as they are printed: their steps, and everything that their documentation and their attribute say.

use crate::program::{Condition, Graph, Program};
use closedform_syntax::Precision;

/// Everything that is printed of a kernel.
pub struct KernelText {
    /// The Rust name.
    pub name: String,
    /// One sentence.
    pub doc: String,
    /// The closed form of each result, as Maxima text.
    pub maxima: Vec<String>,
    /// The closed form as LaTeX.
    pub latex: String,
    /// The cell of the worksheet.
    pub source: String,
    /// Which of several solutions it is.
    pub branch: Option<String>,
    /// What happens at the domain's edges.
    pub edges: Option<String>,
    /// The struct that is returned, if there is more than one result.
    pub returns: Option<String>,
    /// The inputs, in order.
    pub inputs: Vec<InputDoc>,
    /// The conditions, in order.
    pub requires: Vec<RequireText>,
    /// The results, in order.
    pub results: Vec<ResultText>,
    /// A call, and what is known of its results.
    pub example: Option<ExampleText>,
    /// The rules that made the program.
    pub rules: Vec<RuleText>,
    /// What it computes in.
    pub precision: Precision,
    /// Why the formula stands as it is written, in certified arithmetic, if it does.
    pub certified_because: Option<String>,
    /// The steps.
    pub graph: Graph,
    /// The order and the names of the steps.
    pub program: Program,
}

/// A call that the documentation shows.
#[derive(Clone, Debug, PartialEq)]
pub struct ExampleText {
    /// The inputs, in order.
    pub inputs: Vec<f64>,
    /// The results, in order; none where nothing is known of them.
    pub results: Vec<f64>,
}

/// An input as documented.
pub struct InputDoc {
    /// The Rust name.
    pub name: String,
    /// The worksheet's name.
    pub maxima: String,
    /// The unit.
    pub unit: String,
    /// What it is.
    pub doc: String,
    /// The magnitudes to expect.
    pub typical: [f64; 2],
}

/// A rule as documented.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RuleText {
    /// The name.
    pub name: &'static str,
    /// What it does.
    pub statement: &'static str,
    /// When it may be used.
    pub condition: &'static str,
}

/// A condition with its text.
pub struct RequireText {
    /// What is evaluated.
    pub condition: Condition,
    /// What the contract says.
    pub text: String,
}

/// A result as documented.
pub struct ResultText {
    /// The field.
    pub name: String,
    /// The worksheet's name.
    pub worksheet: String,
    /// The unit.
    pub unit: String,
    /// The bound in ulp.
    pub bound: f64,
}
