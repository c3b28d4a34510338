//! Formulas made of what names stand for: their inputs, results and conditions.

use std::collections::BTreeSet;
use std::ops::Range;
use std::rc::Rc;

use closedform_maxima::ast::Branch;
use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator};

use super::evaluate::{Evaluator, PARAMETER, ROOT, is_constant};
use super::state::{Binding, Evaluated, Refusal, State, Stop};
use super::tree::{any, find, list, names, renamed, rows, symbol};
use super::words::COMPUTE;
use super::{statements, words};
use crate::expression::{is_known_constant, remedy_of_constant};

/// A formula of a worksheet, with all that it is made of put in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Formula {
    /// The name that stands for it.
    pub(crate) name: String,
    /// Its inputs: parameters, then free names in the order in which they occur.
    pub(crate) inputs: Vec<String>,
    /// How many of them are parameters.
    pub(crate) parameters: usize,
    /// Its results; a single one has no name.
    pub(crate) results: Vec<(String, Expr)>,
    /// What the worksheet assumes of its inputs.
    pub(crate) assumed: Vec<Expr>,
    /// The conditions under which this is its formula, which must all be kept.
    pub(crate) conditions: Vec<Expr>,
    /// Where it is defined.
    pub(crate) span: Range<usize>,
}

impl Formula {
    /// What its result of this name is called among all results.
    pub(crate) fn worksheet_name(&self, field: &str) -> String {
        match field.strip_prefix(&self.name) {
            _ if field.is_empty() => self.name.clone(),
            Some(_) => field.to_owned(),
            None => format!("{}_{field}", self.name),
        }
    }

    /// The result that is called so among all results.
    pub(crate) fn result(&self, worksheet: &str) -> Option<&Expr> {
        self.results.iter().find(|(field, _)| self.worksheet_name(field) == worksheet).map(|(_, body)| body)
    }

    /// Its inputs in the order of a contract, which is free where they are no parameters.
    pub(crate) fn inputs_as(&self, wanted: &[String]) -> Vec<String> {
        let same = self.inputs.len() == wanted.len() && self.inputs.iter().all(|name| wanted.contains(name));
        let parameters = wanted.starts_with(&self.inputs[..self.parameters]);
        if same && parameters { wanted.to_vec() } else { self.inputs.clone() }
    }
}

/// What a name stands for in the end.
pub(crate) enum Outcome {
    /// A formula.
    Formula(Formula),
    /// A number, or a word such as `false`, that other formulas are made with.
    Constant,
    /// Nothing that a kernel computes.
    Refused(Refusal),
}

/// The formula of a function.
pub(super) fn of_function(name: &str, evaluator: &mut Evaluator) -> Outcome {
    let Some(function) = evaluator.state.functions.get(name).cloned() else { return Outcome::Constant };
    let parameters = match &function.parameters {
        Ok(parameters) => parameters.clone(),
        Err(because) => return Outcome::Refused(because.clone()),
    };
    let arguments = |span: &Range<usize>| parameters.iter().map(|name| marked(name, span)).collect::<Vec<_>>();
    let arguments = arguments(&function.span);
    // what a call changes besides is nobody else's
    let before = evaluator.state.clone();
    let value = evaluator.apply(name, &function, arguments, &function.span);
    evaluator.state = before;
    outcome_with_items(name, parameters, value, &function.span, evaluator)
}

/// The formula of a variable.
pub(super) fn of_variable(name: &str, span: &Range<usize>, evaluator: &mut Evaluator) -> Outcome {
    match evaluator.state.variables.get(name).cloned() {
        None => Outcome::Constant,
        Some(Binding::Unknown(because)) => Outcome::Refused((*because).clone()),
        Some(Binding::Value(value)) => match as_lambda(&value) {
            Some(parameters) => {
                let arguments = parameters.iter().map(|name| marked(name, span)).collect();
                let before = evaluator.state.clone();
                let found = evaluator.call_value(&value, arguments, span);
                evaluator.state = before;
                outcome_with_items(name, parameters, found, span, evaluator)
            }
            None if is_word(&value) => Outcome::Constant,
            None => outcome(name, Vec::new(), Ok((*value).clone()), span, &evaluator.state),
        },
    }
}

