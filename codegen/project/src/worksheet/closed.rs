//! Formulas that Maxima has computed: each definition is what it says, and nothing is put in or evaluated any more.

use std::collections::BTreeMap;

use closedform_maxima::ast::Quoting;
use closedform_maxima::{BinaryOperator, Expr, ExprKind, parse_what_can_be};

use super::arrays::{Names, names_in};
use super::evaluate::Evaluator;
use super::formula::{Outcome, marked_in, outcome_with_items as outcome};
use super::reading::Reading;
use super::state::{Evaluated, Refusal, State};
use super::tree::{find, list, map};
use super::words;

/// Reads `f(x):=formula$`, `name:formula$` and `assume(x>0)$`.
pub(crate) fn closed(text: &str) -> Reading {
    let (statements, errors) = parse_what_can_be(text);
    let mut reading = Reading { errors, ..Reading::default() };
    let names = Names::beside(names_in(text, &statements));
    let mut evaluator = Evaluator::new(State::default(), BTreeMap::new(), names);
    for statement in &statements {
        if let Some(("assume", facts)) = statement.expression.as_call() {
            evaluator.state.facts.extend(facts.iter().map(super::statements::comparison));
        }
    }
    for statement in &statements {
        let Some((name, parameters, value)) = definition(&statement.expression) else { continue };
        let (parameters, value) = applied(parameters, value);
        let span = &statement.expression.span;
        let outcome = match uncomputed(&name, &value) {
            Some(because) => Outcome::Refused(because),
            None => {
                let value = subscripts_named(&marked_in(&value, &parameters), &mut evaluator);
                outcome(&name, parameters, value, span, &evaluator)
            }
        };
        match outcome {
            Outcome::Formula(formula) => reading.formulas.push(formula),
            Outcome::Constant => reading.constants.push(name),
            Outcome::Refused(because) => reading.refused.push((name, because)),
        }
    }
    reading.refuse_clashes();
    reading
}

fn definition(statement: &Expr) -> Option<(String, Vec<String>, Expr)> {
    let ExprKind::Binary { operator, left, right } = &statement.kind else { return None };
    match operator {
        BinaryOperator::Assign => Some((left.as_symbol()?.to_owned(), Vec::new(), (**right).clone())),
        BinaryOperator::Define => {
            let (name, parameters) = left.as_call()?;
            let parameters = parameters.iter().map(|parameter| parameter.as_symbol().map(str::to_owned));
            Some((name.to_owned(), parameters.collect::<Option<_>>()?, (**right).clone()))
        }
        _ => None,
    }
}

/// A function that a name stands for, `lambda([x],body)`, as a function of that name.
fn applied(parameters: Vec<String>, value: Expr) -> (Vec<String>, Expr) {
    let Some(("lambda", [own, body])) = value.as_call() else { return (parameters, value) };
    let names = list(own).and_then(|names| names.iter().map(|name| name.as_symbol().map(str::to_owned)).collect());
    match names {
        Some(own) if parameters.is_empty() => (own, body.clone()),
        _ => (parameters, value),
    }
}

/// A value with names for its elements of arrays and items of parameters.
fn subscripts_named(value: &Expr, evaluator: &mut Evaluator) -> Evaluated {
    match &value.kind {
        ExprKind::Subscript { array, indices } => {
            let array = subscripts_named(array, evaluator)?;
            evaluator.element(&array, indices, &value.span)
        }
        _ => map(value, &mut |part| subscripts_named(part, evaluator)),
    }
}

/// What Maxima has left to be computed.
fn uncomputed(name: &str, value: &Expr) -> Option<Refusal> {
    let mut left = None;
    find(value, &mut |part| {
        let function = match &part.kind {
            ExprKind::Quote { quoting: Quoting::Noun, expression } => {
                expression.as_call().map(|(function, _)| function)
            }
            _ => part.as_call().map(|(function, _)| function).filter(|function| words::computes(function)),
        };
        if let Some(function) = function
            && left.is_none()
        {
            let what = format!("`{name}` has no closed form: Maxima leaves `{function}` as it is");
            let remedy = "say more with assume(..), give its unknowns values, or leave it to another method";
            left = Some(Refusal::new(what, remedy, &part.span));
        }
    });
    left
}
