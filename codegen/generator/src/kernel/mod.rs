//! Kernels: from a contract and its reference expressions to the text of a kernel, proved equal to them.

mod as_written;
mod domain;
mod domain_proof;
mod error;
mod example;
mod formula;
mod known;
mod limit;
mod proof;
mod read_back;
mod written;

pub use error::KernelError;
pub use example::golden_example;
pub use proof::{ProofError, prove};
pub use written::WrittenError;

use crate::algebra::Algebra;
use crate::field::Tower;
use crate::program::{Graph, Node, name_steps};
use crate::rust::{InputDoc, KernelText, RequireText, ResultText, RuleText};
use crate::stable::builder::Builder;
use crate::stable::candidate::Candidate;
use crate::stable::rule::Rule;
use crate::stable::solvers::Equation;
use crate::stable::strategy::{self, Wanted};
use closedform_arith::error_model::CERTIFIED_ULP;
use closedform_maxima::{Definition, to_latex};
use closedform_project::contract::{Contract, KernelContract, ResultContract};
use closedform_project::expression::{Expr, lower};
use closedform_syntax::Precision;
use limit::within_limit;
use written::Written;

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
    within_limit(kernel, || stable(algebra, contract, kernel, references))
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
    outputs.iter().for_each(|&output| graph.mark(output, strategy::AS_WRITTEN.name));
    let requires = conditions.into_iter().zip(kernel.domain.texts());
    let requires = requires.map(|(condition, text)| RequireText::new(condition, text)).collect();
    let results = kernel.results.iter().map(|result| result_text(result, CERTIFIED_ULP)).collect();
    let rules = vec![rule_text(strategy::AS_WRITTEN)];
    let made = Made { requires, outputs, results, rules, precision: Precision::Certified };
    Ok(KernelText { certified_because: Some(because), ..text(contract, kernel, references, graph, made) })
}

fn stable(
    algebra: Algebra,
    contract: &Contract,
    kernel: &KernelContract,
    references: &[Definition],
) -> Result<KernelText, KernelError> {
    let mut builder = strategy::builder(Tower::new(algebra, &kernel.inputs));
    let requires = domain::build(&mut builder, &kernel.domain)?;
    let expressions: Vec<Expr> = references
        .iter()
        .map(|reference| lower(&reference.body))
        .collect::<Result<_, _>>()
        .map_err(KernelError::Lower)?;
    let outputs = outputs(&mut builder, &expressions, references)?;
    let wanted = Wanted { few_roundings: kernel.few_roundings, one_division: kernel.one_division };
    let candidate = strategy::finished(builder.graph, outputs, wanted);
    let results = results(kernel, &candidate)?;
    let rules = rules(&candidate, &requires);
    let Candidate { graph, outputs, precision } = candidate;
    let made = Made { requires, outputs, results, rules, precision };
    Ok(text(contract, kernel, references, graph, made))
}

/// The rules that made what a kernel computes and decides.
fn rules(candidate: &Candidate, requires: &[RequireText]) -> Vec<RuleText> {
    let conditions: Vec<Node> = requires.iter().flat_map(|require| require.condition.nodes()).collect();
    strategy::rules_named(candidate.rules(&conditions)).into_iter().map(rule_text).collect()
}

fn rule_text(rule: &Rule) -> RuleText {
    RuleText { name: rule.name, statement: rule.statement, condition: rule.condition }
}

/// What is made of a kernel's formulas, besides the graph of its steps.
struct Made {
    requires: Vec<RequireText>,
    outputs: Vec<Node>,
    results: Vec<ResultText>,
    rules: Vec<RuleText>,
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
        example: None,
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
    let nodes = strategy::results(builder, &elements).map_err(|cause| KernelError::Tower { function, cause })?;
    let mut nodes = nodes.into_iter();
    let mut joined = |expression: &Expr| match expression {
        Expr::Extreme { largest, items } => {
            Some(builder.graph.extreme(*largest, nodes.by_ref().take(items.len()).collect()))
        }
        _ => nodes.next(),
    };
    Ok(expressions.iter().filter_map(&mut joined).collect())
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
    strategy::SOLVER(builder, &Equation { polynomial, unknown })
        .map_err(|cause| KernelError::Root { function: function.to_owned(), cause })
}

fn results(kernel: &KernelContract, candidate: &Candidate) -> Result<Vec<ResultText>, KernelError> {
    let of = |(result, &node): (&ResultContract, &Node)| {
        let bound = bound_in_ulp(candidate.error(node));
        let bound = bound.ok_or_else(|| KernelError::Unbounded(result.worksheet.clone()))?;
        Ok(result_text(result, bound))
    };
    kernel.results.iter().zip(&candidate.outputs).map(of).collect()
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
