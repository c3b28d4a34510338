//! Expressions of FPCore as Maxima's, names that `let` gives put in.

use closedform_maxima::ast::Branch;
use closedform_maxima::{Expr, ExprKind, parse_expression};

use super::mistake::CoreMistake;
use super::name::formats;
use super::number::{digits, number};
use super::operation::operation;
use super::read::{Node, NodeKind};
use super::scope::{Callable, Scope, Value};

/// The constants, as Maxima writes them.
const CONSTANTS: [(&str, &str); 15] = [
    ("E", "%e"),
    ("LOG2E", "1/log(2)"),
    ("LOG10E", "1/log(10)"),
    ("LN2", "log(2)"),
    ("LN10", "log(10)"),
    ("PI", "%pi"),
    ("PI_2", "%pi/2"),
    ("PI_4", "%pi/4"),
    ("M_1_PI", "1/%pi"),
    ("M_2_PI", "2/%pi"),
    ("M_2_SQRTPI", "2/sqrt(%pi)"),
    ("SQRT2", "sqrt(2)"),
    ("SQRT1_2", "sqrt(1/2)"),
    ("TRUE", "true"),
    ("FALSE", "false"),
];

/// What is known to FPCore, and no formula.
const STEPS: [&str; 8] = ["while", "while*", "for", "for*", "tensor", "tensor*", "array", "cast"];

/// What is written in a way of its own.
const FORMS: [(&str, &str); 5] = [
    ("if", "(if condition value value)"),
    ("let", "(let ([name value] ..) body)"),
    ("let*", "(let* ([name value] ..) body)"),
    ("!", "(! :property value .. body)"),
    ("digits", "(digits mantissa exponent base)"),
];

/// The formula that an expression is.
pub(super) fn expression(node: &Node, scope: &mut Scope<'_>) -> Result<Value, CoreMistake> {
    match &node.kind {
        NodeKind::Atom(name) => atom(node, name, scope),
        NodeKind::Text(_) => Err(CoreMistake::new("a string in a formula", "remove it", node.span.clone())),
        NodeKind::List(parts) => list(node, parts, scope),
    }
}

fn atom(node: &Node, name: &str, scope: &Scope) -> Result<Value, CoreMistake> {
    if let Some(value) = scope.value(name, &node.span) {
        return value;
    }
    let constant = CONSTANTS.iter().find(|(constant, _)| *constant == name);
    let known = constant.and_then(|(_, maxima)| parse_expression(maxima).ok()).map(|mut constant| {
        place(&mut constant, node);
        constant
    });
    match known.or_else(|| number(name).map(|kind| placed(kind, node))) {
        Some(constant) => Value::made(&node.span, Vec::new(), |_| constant),
        None => {
            let remedy = "name an argument of the core, or a constant of FPCore but INFINITY and NAN";
            Err(CoreMistake::new(format!("`{name}` is no real number that is known here"), remedy, node.span.clone()))
        }
    }
}

fn placed(kind: ExprKind, node: &Node) -> Expr {
    let mut expr = Expr::from(kind);
    place(&mut expr, node);
    expr
}

/// What is written as one name or number is one place.
fn place(expr: &mut Expr, node: &Node) {
    expr.span = node.span.clone();
    match &mut expr.kind {
        ExprKind::Unary { operand, .. } => place(operand, node),
        ExprKind::Binary { left, right, .. } => [left, right].into_iter().for_each(|part| place(part, node)),
        ExprKind::Call { arguments, .. } => arguments.iter_mut().for_each(|part| place(part, node)),
        _ => {}
    }
}

fn list(node: &Node, parts: &[Node], scope: &mut Scope<'_>) -> Result<Value, CoreMistake> {
    let Some((head, operands)) = parts.split_first() else {
        return Err(CoreMistake::new("an empty expression", "write (operation operand ..)", node.span.clone()));
    };
    let Some(name) = head.atom() else {
        return Err(CoreMistake::new("no operation", "write its name first: (+ x y)", head.span.clone()));
    };
    match (name, operands) {
        ("if", [condition, one, other]) => {
            let parts = [condition, one, other].map(|part| expression(part, scope));
            let [condition, one, other] = parts;
            Value::made(&node.span, vec![condition?, one?, other?], conditional)
        }
        ("let" | "let*", [bindings, body]) => bound(bindings, body, name == "let*", scope),
        ("!", [properties @ .., body]) => {
            formats(properties)?;
            expression(body, scope)
        }
        ("digits", [mantissa, exponent, base]) => {
            let [mantissa, exponent, base] = [mantissa, exponent, base].map(|part| part.atom().unwrap_or_default());
            let wrong = || CoreMistake::new("no number", "write (digits 123 -2 10)", node.span.clone());
            let number = digits(mantissa, exponent, base).ok_or_else(wrong)?;
            Value::made(&node.span, Vec::new(), |_| placed(number, node))
        }
        (name, _) if STEPS.contains(&name) => {
            let what = format!("`{name}` is no formula");
            Err(CoreMistake::new(what, "write what it comes to, as a closed form", node.span.clone()))
        }
        (name, _) if FORMS.iter().any(|(form, _)| *form == name) => {
            let form = FORMS.iter().find(|(form, _)| *form == name).map_or("", |(_, form)| form);
            Err(CoreMistake::new(
                format!("`{name}` is not written like this"),
                format!("write {form}"),
                node.span.clone(),
            ))
        }
        _ => {
            let operands: Vec<Value> =
                operands.iter().map(|operand| expression(operand, scope)).collect::<Result<_, _>>()?;
            match scope.core(name) {
                Some(core) => called(core, operands, node, scope),
                None => operation(name, operands, &node.span),
            }
        }
    }
}

/// The body of an earlier core, its arguments put in.
fn called(core: &Callable, operands: Vec<Value>, node: &Node, scope: &Scope) -> Result<Value, CoreMistake> {
    if operands.len() != core.parameters.len() {
        let what = format!("`{}` takes {} arguments, not {}", core.name, core.parameters.len(), operands.len());
        return Err(CoreMistake::new(what, "correct the call, or the core", node.span.clone()));
    }
    let mut inside = scope.of_core(&node.span)?;
    core.parameters.iter().cloned().zip(operands).for_each(|(name, value)| inside.set(name, value));
    expression(core.body, &mut inside)
}

fn conditional(parts: Vec<Expr>) -> Expr {
    let mut parts = parts.into_iter();
    match (parts.next(), parts.next(), parts.next()) {
        (Some(condition), Some(value), otherwise) => {
            ExprKind::If { branches: vec![Branch { condition, value }], otherwise: otherwise.map(Box::new) }.into()
        }
        _ => ExprKind::Sequence(Vec::new()).into(),
    }
}

/// `(let ([name value] ..) body)`; each value of `let*` may name those before it.
fn bound(bindings: &Node, body: &Node, in_turn: bool, scope: &mut Scope<'_>) -> Result<Value, CoreMistake> {
    let wrong = |place: &Node| CoreMistake::new("no binding", "write (let ([name value] ..) body)", place.span.clone());
    let (before, mut values) = (scope.len(), Vec::new());
    for binding in bindings.list().ok_or_else(|| wrong(bindings))? {
        let [name, value] = binding.list().unwrap_or_default() else { return Err(wrong(binding)) };
        let name = name.atom().ok_or_else(|| wrong(binding))?.to_owned();
        let value = expression(value, scope)?;
        match in_turn {
            true => scope.set(name, value),
            false => values.push((name, value)),
        }
    }
    values.into_iter().for_each(|(name, value)| scope.set(name, value));
    let body = expression(body, scope);
    scope.forget(before);
    body
}
