//! Trees of values: their parts, their size, and names in them.

use std::collections::BTreeSet;
use std::ops::Range;

use closedform_maxima::ast::{Branch, LoopClause};
use closedform_maxima::{BinaryOperator, Expr, ExprKind};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// The expressions directly inside, in order.
pub(crate) fn parts(expression: &Expr) -> Vec<&Expr> {
    match &expression.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) | ExprKind::String(_) => Vec::new(),
        ExprKind::Symbol(_) => Vec::new(),
        ExprKind::Quote { expression, .. } => vec![expression],
        ExprKind::Call { function, arguments } => std::iter::once(&**function).chain(arguments).collect(),
        ExprKind::Subscript { array, indices } => std::iter::once(&**array).chain(indices).collect(),
        ExprKind::List(items) | ExprKind::Set(items) | ExprKind::Sequence(items) => items.iter().collect(),
        ExprKind::Unary { operand, .. } => vec![operand],
        ExprKind::Binary { left, right, .. } => vec![left, right],
        ExprKind::If { branches, otherwise } => {
            let inside = branches.iter().flat_map(|branch| [&branch.condition, &branch.value]);
            inside.chain(otherwise.as_deref()).collect()
        }
        ExprKind::Loop { clauses, body } => clauses.iter().map(|clause| &clause.value).chain([&**body]).collect(),
        ExprKind::Ev { expression, options } => std::iter::once(&**expression).chain(options).collect(),
    }
}

/// The expression with what `change` makes of those directly inside; the name of a called function is left alone.
pub(crate) fn map<E>(expression: &Expr, change: &mut dyn FnMut(&Expr) -> Result<Expr, E>) -> Result<Expr, E> {
    let mut boxed = |inner: &Expr| change(inner).map(Box::new);
    let kind = match &expression.kind {
        ExprKind::Quote { quoting, expression } => {
            ExprKind::Quote { quoting: *quoting, expression: boxed(expression)? }
        }
        ExprKind::Unary { operator, operand } => ExprKind::Unary { operator: *operator, operand: boxed(operand)? },
        ExprKind::Binary { operator, left, right } => {
            ExprKind::Binary { operator: *operator, left: boxed(left)?, right: boxed(right)? }
        }
        ExprKind::Call { function, arguments } => {
            let function = if function.as_symbol().is_some() { function.clone() } else { boxed(function)? };
            ExprKind::Call { function, arguments: all(arguments, change)? }
        }
        ExprKind::Subscript { array, indices } => {
            ExprKind::Subscript { array: boxed(array)?, indices: all(indices, change)? }
        }
        ExprKind::List(items) => ExprKind::List(all(items, change)?),
        ExprKind::Set(items) => ExprKind::Set(all(items, change)?),
        ExprKind::Sequence(items) => ExprKind::Sequence(all(items, change)?),
        ExprKind::If { branches, otherwise } => {
            let mut changed = Vec::new();
            for Branch { condition, value } in branches {
                changed.push(Branch { condition: change(condition)?, value: change(value)? });
            }
            let otherwise = otherwise.as_deref().map(change).transpose()?.map(Box::new);
            ExprKind::If { branches: changed, otherwise }
        }
        ExprKind::Loop { clauses, body } => {
            let mut changed = Vec::new();
            for clause in clauses {
                changed.push(LoopClause { word: clause.word, value: change(&clause.value)? });
            }
            ExprKind::Loop { clauses: changed, body: Box::new(change(body)?) }
        }
        ExprKind::Ev { expression, options } => {
            ExprKind::Ev { expression: boxed(expression)?, options: all(options, change)? }
        }
        leaf => leaf.clone(),
    };
    Ok(Expr::new(kind, expression.span.clone()))
}

fn all<E>(items: &[Expr], change: &mut dyn FnMut(&Expr) -> Result<Expr, E>) -> Result<Vec<Expr>, E> {
    items.iter().map(change).collect()
}

/// The same expression as if all of it stood at one place.
pub(super) fn at(expression: &Expr, span: &Range<usize>) -> Expr {
    let Ok(mut moved) = map::<std::convert::Infallible>(expression, &mut |part| Ok(at(part, span)));
    if let ExprKind::Call { function, .. } = &mut moved.kind {
        function.span = span.clone();
    }
    moved.span = span.clone();
    moved
}

