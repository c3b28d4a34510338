//! Expressions and conditions of the kernel language, as text.

use crate::program::{CompensatedExpr, Condition, Graph, Node, Op, Program};
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// How far a line may go before it is broken.
pub const WIDTH: usize = 110;

const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const UNARY: u8 = 3;
const ATOM: u8 = 4;

/// Prints the nodes of a graph with the names of inputs and steps.
pub struct Printer<'g> {
    graph: &'g Graph,
    inputs: &'g [String],
    program: Option<&'g Program>,
}

/// A printed expression: an atom, or a chain of operands that a line may break between.
struct Text {
    precedence: u8,
    head: String,
    tail: Vec<(&'static str, String)>,
}

impl Text {
    fn atom(text: String) -> Self {
        Self { precedence: ATOM, head: text, tail: Vec::new() }
    }

    fn flat(&self) -> String {
        self.tail.iter().fold(self.head.clone(), |text, (op, operand)| format!("{text} {op} {operand}"))
    }

    fn wrapped(&self, least: u8) -> String {
        if self.precedence < least { format!("({})", self.flat()) } else { self.flat() }
    }

    fn broken(&self, indent: usize) -> String {
        let flat = self.flat();
        if self.tail.is_empty() || flat.len() + indent <= WIDTH {
            return flat;
        }
        let pad = " ".repeat(indent);
        self.tail.iter().fold(self.head.clone(), |text, (op, operand)| format!("{text}\n{pad}{op} {operand}"))
    }
}

impl<'g> Printer<'g> {
    /// A printer that writes every step in full.
    #[must_use]
    pub fn new(graph: &'g Graph, inputs: &'g [String]) -> Self {
        Self { graph, inputs, program: None }
    }

    /// A printer that writes the named steps of a program by name.
    #[must_use]
    pub fn with_steps(graph: &'g Graph, inputs: &'g [String], program: &'g Program) -> Self {
        Self { graph, inputs, program: Some(program) }
    }

    /// The value of a node, by name if it has one.
    #[must_use]
    pub fn value(&self, node: Node, indent: usize) -> String {
        match self.program.and_then(|program| program.name_of(node)) {
            Some(name) => name.to_owned(),
            None => self.definition(node, indent),
        }
    }

    /// What a named step computes.
    #[must_use]
    pub fn definition(&self, node: Node, indent: usize) -> String {
        match self.graph.op(node) {
            Op::Compensated(expression) => self.compensated_expression("compensated", expression, indent),
            Op::Residual(expression) => self.compensated_expression("residual", expression, indent),
            Op::If(condition, then, otherwise) => self.choice(condition, *then, *otherwise, indent),
            _ => self.operation(node).broken(indent),
        }
    }

    fn choice(&self, condition: &Condition, then: Node, otherwise: Node, indent: usize) -> String {
        let (outer, inner) = (" ".repeat(indent - 4), " ".repeat(indent));
        let flat = self.flat_choice(condition, then, otherwise);
        if flat.len() + indent <= WIDTH {
            return flat;
        }
        format!(
            "if {} {{\n{inner}{}\n{outer}}} else {{\n{inner}{}\n{outer}}}",
            self.condition(condition),
            self.value(then, indent + 4),
            self.value(otherwise, indent + 4)
        )
    }

    fn flat_choice(&self, condition: &Condition, then: Node, otherwise: Node) -> String {
        let (condition, then) = (self.condition(condition), self.text(then).flat());
        format!("if {condition} {{ {then} }} else {{ {} }}", self.text(otherwise).flat())
    }

    fn list(&self, nodes: &[Node]) -> String {
        nodes.iter().map(|&node| self.text(node).flat()).collect::<Vec<_>>().join(", ")
    }

    fn compensated_expression(&self, name: &str, expression: &CompensatedExpr, indent: usize) -> String {
        let inner = self.expression(expression);
        let flat = inner.flat();
        if flat.len() + indent <= WIDTH {
            return format!("{name}!({flat})");
        }
        let pad = " ".repeat(indent);
        format!("{name}!(\n{pad}{}\n{})", inner.broken(indent), " ".repeat(indent - 4))
    }

