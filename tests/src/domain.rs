//! The domain of a kernel, decided exactly from the texts of its conditions: a twin of the project's, on purpose.

use closedform::Info;
use closedform_maxima::ast::BinaryOperator;
use closedform_maxima::{Expr, ExprKind, UnaryOperator, parse_expression};
use rug::Rational;

use crate::rational::{self, Names};

/// What a kernel calls the condition that comes before all others.
pub const FINITE: &str = "every input is finite";

/// The conditions of a kernel, with the names of its inputs.
#[derive(Clone, Debug)]
pub struct Domain {
    names: Vec<&'static str>,
    conditions: Vec<(&'static str, Expr)>,
}

impl Domain {
    /// The domain that `info` states.
    ///
    /// # Panics
    ///
    /// A condition is not Maxima text.
    pub fn new(info: &Info) -> Self {
        let parse = |text: &&'static str| match parse_expression(text) {
            Ok(condition) => (*text, condition),
            Err(errors) => panic!("{}: condition `{text}`: {errors}", info.name),
        };
        let names = info.inputs.iter().map(|input| input.maxima).collect();
        Domain { names, conditions: info.domain.iter().map(parse).collect() }
    }

    /// The first condition that these inputs violate.
    pub fn violated(&self, inputs: &[f64]) -> Option<&'static str> {
        if !inputs.iter().all(|input| input.is_finite()) {
            return Some(FINITE);
        }
        let names = self.exactly(inputs);
        let fails = |condition: &Expr| rational::holds(condition, &names) != Some(true);
        self.conditions.iter().find(|(_, condition)| fails(condition)).map(|(text, _)| *text)
    }

    /// Whether these inputs lie inside.
    pub fn contains(&self, inputs: &[f64]) -> bool {
        self.violated(inputs).is_none()
    }

    /// The names of the inputs with their exact values.
    pub fn exactly(&self, inputs: &[f64]) -> Names<'static> {
        let exact = inputs.iter().map(|input| Rational::from_f64(*input).expect("inputs are finite"));
        self.names.iter().copied().zip(exact).collect()
    }

    /// Whether the conditions on this input alone allow `value`.
    pub fn allows(&self, input: usize, value: f64) -> bool {
        let name = self.names[input];
        let names: Names = [(name, Rational::from_f64(value).expect("finite"))].into();
        // Conditions on more inputs have no value here.
        self.conditions.iter().all(|(_, condition)| rational::holds(condition, &names) != Some(false))
    }

    /// For every comparison the difference of its sides: it is zero at that edge of the domain.
    pub fn edges(&self) -> Vec<Expr> {
        let mut edges = Vec::new();
        self.conditions.iter().for_each(|(_, condition)| collect_edges(condition, &mut edges));
        edges
    }
}

fn collect_edges(condition: &Expr, edges: &mut Vec<Expr>) {
    match &condition.kind {
        ExprKind::Unary { operator: UnaryOperator::Not, operand } => collect_edges(operand, edges),
        ExprKind::Binary { operator: BinaryOperator::And | BinaryOperator::Or, left, right } => {
            collect_edges(left, edges);
            collect_edges(right, edges);
        }
        ExprKind::Binary { left, right, .. } => {
            let (left, right) = (left.clone(), right.clone());
            edges.push(ExprKind::Binary { operator: BinaryOperator::Subtract, left, right }.into());
        }
        _ => {}
    }
}