/// The number of nodes, and the height of the tree.
pub(super) fn measure(expression: &Expr) -> (usize, usize) {
    let inside = parts(expression).into_iter().map(measure);
    let (size, height) =
        inside.fold((0_usize, 0), |(size, height), (more, high)| (size.saturating_add(more), height.max(high)));
    (size + 1, height + 1)
}

/// Whether something in the expression, or all of it, is so.
pub(crate) fn any(expression: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expression) || parts(expression).into_iter().any(|part| any(part, is))
}

/// Tells the expression and everything inside, from the outside in.
pub(super) fn find(expression: &Expr, told: &mut dyn FnMut(&Expr)) {
    told(expression);
    parts(expression).into_iter().for_each(|part| find(part, told));
}

/// Every name that is no constant of Maxima and is not called, in the order of the text.
pub(crate) fn names(expression: &Expr) -> Vec<String> {
    let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
    collect(expression, &mut |name| {
        if seen.insert(name.to_owned()) {
            found.push(name.to_owned());
        }
    });
    found
}

fn collect(expression: &Expr, found: &mut dyn FnMut(&str)) {
    match &expression.kind {
        ExprKind::Symbol(name) => found(name),
        ExprKind::Call { function, arguments } if function.as_symbol().is_some() => {
            arguments.iter().for_each(|argument| collect(argument, found));
        }
        _ => parts(expression).into_iter().for_each(|part| collect(part, found)),
    }
}

/// The expression with other expressions for names.
pub(crate) fn put(expression: &Expr, value: &dyn Fn(&str) -> Option<Expr>) -> Expr {
    match expression.as_symbol() {
        Some(name) => value(name).unwrap_or_else(|| expression.clone()),
        None => {
            let Ok(put) = map::<std::convert::Infallible>(expression, &mut |part| Ok(put(part, value)));
            put
        }
    }
}

/// The expression with other names for names, each where it stands.
pub(crate) fn renamed(expression: &Expr, name: &dyn Fn(&str) -> Option<String>) -> Expr {
    match expression.as_symbol() {
        Some(old) => name(old).map_or_else(|| expression.clone(), |new| symbol(&new, &expression.span)),
        None => {
            let Ok(changed) = map::<std::convert::Infallible>(expression, &mut |part| Ok(renamed(part, name)));
            changed
        }
    }
}

pub(super) fn symbol(name: &str, span: &Range<usize>) -> Expr {
    Expr::new(ExprKind::Symbol(name.to_owned()), span.clone())
}

pub(super) fn number(value: i64, span: &Range<usize>) -> Expr {
    let magnitude = Expr::new(ExprKind::Integer(BigInt::from(value).magnitude().clone().into()), span.clone());
    match value {
        0.. => magnitude,
        _ => crate::construct::negative(magnitude),
    }
}

/// `(1+sqrt(5))/2`, which Maxima calls `%phi`.
pub(super) fn golden_ratio(span: &Range<usize>) -> Expr {
    let sum = binary(BinaryOperator::Add, number(1, span), call("sqrt", vec![number(5, span)], span), span);
    binary(BinaryOperator::Divide, sum, number(2, span), span)
}

/// The value of a small integer.
pub(super) fn small(expression: &Expr) -> Option<i64> {
    let value = super::numbers::exact(expression)?;
    value.is_integer().then(|| value.to_integer().to_i64()).flatten()
}

/// The rows of a matrix.
pub(super) fn rows(expression: &Expr) -> Option<Vec<&[Expr]>> {
    let ("matrix", rows) = expression.as_call()? else { return None };
    rows.iter().map(list).collect()
}

/// The items of a list.
pub(super) fn list(expression: &Expr) -> Option<&[Expr]> {
    match &expression.kind {
        ExprKind::List(items) => Some(items),
        _ => None,
    }
}

pub(super) fn call(name: &str, arguments: Vec<Expr>, span: &Range<usize>) -> Expr {
    Expr::new(ExprKind::Call { function: Box::new(symbol(name, span)), arguments }, span.clone())
}

pub(super) fn binary(operator: BinaryOperator, left: Expr, right: Expr, span: &Range<usize>) -> Expr {
    Expr::new(ExprKind::Binary { operator, left: Box::new(left), right: Box::new(right) }, span.clone())
}
