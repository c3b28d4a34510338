//! Expressions evaluated as Maxima evaluates them, so far as names, functions, lists and conditions go; arithmetic stays.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::rc::Rc;

use closedform_maxima::ast::Quoting;
use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator, print};

use super::effects::Effects;
use super::numbers;
use super::state::{Binding, Evaluated, Function, Refusal, Saved, State, Stop};
use super::tree::{self, any, binary, measure, symbol};
use super::{arrays, words};
use crate::construct::SIZE_LIMIT;

/// How deep expressions and calls may stand inside each other.
const DEPTH_LIMIT: usize = 3000;

/// The evaluator.
pub(super) struct Evaluator {
    pub(super) state: State,
    /// Texts of other files by the names that `load` is given.
    pub(super) files: BTreeMap<String, String>,
    /// What a name with a subscript is called, if it is an input.
    pub(super) subscripts: arrays::Names,
    /// Names whose values were put into something.
    pub(super) used: BTreeSet<String>,
    /// Files that are loaded and not at hand, in words.
    pub(super) absent: Vec<(String, Range<usize>)>,
    /// Names for the items of parameters that are lists: the parameter, and which item.
    pub(super) items: BTreeMap<String, (String, Vec<i64>)>,
    /// How many loops were not run through.
    pub(super) left: usize,
    /// The functions being called, outermost first, each with the number of undecided conditions around it.
    open: Vec<(String, usize)>,
    /// How many conditions around the current place are not decided.
    pub(super) undecided: usize,
    depth: usize,
    size: usize,
    roots: usize,
}

impl Evaluator {
    pub(super) fn new(state: State, files: BTreeMap<String, String>, subscripts: arrays::Names) -> Self {
        Self {
            state,
            files,
            subscripts,
            used: BTreeSet::new(),
            absent: Vec::new(),
            items: BTreeMap::new(),
            left: 0,
            open: Vec::new(),
            undecided: 0,
            depth: 0,
            size: 0,
            roots: 0,
        }
    }

    /// Begins another formula.
    pub(super) fn rest(&mut self) {
        self.size = 0;
    }

    /// The value of an expression.
    pub(super) fn value(&mut self, expression: &Expr) -> Evaluated {
        self.depth += 1;
        self.size += 1;
        let value = match self.depth > DEPTH_LIMIT || self.size > SIZE_LIMIT {
            true => Err(too_large(&expression.span).into()),
            false => self.of_kind(expression),
        };
        self.depth -= 1;
        value
    }

