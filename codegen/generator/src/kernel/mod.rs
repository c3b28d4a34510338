//! Kernels: from a contract and its reference expressions to the text of a kernel, proved equal to them.

mod as_written;
mod domain;
mod domain_proof;
mod formula;
mod known;
mod proof;
mod read_back;
mod written;

pub use proof::{ProofError, prove};
pub use written::WrittenError;

use crate::algebra::{Algebra, TooMuchWork, limited};
use crate::field::{Tower, TowerError};
use crate::program::{Graph, Node, name_steps};
use crate::rust::{InputDoc, KernelText, RequireText, ResultText};
use crate::stable::builder::Builder;
use crate::stable::rules::falling_newton::{self, RootError};
use crate::stable::rules::one_reciprocal::Products;
use crate::stable::rules::{certified, double_double, gathered, one_reciprocal};
use crate::stable::stabilise;
use closedform_arith::error_model::CERTIFIED_ULP;
use closedform_maxima::{Definition, to_latex};
use closedform_project::contract::{Contract, KernelContract, ResultContract};
use closedform_project::expression::{Expr, LowerError, lower};
use closedform_syntax::Precision;
use thiserror::Error;
use written::Written;

/// Why no kernel can be made.
#[derive(Debug, Error)]
pub enum KernelError {
    /// A reference expression uses what the generator does not know.
    #[error("{0}")]
    Lower(#[source] LowerError),
    /// An expression has no canonical form.
    #[error("`{function}` {cause}")]
    Tower {
        /// The function of the worksheet.
        function: String,
        /// Why.
        cause: TowerError,
    },
    /// A domain condition has no canonical form.
    #[error("the domain condition `{condition}` {cause}")]
    Domain {
        /// The condition.
        condition: String,
        /// Why.
        cause: TowerError,
    },
    /// A polynomial root that is not shown to be unique.
    #[error("`{function}`: {cause}")]
    Root {
        /// The function of the worksheet.
        function: String,
        /// Why.
        cause: RootError,
    },
    /// A formula whose algebra has no end in sight.
    #[error("`{0}`: its exact algebra takes more work than the limit of a formula allows")]
    TooMuchWork(String),
    /// A formula that cannot be taken step by step.
    #[error("`{function}`: {cause}")]
    Written {
        /// The kernel.
        function: String,
        /// Why.
        cause: WrittenError,
    },
    /// A program whose error has no bound.
    #[error(
        "no bound for the error of `{0}` could be derived: a sum of rounded values may cancel; add the signs of its terms to the domain"
    )]
    Unbounded(String),
}

impl KernelError {
    /// Whether the formula can still be taken as it is written, in certified arithmetic. Without the signs of its
    /// coefficients a polynomial may have no positive root, or several: that only a contract can say.
    #[must_use]
    pub fn leaves_the_formula_as_written(&self) -> bool {
        !matches!(self, Self::Lower(_) | Self::Written { .. } | Self::Root { cause: RootError::Signs(_), .. })
    }
}

/// What one formula may take, in the units of [`limited`]: some 25 times what the hardest of the shipped ones takes.
const WORK: u64 = 50_000_000;

/// Makes a kernel in a stable form.
///
/// # Errors
/// See [`KernelError`].
pub fn make(
    algebra: Algebra,
    contract: &Contract,
    kernel: &KernelContract,
    references: &[Definition],
) -> Result<KernelText, KernelError> {
    limited(WORK, || stable(algebra, contract, kernel, references))
        .unwrap_or_else(|TooMuchWork| Err(KernelError::TooMuchWork(kernel.name.clone())))
}