fn marked(name: &str, span: &Range<usize>) -> Expr {
    symbol(&format!("{PARAMETER}{name}"), span)
}

/// A value in which parameters are told from other names.
pub(super) fn marked_in(value: &Expr, parameters: &[String]) -> Expr {
    renamed(value, &|name| parameters.iter().any(|parameter| parameter == name).then(|| format!("{PARAMETER}{name}")))
}

fn as_lambda(value: &Rc<Expr>) -> Option<Vec<String>> {
    let ("lambda", [parameters, ..]) = value.as_call()? else { return None };
    list(parameters)?.iter().map(|name| name.as_symbol().map(str::to_owned)).collect()
}

/// Whether a value is no formula but a word, a text or another name.
fn is_word(value: &Expr) -> bool {
    matches!(value.kind, ExprKind::Symbol(_) | ExprKind::String(_))
}

/// What a function comes to that may take lists by their items.
pub(super) fn outcome_with_items(
    name: &str,
    parameters: Vec<String>,
    value: Evaluated,
    span: &Range<usize>,
    evaluator: &Evaluator,
) -> Outcome {
    let parameters = match &value {
        Ok(value) | Err(Stop::Return(value)) => evaluator.with_items(parameters, value),
        Err(Stop::Refused(_)) => Ok(parameters),
    };
    match parameters {
        Ok(parameters) => outcome(name, parameters, value, span, &evaluator.state),
        Err(because) => Outcome::Refused(because),
    }
}

fn outcome(name: &str, parameters: Vec<String>, value: Evaluated, span: &Range<usize>, state: &State) -> Outcome {
    let value = match value {
        Ok(value) | Err(Stop::Return(value)) => value,
        Err(Stop::Refused(because)) => return Outcome::Refused(because),
    };
    if parameters.is_empty() && names(&value).iter().all(|name| !is_input(name)) && !any(&value, &is_call) {
        return Outcome::Constant;
    }
    match formula(name, parameters, &value, span, state) {
        Ok(formula) => Outcome::Formula(formula),
        Err(because) => Outcome::Refused(because),
    }
}

fn is_call(part: &Expr) -> bool {
    part.as_call().is_some_and(|(name, _)| words::computes(name))
}

fn formula(
    name: &str,
    parameters: Vec<String>,
    value: &Expr,
    span: &Range<usize>,
    state: &State,
) -> Result<Formula, Refusal> {
    if let Some(twice) = (1..parameters.len()).find(|&at| parameters[..at].contains(&parameters[at])) {
        let what = format!("`{name}` has the parameter `{}` twice", parameters[twice]);
        return Err(Refusal::new(what, "give each parameter a name of its own", span));
    }
    computing(name, value)?;
    let mut conditions = Vec::new();
    let value = without_condition(value, &mut conditions);
    if is_truth(&value) {
        let what = format!("`{name}` is true or false, and kernels compute numbers");
        return Err(Refusal::new(what, "write the numbers that are meant: if .. then 1 else 0", span));
    }
    let value = own_names(name, &value, &parameters, span)?;
    let conditions: Vec<Expr> =
        conditions.iter().map(|condition| own_names(name, condition, &parameters, span)).collect::<Result<_, _>>()?;
    let mut inputs = parameters.clone();
    let results = results(name, &value)?;
    let bodies = results.iter().map(|(_, body)| body);
    for free in bodies.chain(&conditions).flat_map(names) {
        if is_input(&free) && !inputs.contains(&free) && !is_root_variable(&value, &free) {
            inputs.push(free);
        }
    }
    let about_inputs = |fact: &&Expr| {
        let named = names(fact);
        !named.is_empty() && named.iter().all(|name| inputs.contains(name))
    };
    let assumed = state.facts.iter().filter(about_inputs).cloned().collect();
    Ok(Formula {
        name: name.to_owned(),
        parameters: parameters.len(),
        inputs,
        results,
        assumed,
        conditions,
        span: span.clone(),
    })
}