    fn of_kind(&mut self, expression: &Expr) -> Evaluated {
        let span = &expression.span;
        match &expression.kind {
            ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) | ExprKind::String(_) => {
                Ok(expression.clone())
            }
            ExprKind::Symbol(name) => self.name(name, span),
            ExprKind::Quote { quoting, expression: quoted } => self.quoted(*quoting, quoted, span),
            ExprKind::Call { function, arguments } => self.call(expression, function, arguments),
            ExprKind::Subscript { array, indices } => self.subscript(expression, array, indices),
            ExprKind::Sequence(items) => self.in_turn(items, span),
            ExprKind::Unary { operator, operand } => self.unary(*operator, operand, span),
            ExprKind::Binary { operator, left, right } => self.binary(*operator, left, right, expression),
            ExprKind::If { branches, otherwise } => self.condition(branches, otherwise.as_deref(), span),
            ExprKind::Loop { clauses, body } => Ok(self.repeated(expression, clauses, body)),
            ExprKind::Ev { expression: inner, options } => self.ev_or_doubt(inner, options),
            ExprKind::List(_) | ExprKind::Set(_) => tree::map(expression, &mut |part| self.value(part)),
        }
    }

    /// What a name stands for.
    fn name(&mut self, name: &str, span: &Range<usize>) -> Evaluated {
        if name == "%" {
            return match self.state.last.clone() {
                Some(Binding::Value(value)) => self.known(&value, span),
                Some(Binding::Unknown(because)) => Err(elsewhere(&because, span).into()),
                None => Err(Refusal::new("`%` stands for nothing here", "name what is meant", span).into()),
            };
        }
        if name.starts_with("%i") || name.starts_with("%o") || name.starts_with("%th") {
            let numbered = name.len() > 2 && name[2..].bytes().all(|byte| byte.is_ascii_digit());
            if numbered || name == "%th" {
                let what = format!("`{name}` is the label of an input or output, which a file does not have");
                return Err(Refusal::new(what, "give the result a name: `name: ..$`", span).into());
            }
        }
        if name == "%phi" {
            return Ok(tree::golden_ratio(span));
        }
        match self.state.variables.get(name).cloned() {
            Some(Binding::Value(value)) => {
                self.used.insert(name.to_owned());
                self.known(&value, span)
            }
            Some(Binding::Unknown(because)) => Err(elsewhere(&because, span).into()),
            None => match &self.state.fog {
                Some(because) if !name.starts_with('%') && !is_constant(name) => Err(elsewhere(because, span).into()),
                _ => Ok(symbol(name, span)),
            },
        }
    }

    /// A value, if there is room for it.
    fn known(&mut self, value: &Expr, span: &Range<usize>) -> Evaluated {
        let (size, height) = measure(value);
        self.size = self.size.saturating_add(size);
        if self.size > SIZE_LIMIT || height > closedform_maxima::HEIGHT_LIMIT {
            return Err(too_large(span).into());
        }
        Ok(value.clone())
    }

    fn quoted(&mut self, quoting: Quoting, quoted: &Expr, span: &Range<usize>) -> Evaluated {
        match (quoting, &quoted.kind) {
            (_, ExprKind::Symbol(name)) => Ok(symbol(name, span)),
            (Quoting::Expression, _) => Ok(quoted.clone()),
            (Quoting::Noun, _) => {
                let what = "it must be computed: a noun form stands for no number until Maxima evaluates it";
                Err(Refusal::new(what, words::COMPUTE, span).into())
            }
            // what is left of them was spliced in when the statement was read
            (Quoting::Verb | Quoting::Value, _) => self.value(quoted),
        }
    }

    /// Replaces what two quotes mark by its value, as Maxima does when it reads a statement.
    pub(super) fn spliced(&mut self, expression: &Expr) -> Evaluated {
        match &expression.kind {
            ExprKind::Quote { quoting: Quoting::Value | Quoting::Verb, expression: inner } => {
                let inner = self.spliced(inner)?;
                self.value(&inner)
            }
            _ => tree::map(expression, &mut |part| self.spliced(part)),
        }
    }

    /// All items in turn; the value of the last one. What cannot be known of one of them does not end a statement: Maxima
    /// goes on, and so do the items after it, unless it might have returned. In a function it ends the call.
    pub(super) fn in_turn(&mut self, items: &[Expr], span: &Range<usize>) -> Evaluated {
        let mut last = symbol("done", span);
        for (at, item) in items.iter().enumerate() {
            match self.value(item) {
                Ok(value) => last = value,
                Err(Stop::Refused(because)) if at + 1 < items.len() => {
                    let ends =
                        !self.open.is_empty() || any(item, &|part| matches!(part.as_call(), Some(("return", _))));
                    let unknown = if ends { &items[at..] } else { &items[at..=at] };
                    unknown.iter().for_each(|item| self.doubt(item, &because));
                    if ends {
                        return Err(because.into());
                    }
                }
                stop => return stop,
            }
        }
        Ok(last)
    }

    /// What an expression that was not evaluated to its end may change is not known any more.
    pub(super) fn doubt(&mut self, expression: &Expr, because: &Refusal) {
        Effects::of(expression, &self.state).apply(&mut self.state, because);
    }

    fn unary(&mut self, operator: UnaryOperator, operand: &Expr, span: &Range<usize>) -> Evaluated {
        let operand = self.value(operand)?;
        // of a comparison `not` takes the whole, not its sides
        if operator == UnaryOperator::Not {
            return Ok(Expr::new(ExprKind::Unary { operator, operand: Box::new(operand) }, span.clone()));
        }
        Ok(arrays::each(&operand, &mut |item| {
            Expr::new(ExprKind::Unary { operator, operand: Box::new(item.clone()) }, span.clone())
        }))
    }

    fn binary(&mut self, operator: BinaryOperator, left: &Expr, right: &Expr, whole: &Expr) -> Evaluated {
        let span = &whole.span;
        match operator {
            BinaryOperator::Assign => {
                let value = self.value(right);
                self.assign(left, value, span)
            }
            BinaryOperator::AssignValue => match self.value(left)? {
                name if name.as_symbol().is_some() => {
                    let value = self.value(right);
                    self.assign(&name, value, span)
                }
                _ => Err(self.sweep("assigns to what cannot be known", span)),
            },
            BinaryOperator::Define | BinaryOperator::DefineMacro => {
                self.define(left, right.clone(), operator == BinaryOperator::DefineMacro, span);
                Ok(whole.clone())
            }
            _ => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                arrays::joined(operator, left, right, span).map_err(Stop::from)
            }
        }
    }

    /// `name: value`, and what else may stand before the colon; what has no value is unknown from here on.
    pub(super) fn assign(&mut self, target: &Expr, value: Evaluated, span: &Range<usize>) -> Evaluated {
        let value = match value {
            Err(Stop::Refused(because)) => {
                let effects =
                    Effects::of(&binary(BinaryOperator::Assign, target.clone(), target.clone(), span), &self.state);
                effects.apply(&mut self.state, &because);
                return Err(because.into());
            }
            other => other?,
        };
        match (&target.kind, &value.kind) {
            (ExprKind::Symbol(name), _) => {
                if value.as_symbol().is_some_and(|value| words::changes_arithmetic(name, value)) {
                    return Err(self.sweep("changes what arithmetic means", span));
                }
                self.state.variables.insert(name.clone(), Binding::Value(Rc::new(value.clone())));
            }
            (ExprKind::List(targets), ExprKind::List(values)) if targets.len() == values.len() => {
                for (target, value) in targets.iter().zip(values) {
                    self.assign(target, Ok(value.clone()), span)?;
                }
            }
            (ExprKind::Subscript { array, indices }, _) => self.assign_element(array, indices, &value, span)?,
            (ExprKind::List(_), _) => {
                let what = "the parts of what only Maxima can compute";
                let because = Refusal::new(what, words::COMPUTE, span);
                let whole = binary(BinaryOperator::Assign, target.clone(), target.clone(), span);
                Effects::of(&whole, &self.state).apply(&mut self.state, &because);
                return Err(because.into());
            }
            _ => return Err(self.sweep("assigns to what cannot be known", span)),
        }
        Ok(value)
    }

    /// `f(x):=body`
    pub(super) fn define(&mut self, head: &Expr, body: Expr, is_macro: bool, span: &Range<usize>) {
        let Some((name, parameters)) = head.as_call() else {
            let name = match &head.kind {
                ExprKind::Subscript { array, .. } => array.as_symbol(),
                ExprKind::Call { function, .. } => match &function.kind {
                    ExprKind::Subscript { array, .. } => array.as_symbol(),
                    _ => None,
                },
                _ => None,
            };
            let what = "a function of subscripts, whose values depend on what was computed before";
            let because = Refusal::new(what, "define a function of arguments instead: `f(i,x):=..`", span);
            if let ExprKind::Subscript { array, indices } = &head.kind
                && let Some(name) = array.as_symbol()
                && let Some(parameters) = indices.iter().map(|index| index.as_symbol().map(str::to_owned)).collect()
            {
                let function =
                    Function { parameters: Ok(parameters), body: Rc::new(body), is_macro, span: span.clone() };
                self.state.arrays.insert(name.to_owned(), Rc::new(function));
            } else if let Some(name) = name {
                self.state.forget_value(name, &because);
                self.state.forget_function(name, &because);
            }
            return;
        };
        let names = parameters.iter().map(|parameter| parameter.as_symbol().map(str::to_owned));
        let parameters = names.collect::<Option<Vec<String>>>().ok_or_else(|| {
            let what = "its parameters are not names: it takes lists or unevaluated arguments";
            Refusal::new(what, "write f(x,y):=.. with names", &head.span)
        });
        let function = Function { parameters, body: Rc::new(body), is_macro, span: span.clone() };
        self.state.functions.insert(name.to_owned(), Rc::new(function));
    }

    /// Calls a function of the worksheet.
    pub(super) fn apply(
        &mut self,
        name: &str,
        function: &Function,
        arguments: Vec<Expr>,
        span: &Range<usize>,
    ) -> Evaluated {
        let parameters = match &function.parameters {
            Ok(parameters) => parameters,
            Err(because) => return Err(elsewhere(because, span).into()),
        };
        if parameters.len() != arguments.len() {
            let what = format!("`{name}` takes {} arguments, but is called with {}", parameters.len(), arguments.len());
            return Err(Refusal::new(what, "correct the call or the definition", span).into());
        }
        self.no_cycle(name, &function.span)?;
        self.open.push((name.to_owned(), self.undecided));
        self.used.insert(name.to_owned());
        let value = self.bound(parameters, arguments, &function.body);
        self.open.pop();
        let value = value.and_then(|value| self.known(&value, span))?;
        if function.is_macro { self.value(&value) } else { Ok(value) }
    }

    /// A body with values for its parameters, which everything that it calls sees too.
    pub(super) fn bound(&mut self, parameters: &[String], arguments: Vec<Expr>, body: &Expr) -> Evaluated {
        let bind = |(name, value): (&String, Expr)| self.state.bind(name, Some(Binding::Value(Rc::new(value))));
        let saved: Saved = parameters.iter().zip(arguments).map(bind).collect();
        let value = self.value(body);
        self.state.restore(saved);
        value
    }

    /// A function that calls itself must not do so under a condition that is not decided, or without end.
    fn no_cycle(&self, name: &str, span: &Range<usize>) -> Result<(), Refusal> {
        let Some(start) = self.open.iter().position(|(open, _)| open == name) else { return Ok(()) };
        let depth = self.open.iter().filter(|(open, _)| open == name).count();
        if self.open[start].1 == self.undecided && depth < 100 && self.decides(start) {
            return Ok(());
        }
        let cycle: Vec<&str> = self.open[start..].iter().map(|(name, _)| &**name).chain([name]).collect();
        let what = format!("these definitions call each other without end: {}", cycle.join(" -> "));
        Err(Refusal::new(what, "kernels are closed forms; write the function without recursion", span))
    }

    /// Whether one of the functions being called, from this one on, has an `if` that could end it.
    fn decides(&self, start: usize) -> bool {
        self.open[start..].iter().any(|(name, _)| {
            if self.state.arrays.contains_key(name) {
                return true; // an element with a value ends it
            }
            let body = self.state.functions.get(name).map(|function| &function.body);
            body.is_some_and(|body| any(body, &|part| matches!(part.kind, ExprKind::If { .. })))
        })
    }

    /// Whether what is done here is done whatever the inputs are.
    pub(super) fn is_decided(&self) -> bool {
        self.undecided == 0
    }

    /// A place that is not evaluated: what it may change is unknown from here on.
    pub(super) fn leave(&mut self, expression: &Expr, what: &str) {
        let remedy = "write it as a formula: kernels are straight lines";
        let because = Refusal::new(format!("it is changed in {what}"), remedy, &expression.span);
        self.doubt(expression, &because);
    }

    /// What changes everything, so that nothing before it is known any more.
    pub(super) fn sweep(&mut self, what: &str, span: &Range<usize>) -> Stop {
        let because =
            Refusal::new(format!("a statement {what}"), "leave that statement out, or put it elsewhere", span);
        self.state.forget_all(&because);
        because.into()
    }

    /// A name of its own for the variable of a root.
    pub(super) fn root_variable(&mut self, name: &str) -> String {
        self.roots += 1;
        format!("{ROOT}{}{ROOT}{name}", self.roots)
    }
}

