//! Definitions that call each other, put into each other.

use std::collections::BTreeMap;

use closedform_maxima::{Definition, Expr, ExprKind};

use super::mistake::{SIZE_LIMIT, WorksheetMistake};

/// The definitions with every call of one of them replaced by its body, those that this is possible for, and what is wrong
/// with the others, each cause once.
pub(super) fn inline(definitions: &[Definition]) -> (Vec<Definition>, Vec<WorksheetMistake>) {
    let mut inliner = Inliner { definitions, done: BTreeMap::new(), open: Vec::new(), size: 0, mistakes: Vec::new() };
    let closed = definitions
        .iter()
        .filter_map(|definition| Some(Definition { body: inliner.body(definition)?, ..definition.clone() }))
        .collect();
    (closed, inliner.mistakes)
}

struct Inliner<'a> {
    definitions: &'a [Definition],
    /// The bodies, and none of definitions that have no closed one.
    done: BTreeMap<&'a str, Option<Expr>>,
    mistakes: Vec<WorksheetMistake>,
    /// The definitions whose bodies are being made, outermost first.
    open: Vec<&'a str>,
    /// How much was put in so far.
    size: usize,
}

impl<'a> Inliner<'a> {
    fn body(&mut self, definition: &'a Definition) -> Option<Expr> {
        if let Some(body) = self.done.get(definition.name.as_str()) {
            return body.clone();
        }
        if let Some(start) = self.open.iter().position(|name| *name == definition.name) {
            let mut cycle: Vec<String> = self.open[start..].iter().map(|name| name.to_string()).collect();
            cycle.push(definition.name.clone());
            return self.refuse(WorksheetMistake::Recursion { cycle, span: definition.span.clone().into() });
        }
        self.open.push(&definition.name);
        let body = self.expression(&definition.body);
        self.open.pop();
        self.done.insert(&definition.name, body.clone());
        body
    }

    fn refuse(&mut self, mistake: WorksheetMistake) -> Option<Expr> {
        // what is too large is so wherever it is put in
        let told = |known: &WorksheetMistake| matches!(known, WorksheetMistake::TooLarge { .. });
        if !(told(&mistake) && self.mistakes.iter().any(told)) {
            self.mistakes.push(mistake);
        }
        None
    }

    fn expression(&mut self, expression: &'a Expr) -> Option<Expr> {
        let called = expression.as_call().and_then(|(name, arguments)| {
            Some((self.definitions.iter().find(|definition| definition.name == name)?, arguments))
        });
        match called {
            Some((definition, arguments)) => self.call(expression, definition, arguments),
            None => map(expression, &mut |part| self.expression(part).ok_or(())).ok(),
        }
    }

    fn call(&mut self, call: &Expr, definition: &'a Definition, arguments: &'a [Expr]) -> Option<Expr> {
        if arguments.len() != definition.parameters.len() {
            return self.refuse(WorksheetMistake::Arguments {
                name: definition.name.clone(),
                expected: definition.parameters.len(),
                found: arguments.len(),
                span: call.span.clone().into(),
            });
        }
        let body = self.body(definition)?;
        let arguments: Vec<Expr> = arguments.iter().map(|argument| self.expression(argument)).collect::<Option<_>>()?;
        let values: BTreeMap<&str, &Expr> = definition.parameters.iter().map(String::as_str).zip(&arguments).collect();
        self.size = self.size.saturating_add(size(&body, &values));
        if self.size > SIZE_LIMIT {
            let (name, span) = (definition.name.clone(), call.span.clone().into());
            return self.refuse(WorksheetMistake::TooLarge { name, span });
        }
        Some(put(&body, &values))
    }
}

/// The expression with values for variables.
fn put(expression: &Expr, values: &BTreeMap<&str, &Expr>) -> Expr {
    if let Some(value) = expression.as_symbol().and_then(|name| values.get(name)) {
        return (*value).clone();
    }
    if let Some(("positive_root", [polynomial, variable])) = expression.as_call()
        && let Some(name) = variable.as_symbol()
    {
        return put_into_root(expression, polynomial, (name, variable), values);
    }
    let Ok(put) = map::<std::convert::Infallible>(expression, &mut |part| Ok(put(part, values)));
    put
}

/// The variable of a root is its own: no value is put for it, and it is renamed if a value contains its name.
fn put_into_root(
    root: &Expr,
    polynomial: &Expr,
    (name, variable): (&str, &Expr),
    values: &BTreeMap<&str, &Expr>,
) -> Expr {
    let mut own = name.to_owned();
    while values.values().any(|value| names(value, &own)) || (own != name && names(polynomial, &own)) {
        own.push('_');
    }
    let renamed = Expr::new(ExprKind::Symbol(own), variable.span.clone());
    let mut inner = values.clone();
    inner.insert(name, &renamed);
    let arguments = vec![put(polynomial, &inner), renamed.clone()];
    match &root.kind {
        ExprKind::Call { function, .. } => {
            Expr::new(ExprKind::Call { function: function.clone(), arguments }, root.span.clone())
        }
        _ => root.clone(),
    }
}

fn names(expression: &Expr, name: &str) -> bool {
    expression.as_symbol() == Some(name) || parts(expression).into_iter().any(|part| names(part, name))
}

/// The number of nodes of the expression with values for variables.
fn size(expression: &Expr, values: &BTreeMap<&str, &Expr>) -> usize {
    let value = expression.as_symbol().and_then(|name| values.get(name));
    let parts = value.map_or_else(|| parts(expression), |value| parts(value));
    let inner = if value.is_some() { &BTreeMap::new() } else { values };
    parts.into_iter().fold(1, |sum, part| sum.saturating_add(size(part, inner)))
}

/// The operands of arithmetic and the arguments of calls; nothing else can stand in a kernel.
fn parts(expression: &Expr) -> Vec<&Expr> {
    match &expression.kind {
        ExprKind::Unary { operand, .. } => vec![operand],
        ExprKind::Binary { left, right, .. } => vec![left, right],
        ExprKind::Call { arguments, .. } => arguments.iter().collect(),
        _ => Vec::new(),
    }
}

/// The expression with its parts replaced.
fn map<'a, E>(expression: &'a Expr, replace: &mut dyn FnMut(&'a Expr) -> Result<Expr, E>) -> Result<Expr, E> {
    let kind = match &expression.kind {
        ExprKind::Unary { operator, operand } => {
            ExprKind::Unary { operator: *operator, operand: Box::new(replace(operand)?) }
        }
        ExprKind::Binary { operator, left, right } => {
            let (left, right) = (Box::new(replace(left)?), Box::new(replace(right)?));
            ExprKind::Binary { operator: *operator, left, right }
        }
        ExprKind::Call { function, arguments } => {
            let arguments = arguments.iter().map(replace).collect::<Result<_, _>>()?;
            ExprKind::Call { function: function.clone(), arguments }
        }
        other => other.clone(),
    };
    Ok(Expr::new(kind, expression.span.clone()))
}