/// Whether a value, or a side of it, is a condition or one of the words for one. Equations have sides that are numbers.
fn is_truth(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::If { branches, otherwise } => {
            branches.iter().map(|branch| &branch.value).chain(otherwise.as_deref()).any(is_truth)
        }
        ExprKind::Binary { operator: BinaryOperator::Compare(Relation::Equal), .. } => false,
        _ => statements::is_truth(value),
    }
}

/// Whether a name stands for a number that must be given.
fn is_input(name: &str) -> bool {
    !is_known_constant(name) && !is_constant(name) && remedy_of_constant(name).is_none() && !name.starts_with(ROOT)
}

/// What only Maxima can evaluate is said to be so.
fn computing(name: &str, value: &Expr) -> Result<(), Refusal> {
    let mut found = None;
    find(value, &mut |part| {
        if let Some((function, _)) = part.as_call()
            && words::computes(function)
            && found.is_none()
        {
            let what = format!("`{name}` must be computed: it calls `{function}`");
            found = Some(Refusal::new(what, COMPUTE, &part.span));
        }
    });
    found.map_or(Ok(()), Err)
}

/// An `if` without the sides that give no number: the conditions under which none of them is taken are told. What stands in
/// arithmetic or a call is needed for the whole, what stands on a side of another `if` is not.
fn without_condition(value: &Expr, conditions: &mut Vec<Expr>) -> Expr {
    let ExprKind::If { branches, otherwise } = &value.kind else {
        let Ok(inside) =
            super::tree::map::<std::convert::Infallible>(value, &mut |part| Ok(without_condition(part, conditions)));
        return inside;
    };
    let nothing = symbol("false", &value.span);
    let otherwise = otherwise.as_deref().unwrap_or(&nothing);
    let (mut before, mut kept): (Vec<Expr>, Vec<Branch>) = (Vec::new(), Vec::new());
    for Branch { condition, value } in branches {
        let condition = comparable(condition);
        if gives_nothing(value) {
            conditions.push(any_of(&before, negated(&condition)));
        } else {
            kept.push(Branch { condition: condition.clone(), value: value.clone() });
        }
        before.push(condition);
    }
    if gives_nothing(otherwise)
        && let Some(last) = before.pop()
    {
        conditions.push(any_of(&before, last));
    }
    let real = kept.len() + usize::from(!gives_nothing(otherwise));
    let last = if gives_nothing(otherwise) { kept.pop().map(|branch| branch.value) } else { Some(otherwise.clone()) };
    match (real, last) {
        (1, Some(side)) => without_condition(&side, conditions),
        (2.., Some(side)) if real <= branches.len() => {
            Expr::new(ExprKind::If { branches: kept, otherwise: Some(Box::new(side)) }, value.span.clone())
        }
        _ => value.clone(),
    }
}

/// That one of these conditions holds, or the last one.
fn any_of(before: &[Expr], last: Expr) -> Expr {
    let span = last.span.clone();
    let all = before.iter().cloned().chain([last]);
    let joined = all.reduce(|one, other| super::tree::binary(BinaryOperator::Or, one, other, &span));
    joined.unwrap_or_else(|| symbol("true", &span))
}

/// In a condition of an `if`, `=` compares numbers.
fn comparable(condition: &Expr) -> Expr {
    statements::comparison(condition)
}

fn negated(condition: &Expr) -> Expr {
    let operand = Box::new(comparable(condition));
    Expr::new(ExprKind::Unary { operator: UnaryOperator::Not, operand }, condition.span.clone())
}