/// Makes a kernel of the formula as it is written, which certifies every call, `because` no stable form is there.
///
/// # Errors
/// See [`KernelError::Written`].
pub fn make_as_written(
    contract: &Contract,
    kernel: &KernelContract,
    references: &[Definition],
    because: String,
) -> Result<KernelText, KernelError> {
    let mut written = Written::new(&kernel.inputs);
    let steps = written.reference(kernel, references);
    let (conditions, outputs) = steps.map_err(|cause| KernelError::Written { function: kernel.name.clone(), cause })?;
    let mut graph = written.graph;
    outputs.iter().for_each(|&output| graph.mark(output, certified::RULE.name));
    let requires = conditions.into_iter().zip(kernel.domain.texts());
    let requires = requires.map(|(condition, text)| RequireText::new(condition, text)).collect();
    let results = kernel.results.iter().map(|result| result_text(result, CERTIFIED_ULP)).collect();
    let made = Made { requires, outputs, results, rules: vec![certified::RULE.name], precision: Precision::Certified };
    Ok(KernelText { certified_because: Some(because), ..text(contract, kernel, references, graph, made) })
}

fn stable(
    algebra: Algebra,
    contract: &Contract,
    kernel: &KernelContract,
    references: &[Definition],
) -> Result<KernelText, KernelError> {
    let mut builder = Builder::new(Tower::new(algebra, &kernel.inputs));
    let requires = domain::build(&mut builder, &kernel.domain)?;
    let expressions: Vec<Expr> = references
        .iter()
        .map(|reference| lower(&reference.body))
        .collect::<Result<_, _>>()
        .map_err(KernelError::Lower)?;
    let outputs = outputs(&mut builder, &expressions, references)?;
    let (outputs, precision) = with_few_roundings(&mut builder, &outputs, kernel);
    let results = results(&builder, kernel, &outputs, precision)?;
    let rules = builder.used_rules().iter().copied().collect();
    let made = Made { requires, outputs, results, rules, precision };
    Ok(text(contract, kernel, references, builder.graph, made))
}

/// What is made of a kernel's formulas, besides the graph of its steps.
struct Made {
    requires: Vec<RequireText>,
    outputs: Vec<Node>,
    results: Vec<ResultText>,
    rules: Vec<&'static str>,
    precision: Precision,
}

fn text(
    contract: &Contract,
    kernel: &KernelContract,
    references: &[Definition],
    graph: Graph,
    made: Made,
) -> KernelText {
    let inputs: Vec<InputDoc> = contract
        .inputs_of(kernel)
        .into_iter()
        .zip(&kernel.inputs)
        .map(|(input, maxima)| InputDoc {
            name: input.name.clone(),
            maxima: maxima.clone(),
            unit: input.unit.clone(),
            doc: input.doc.clone(),
            typical: input.typical,
        })
        .collect();
    let mut taken: Vec<String> = inputs.iter().map(|input| input.name.clone()).collect();
    taken.push(kernel.name.clone());
    let program = name_steps(&graph, &made.outputs, &taken);
    KernelText {
        name: kernel.name.clone(),
        doc: kernel.doc.clone(),
        maxima: references.iter().map(ToString::to_string).collect(),
        latex: references.iter().map(latex).collect::<Vec<_>>().join(r" \\ "),
        source: kernel.source.clone(),
        branch: kernel.branch.clone(),
        edges: kernel.edges.clone(),
        returns: kernel.returns.clone(),
        inputs,
        requires: made.requires,
        results: made.results,
        rules: made.rules,
        precision: made.precision,
        certified_because: None,
        program,
        graph,
    }
}

fn latex(reference: &Definition) -> String {
    format!(
        "{} = {}",
        to_latex(&closedform_maxima::ExprKind::Symbol(reference.name.clone()).into()),
        to_latex(&reference.body)
    )
}

