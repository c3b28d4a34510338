//! Where an expression vanishes: solved for one input, exactly.

use closedform_maxima::ast::BinaryOperator as Operator;
use closedform_maxima::{Expr, ExprKind};
use rug::Rational;

use crate::domain::Domain;
use crate::rational;

/// An expression whose zeros are wanted, and the inputs that it names.
#[derive(Clone, Debug)]
pub struct Zeros {
    expression: Expr,
    /// The positions of the inputs that occur in it.
    pub inputs: Vec<usize>,
}

impl Zeros {
    /// The zeros of `expression`, if it is a rational function of some of the inputs `names`.
    pub fn new(expression: Expr, names: &[&str]) -> Option<Self> {
        let mut inputs = Vec::new();
        collect_inputs(&expression, names, &mut inputs)?;
        (!inputs.is_empty()).then_some(Zeros { expression, inputs })
    }

    /// The value of `input` with which the expression vanishes at the other inputs of `point`, if it is linear in it.
    pub fn solve(&self, domain: &Domain, point: &[f64], input: usize) -> Option<f64> {
        let at = |value: f64| {
            let mut inputs = point.to_vec();
            inputs[input] = value;
            rational::value(&self.expression, &domain.exactly(&inputs))
        };
        let (zero, one, two) = (at(0.0)?, at(1.0)?, at(2.0)?);
        let slope = Rational::from(&one - &zero);
        let linear = Rational::from(&two - &one) == slope;
        (linear && !slope.is_zero()).then(|| (-zero / slope).to_f64())
    }
}

/// Adds the inputs that occur; none if something else than a rational function of them does.
fn collect_inputs(expression: &Expr, names: &[&str], inputs: &mut Vec<usize>) -> Option<()> {
    match &expression.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) => {}
        ExprKind::Symbol(symbol) => {
            let position = names.iter().position(|name| name == symbol)?;
            if !inputs.contains(&position) {
                inputs.push(position);
            }
        }
        ExprKind::Unary { operand, .. } => collect_inputs(operand, names, inputs)?,
        ExprKind::Binary { left, right, .. } => {
            collect_inputs(left, names, inputs)?;
            collect_inputs(right, names, inputs)?;
        }
        _ => return None,
    }
    Some(())
}

/// Every sum, difference and name inside the expression, each once.
pub fn subterms(expression: &Expr, found: &mut Vec<Expr>) {
    let vanishes = match &expression.kind {
        ExprKind::Symbol(_) => true,
        ExprKind::Binary { operator, .. } => matches!(operator, Operator::Add | Operator::Subtract),
        _ => false,
    };
    if vanishes && !found.contains(expression) {
        found.push(expression.clone());
    }
    match &expression.kind {
        ExprKind::Unary { operand, .. } => subterms(operand, found),
        ExprKind::Binary { left, right, .. } => [left, right].into_iter().for_each(|side| subterms(side, found)),
        ExprKind::Call { arguments, .. } => arguments.iter().for_each(|argument| subterms(argument, found)),
        ExprKind::If { branches, otherwise } => {
            branches.iter().flat_map(|branch| [&branch.condition, &branch.value]).for_each(|e| subterms(e, found));
            otherwise.iter().for_each(|value| subterms(value, found));
        }
        _ => {}
    }
}
