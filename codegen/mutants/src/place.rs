//! Places: the statements of a kernel, as text and by line.

use closedform_syntax::{Condition, Expr, Kernel, Output, condition_text, expression_text};
use proc_macro2::Span;

use super::mistake::Mistake;

/// A statement of a kernel that can be mutated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A `require!`, by position.
    Require(usize),
    /// A `let`, by position.
    Let(usize),
    /// A result, by position.
    Result(usize),
}

/// What a mutation changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The line of the generated file.
    pub line: usize,
    /// The mistake.
    pub mistake: Mistake,
    /// Whether it leaves out a branch that is listed as never taken; what follows is made of what it leaves.
    pub unreached: bool,
    /// The statement of the kernel.
    pub was: String,
    /// The statement of the mutant.
    pub is: String,
}

impl Change {
    /// What a mistake changed of a statement.
    pub fn new(line: usize, mistake: Mistake, was: String, is: String) -> Self {
        Change { line, mistake, unreached: false, was, is }
    }
}

impl Part {
    /// Every statement of a kernel, in order.
    pub fn all(kernel: &Kernel) -> Vec<Part> {
        let requires = (0..kernel.requires.len()).map(Part::Require);
        let lets = (0..kernel.lets.len()).map(Part::Let);
        requires.chain(lets).chain((0..kernel.output.values().count()).map(Part::Result)).collect()
    }

    /// The step that the statement is, by which its mistakes are called.
    pub fn step(self, kernel: &Kernel) -> String {
        match (self, &kernel.output) {
            (Part::Require(at), _) => format!("condition {}", at + 1),
            (Part::Let(at), _) => format!("let {}", kernel.lets[at].name),
            (Part::Result(_), Output::Value(_)) => "result".to_owned(),
            (Part::Result(at), Output::Struct { fields, .. }) => format!("result {}", fields[at].0),
        }
    }

    /// The statement as text.
    pub fn text(self, kernel: &Kernel) -> String {
        match (self, &kernel.output) {
            (Part::Require(at), _) => format!("require!({});", condition_text(&kernel.requires[at].condition)),
            (Part::Let(at), _) => {
                let step = &kernel.lets[at];
                format!("let {} = {};", step.name, expression_text(&step.value))
            }
            (Part::Result(_), Output::Value(value)) => expression_text(value),
            (Part::Result(at), Output::Struct { fields, .. }) => {
                let (name, value) = &fields[at];
                format!("{name}: {},", expression_text(value))
            }
        }
    }

    /// The line on which the statement begins, in the text that the kernel was read from.
    pub fn line(self, kernel: &Kernel) -> usize {
        let span = match (self, &kernel.output) {
            (Part::Require(at), _) => first_of_condition(&kernel.requires[at].condition),
            (Part::Let(at), _) => kernel.lets[at].name.span(),
            (Part::Result(_), Output::Value(value)) => first(value),
            (Part::Result(at), Output::Struct { fields, .. }) => fields[at].0.span(),
        };
        span.start().line
    }
}

/// Where the first number or name of a condition stands.
fn first_of_condition(condition: &Condition) -> Span {
    condition.sides().first().map_or_else(Span::call_site, |side| first(side))
}

/// Where the first number or name of an expression stands.
fn first(expr: &Expr) -> Span {
    match expr {
        Expr::Literal { span, .. } | Expr::Pi(span) => *span,
        Expr::Name(name) => name.ident.span(),
        _ => expr.children().first().map_or_else(Span::call_site, |child| first(child)),
    }
}