fn outputs(builder: &mut Builder, expressions: &[Expr], references: &[Definition]) -> Result<Vec<Node>, KernelError> {
    if let ([Expr::PositiveRoot { polynomial, unknown }], [reference]) = (expressions, references) {
        return Ok(vec![positive_root(builder, polynomial, unknown, &reference.name)?]);
    }
    let mut elements = Vec::new();
    for (expression, reference) in expressions.iter().zip(references) {
        for item in items(expression) {
            let element = builder.tower.canonical(item);
            elements.push(element.map_err(|cause| KernelError::Tower { function: reference.name.clone(), cause })?);
        }
    }
    let function = references.first().map(|reference| reference.name.clone()).unwrap_or_default();
    let nodes = stabilise(builder, &elements).map_err(|cause| KernelError::Tower { function, cause })?;
    let mut nodes = nodes.into_iter();
    let mut joined = |expression: &Expr| match expression {
        Expr::Extreme { largest, items } => {
            Some(builder.graph.extreme(*largest, nodes.by_ref().take(items.len()).collect()))
        }
        _ => nodes.next(),
    };
    Ok(expressions.iter().filter_map(&mut joined).collect())
}

/// The outputs with roundings as few as they should be: by slices where plain steps have too many, or in double-double.
fn with_few_roundings(builder: &mut Builder, outputs: &[Node], kernel: &KernelContract) -> (Vec<Node>, Precision) {
    let unused = builder.used_rules().clone();
    let gathered = gathered::apply(builder, outputs, kernel.few_roundings);
    let gathered = with_one_division(builder, gathered, kernel, Products::Slices);
    let used = builder.used_rules().clone();
    builder.reset_rules(unused);
    let plain = with_one_division(builder, outputs.to_vec(), kernel, Products::Steps);
    if double_double::apply(builder, &plain, &gathered, kernel.few_roundings) {
        return (plain, Precision::DoubleDouble);
    }
    builder.reset_rules(used);
    (gathered, Precision::Double)
}

fn with_one_division(
    builder: &mut Builder,
    outputs: Vec<Node>,
    kernel: &KernelContract,
    products: Products,
) -> Vec<Node> {
    if kernel.one_division { one_reciprocal::apply(builder, &outputs, products) } else { outputs }
}

/// The closed forms that a result chooses from, mostly one.
fn items(expression: &Expr) -> &[Expr] {
    match expression {
        Expr::Extreme { items, .. } => items,
        form => std::slice::from_ref(form),
    }
}

fn positive_root(builder: &mut Builder, polynomial: &Expr, unknown: &str, function: &str) -> Result<Node, KernelError> {
    let tower_error = |cause| KernelError::Tower { function: function.to_owned(), cause };
    let (polynomial, unknown) = builder.tower.polynomial_in(polynomial, unknown).map_err(tower_error)?;
    falling_newton::apply(builder, &polynomial, unknown)
        .map_err(|cause| KernelError::Root { function: function.to_owned(), cause })
}

fn results(
    builder: &Builder,
    kernel: &KernelContract,
    outputs: &[Node],
    precision: Precision,
) -> Result<Vec<ResultText>, KernelError> {
    let error = |node| match precision {
        Precision::Double => builder.graph.error(node),
        Precision::DoubleDouble | Precision::Certified => double_double::error(&builder.graph, node),
    };
    kernel
        .results
        .iter()
        .zip(outputs)
        .map(|(result, &node)| {
            let bound = bound_in_ulp(error(node));
            let bound = bound.ok_or_else(|| KernelError::Unbounded(result.worksheet.clone()))?;
            Ok(result_text(result, bound))
        })
        .collect()
}

fn result_text(result: &ResultContract, bound: f64) -> ResultText {
    ResultText { name: result.name.clone(), worksheet: result.worksheet.clone(), unit: result.unit.clone(), bound }
}

/// A relative error in units of 2^-53 as a bound in ulp, rounded up.
///
/// An error of k units is less than k ulp. A single rounding of a value that is right to far beyond 53 bits is off by half
/// an ulp and that little more.
fn bound_in_ulp(error: f64) -> Option<f64> {
    let bound = if error < 1.25 { error - 0.5 } else { error };
    error.is_finite().then(|| (bound.max(0.0) * 100.0).ceil() / 100.0)
}

impl RequireText {
    /// A condition with the contract's text.
    #[must_use]
    pub fn new(condition: crate::program::Condition, text: &str) -> Self {
        Self { condition, text: text.to_owned() }
    }
}