/// Marks the parameters of the function whose formula is made, and the variables of roots, which are no free names.
pub(super) const PARAMETER: char = '\u{1}';
pub(super) const ROOT: char = '\u{2}';

fn too_large(span: &Range<usize>) -> Refusal {
    let what = format!("the formulas grow to more than {SIZE_LIMIT} terms when all definitions are put in");
    Refusal::new(what, "make the functions that it calls smaller", span)
}

/// The same refusal, met at another place.
pub(super) fn elsewhere(because: &Refusal, span: &Range<usize>) -> Refusal {
    let cause = because.cause.clone().or_else(|| Some(because.span.clone()));
    Refusal { span: span.clone(), cause, ..because.clone() }
}

/// A refusal of values: where one of them is what only Maxima computes, that is why.
pub(super) fn because_of(values: &[&Expr], otherwise: Refusal) -> Refusal {
    let mut computing = None;
    for value in values {
        tree::find(value, &mut |part| {
            let name = part.as_call().map(|(name, _)| name).filter(|name| words::computes(name));
            computing = computing.take().or_else(|| name.map(str::to_owned));
        });
    }
    match computing {
        Some(name) => {
            let what = format!("it must be computed: it needs what `{name}` gives");
            Refusal::new(what, words::COMPUTE, &otherwise.span)
        }
        None => otherwise,
    }
}

/// Whether a word has a meaning of its own that no statement gives it.
pub(super) fn is_constant(name: &str) -> bool {
    ["true", "false", "inf", "minf", "infinity", "und", "ind", "zeroa", "zerob", "done"].contains(&name)
}

/// A value as the key of an element.
pub(super) fn key(array: &str, indices: &[Expr]) -> String {
    let indices: Vec<String> = indices
        .iter()
        .map(|index| match numbers::exact(index) {
            Some(value) => value.to_string(),
            None => print(index),
        })
        .collect();
    format!("{array}[{}]", indices.join(","))
}