/// Whether a side of an `if` says that there is no number.
fn gives_nothing(side: &Expr) -> bool {
    match &side.kind {
        ExprKind::String(_) => true,
        ExprKind::Symbol(name) => ["false", "und", "ind", "done", "undefined", "%nan"].contains(&name.as_str()),
        ExprKind::Call { .. } => side.as_call().is_some_and(|(name, _)| ["error", "print", "throw"].contains(&name)),
        _ => false,
    }
}

/// Parameters under their own names, and the variables of roots under names of their own.
fn own_names(of: &str, value: &Expr, parameters: &[String], span: &Range<usize>) -> Result<Expr, Refusal> {
    let all = names(value);
    if let Some(name) = parameters.iter().find(|name| all.contains(name)) {
        let what = format!(
            "`{of}` takes `{name}`, but `{name}` of another value that it uses is not this parameter in Maxima"
        );
        let remedy = format!(
            "write define({of}({}), ..), which takes the values as they are, or rename one of the two",
            parameters.join(",")
        );
        return Err(Refusal::new(what, remedy, span));
    }
    let mut roots: Vec<(String, String)> = Vec::new();
    for root in all.iter().filter(|name| name.starts_with(ROOT)) {
        let mut own = root.rsplit(ROOT).next().unwrap_or_default().to_owned();
        while all.iter().any(|name| *name == own || name.strip_prefix(PARAMETER) == Some(&own))
            || roots.iter().any(|(_, name)| *name == own)
        {
            own.push('_');
        }
        roots.push((root.clone(), own));
    }
    Ok(renamed(value, &|name| match name.strip_prefix(PARAMETER) {
        Some(parameter) => Some(parameter.to_owned()),
        None => roots.iter().find(|(root, _)| root == name).map(|(_, own)| own.clone()),
    }))
}

fn is_root_variable(value: &Expr, name: &str) -> bool {
    any(
        value,
        &|part| matches!(part.as_call(), Some(("positive_root", [_, unknown])) if unknown.as_symbol() == Some(name)),
    )
}

/// The results: one, or one for each item of a list or matrix.
fn results(name: &str, value: &Expr) -> Result<Vec<(String, Expr)>, Refusal> {
    let nested = |part: &Expr| list(part).is_some() || rows(part).is_some();
    let mut found = Vec::new();
    if let Some(items) = list(value) {
        for (at, item) in items.iter().enumerate() {
            match list(item) {
                Some(inner) => {
                    let inner = inner.iter().enumerate();
                    found.extend(inner.map(|(column, item)| result(format!("{name}_{}_{}", at + 1, column + 1), item)));
                }
                None => found.push(result(format!("{name}_{}", at + 1), item)),
            }
        }
    } else if let Some(rows) = rows(value) {
        for (row, items) in rows.iter().enumerate() {
            let items = items.iter().enumerate();
            found.extend(items.map(|(column, item)| result(format!("{name}_{}_{}", row + 1, column + 1), item)));
        }
    } else {
        return Ok(vec![(String::new(), result(String::new(), value).2)]);
    }
    if found.is_empty() || found.iter().any(|(.., item)| nested(item)) {
        let what = format!("`{name}` is no number, and no list or matrix of numbers");
        return Err(Refusal::new(what, "give its items names of their own", &value.span));
    }
    // solutions of one unknown are told apart by their places
    let mut seen = BTreeSet::new();
    let by_left = found.iter().all(|(_, left, _)| seen.insert(left.clone()));
    Ok(found.into_iter().map(|(place, left, item)| (if by_left { left } else { place }, item)).collect())
}

/// An equation whose left side is a name gives its right side, under that name: the name by place, the other one, the value.
fn result(name: String, item: &Expr) -> (String, String, Expr) {
    match &item.kind {
        ExprKind::Binary { operator: BinaryOperator::Compare(Relation::Equal), left, right }
            if left.as_symbol().is_some_and(|left| !names(right).iter().any(|name| name == left)) =>
        {
            let left = left.as_symbol().unwrap_or_default().to_owned();
            (name.clone(), if name.is_empty() { name } else { left }, (**right).clone())
        }
        _ => (name.clone(), name, item.clone()),
    }
}