    /// A condition.
    #[must_use]
    pub fn condition(&self, condition: &Condition) -> String {
        match condition {
            Condition::Compare(a, order, b) => {
                format!("{} {} {}", self.text(*a).flat(), order.rust(), self.text(*b).flat())
            }
            Condition::And(a, b) => format!("{} && {}", self.inner(a), self.inner(b)),
            Condition::Or(a, b) => format!("{} || {}", self.inner(a), self.inner(b)),
            Condition::Not(a) => format!("!({})", self.condition(a)),
        }
    }

    fn inner(&self, condition: &Condition) -> String {
        match condition {
            Condition::And(..) | Condition::Or(..) => format!("({})", self.condition(condition)),
            _ => self.condition(condition),
        }
    }

    fn text(&self, node: Node) -> Text {
        match self.program.and_then(|program| program.name_of(node)) {
            Some(name) => Text::atom(name.to_owned()),
            None => self.operation(node),
        }
    }

    fn operation(&self, node: Node) -> Text {
        match self.graph.op(node) {
            Op::Input(index) => Text::atom(self.inputs[*index].clone()),
            Op::Literal(value) => literal(value),
            Op::Pi => Text::atom("PI".to_owned()),
            Op::Neg(a) => negative(&self.text(*a)),
            Op::Add(a, b) => chain(SUM, self.text(*a), "+", &self.text(*b)),
            Op::Sub(a, b) => chain(SUM, self.text(*a), "-", &self.text(*b)),
            Op::Mul(a, b) => chain(PRODUCT, self.text(*a), "*", &self.text(*b)),
            Op::Div(a, b) => chain(PRODUCT, self.text(*a), "/", &self.text(*b)),
            Op::Call(function, a) => Text::atom(format!("{}({})", function.name(), self.text(*a).flat())),
            Op::If(condition, a, b) => Text::atom(self.flat_choice(condition, *a, *b)),
            Op::Compensated(expression) => Text::atom(format!("compensated!({})", self.expression(expression).flat())),
            Op::Residual(expression) => Text::atom(format!("residual!({})", self.expression(expression).flat())),
            Op::Max(items) => Text::atom(format!("max({})", self.list(items))),
            Op::Min(items) => Text::atom(format!("min({})", self.list(items))),
            Op::PositiveRoot(coefficients) => Text::atom(format!("positive_root([{}])", self.list(coefficients))),
        }
    }

    fn expression(&self, expression: &CompensatedExpr) -> Text {
        match expression {
            CompensatedExpr::Leaf(node) => self.text(*node),
            CompensatedExpr::Neg(a) => negative(&self.expression(a)),
            CompensatedExpr::Add(a, b) => chain(SUM, self.expression(a), "+", &self.expression(b)),
            CompensatedExpr::Sub(a, b) => chain(SUM, self.expression(a), "-", &self.expression(b)),
            CompensatedExpr::Mul(a, b) => chain(PRODUCT, self.expression(a), "*", &self.expression(b)),
        }
    }
}

/// `left op right`, left-associative: the right operand keeps its parentheses unless it binds tighter.
fn chain(precedence: u8, left: Text, op: &'static str, right: &Text) -> Text {
    let operand = right.wrapped(precedence + 1);
    if left.precedence == precedence {
        let mut text = left;
        text.tail.push((op, operand));
        return text;
    }
    Text { precedence, head: left.wrapped(precedence), tail: vec![(op, operand)] }
}

fn negative(operand: &Text) -> Text {
    Text { precedence: UNARY, head: format!("-{}", operand.wrapped(ATOM)), tail: Vec::new() }
}

/// A constant that `f64` holds exactly, in the shortest decimal that reads back.
fn literal(value: &BigRational) -> Text {
    let number = value.to_f64().unwrap_or(f64::NAN);
    let precedence = if number < 0.0 { UNARY } else { ATOM };
    Text { precedence, head: format!("{number:?}"), tail: Vec::new() }
}
