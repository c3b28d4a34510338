//! Calls: functions of the worksheet, and those of Maxima that a formula may be made with.

use std::ops::Range;
use std::rc::Rc;

use closedform_maxima::ast::Branch;
use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation};

use super::arrays;
use super::differentiate::differentiated;
use super::evaluate::{Evaluator, because_of};
use super::lists::of_lists;
use super::numbers;
use super::state::{Binding, Evaluated, Refusal, Saved, Stop};
use super::tree::{self, any, call, list, put, small, symbol};
use super::words::{self, COMPUTE};
use crate::expression::is_known_function;

/// The most items that a sum, product or list is written out with.
pub(super) const ITEMS: i64 = 1000;

impl Evaluator {
    pub(super) fn call(&mut self, whole: &Expr, function: &Expr, arguments: &[Expr]) -> Evaluated {
        let Some(name) = function.as_symbol() else {
            let function = self.value(function)?;
            let arguments = self.values(arguments)?;
            return self.call_value(&function, arguments, &whole.span);
        };
        if let Some(function) = self.state.functions.get(name).cloned() {
            let arguments = if function.is_macro { arguments.to_vec() } else { self.values(arguments)? };
            return self.apply(name, &function, arguments, &whole.span);
        }
        if let Some(Binding::Value(value)) = self.state.variables.get(name).cloned()
            && matches!(value.as_call(), Some(("lambda", _)))
        {
            let arguments = self.values(arguments)?;
            return self.call_value(&value, arguments, &whole.span);
        }
        self.of_maxima(whole, name, arguments)
    }

    fn values(&mut self, arguments: &[Expr]) -> Evaluated<Vec<Expr>> {
        arguments.iter().map(|argument| self.value(argument)).collect()
    }

    /// A function that is a value: a name, or `lambda([x],..)`.
    pub(super) fn call_value(&mut self, function: &Expr, arguments: Vec<Expr>, span: &Range<usize>) -> Evaluated {
        if let Some(name) = function.as_symbol() {
            return match self.state.functions.get(name).cloned() {
                Some(function) if !function.is_macro => self.apply(name, &function, arguments, span),
                _ => {
                    let quoted = |value: Expr| {
                        let span = value.span.clone();
                        let quoting = closedform_maxima::ast::Quoting::Expression;
                        Expr::new(ExprKind::Quote { quoting, expression: Box::new(value) }, span)
                    };
                    let arguments: Vec<Expr> = arguments.into_iter().map(quoted).collect();
                    self.of_maxima(&call(name, arguments.clone(), span), name, &arguments)
                }
            };
        }
        if let Some(("lambda", [parameters, body @ ..])) = function.as_call()
            && let Some(names) =
                list(parameters).and_then(|items| items.iter().map(Expr::as_symbol).collect::<Option<Vec<_>>>())
            && names.len() == arguments.len()
        {
            let names: Vec<String> = names.into_iter().map(str::to_owned).collect();
            let body = Expr::new(ExprKind::Sequence(body.to_vec()), function.span.clone());
            return self.bound(&names, arguments, &body);
        }
        let what = "what is called here is no function that is known";
        Err(Refusal::new(what, "call a function by its name", span).into())
    }

    /// A function of Maxima. What is none of formulas stays as it is, and is refused where a formula contains it.
    fn of_maxima(&mut self, whole: &Expr, name: &str, arguments: &[Expr]) -> Evaluated {
        let span = &whole.span;
        match (name, arguments) {
            ("block", _) => self.block(arguments, span),
            ("return", [value]) => Err(Stop::Return(self.value(value)?)),
            ("lambda" | "buildq", _) => Ok(whole.clone()),
            ("ev", [inner, options @ ..]) => self.ev_or_doubt(inner, options),
            ("define", [head, body]) => {
                let body = self.value(body)?;
                self.define(head, body, false, span);
                Ok(symbol("done", span))
            }
            ("positive_root", [polynomial, unknown]) if unknown.as_symbol().is_some() => {
                let name = unknown.as_symbol().unwrap_or_default();
                let own = symbol(&self.root_variable(name), &unknown.span);
                let polynomial = self.bound(&[name.to_owned()], vec![own.clone()], polynomial)?;
                Ok(call("positive_root", vec![polynomial, own], span))
            }
            ("makelist" | "sum" | "product", [item, variable, from, to]) => match variable.as_symbol() {
                Some(variable) => self.series(name, item, variable, (from, to), span),
                None => Ok(whole.clone()),
            },
            ("makelist", [item, variable, items]) if variable.as_symbol().is_some() => {
                let items = self.value(items)?;
                let Some(items) = list(&items) else { return Ok(whole.clone()) };
                let names = [variable.as_symbol().unwrap_or_default().to_owned()];
                let made = items.iter().map(|value| self.bound(&names, vec![value.clone()], item));
                Ok(Expr::new(ExprKind::List(made.collect::<Evaluated<_>>()?), span.clone()))
            }
            _ if self.is_statement(name) => self.statement(whole, name, arguments),
            // what is said to be a formula evaluates what it is given once, as Maxima does
            _ if arguments.iter().any(changes) && !words::is_form(name) && !is_known_function(name) => {
                self.leave(whole, &format!("a call of `{name}`"));
                let because = Refusal::new(format!("`{name}` is not known"), "write it as a formula", span);
                Err(because.into())
            }
            _ => {
                let arguments = self.values(arguments)?;
                self.of_values(name, arguments, span)
            }
        }
    }

    /// Functions of values.
    fn of_values(&mut self, name: &str, arguments: Vec<Expr>, span: &Range<usize>) -> Evaluated {
        let made = match (name, arguments.as_slice()) {
            ("subst", [equations, value]) | ("at", [value, equations]) => {
                let in_turn = name == "subst";
                Some(substituted(equations, value, in_turn, span)?)
            }
            ("sublis" | "psubst", [equations, value]) => Some(substituted(equations, value, false, span)?),
            ("subst" | "psubst", [new, old, value]) => {
                let equation = tree::binary(BinaryOperator::Compare(Relation::Equal), old.clone(), new.clone(), span);
                Some(substituted(&equation, value, true, span)?)
            }
            ("diff", [value, by]) if is_name(by) => {
                let (by, once) = (by.as_symbol().unwrap_or_default(), tree::number(1, span));
                Some(differentiated(value, by, &once, &self.state.dependent, span)?)
            }
            ("diff", [value, pairs @ ..]) if !pairs.is_empty() && pairs.iter().step_by(2).all(is_name) => {
                let mut value = value.clone();
                for pair in pairs.chunks(2) {
                    let (by, times) = (pair[0].as_symbol().unwrap_or_default(), pair.get(1));
                    let once = tree::number(1, span);
                    value = differentiated(&value, by, times.unwrap_or(&once), &self.state.dependent, span)?;
                }
                Some(value)
            }
            ("rhs", [equation]) => side(equation, false),
            ("lhs", [equation]) => side(equation, true),
            ("map" | "maplist", [function, items]) => match list(items).map(<[Expr]>::to_vec) {
                Some(items) => {
                    let made = items.into_iter().map(|item| self.call_value(function, vec![item], span));
                    Some(Expr::new(ExprKind::List(made.collect::<Evaluated<_>>()?), span.clone()))
                }
                None => None,
            },
            ("apply", [function, items]) => match list(items).map(<[Expr]>::to_vec) {
                Some(items) => return self.call_value(function, items, span),
                None => None,
            },
            ("is" | "maybe", [condition]) => Some(match numbers::decided(condition) {
                Some(holds) => symbol(if holds { "true" } else { "false" }, span),
                None => condition.clone(),
            }),
            ("factorial", [number]) => Some(factorial(number, span)),
            ("fix", [number]) => Some(call("floor", vec![number.clone()], span)),
            ("unit_step", [number]) => Some(unit_step(number, span)),
            (_, [value, ..]) if words::is_form(name) => Some(form(name, value, span)?),
            _ => of_lists(name, &arguments, span)?,
        };
        Ok(made.unwrap_or_else(|| call(name, arguments, span)))
    }

    /// `block([a, b: 1], ..)`
    fn block(&mut self, arguments: &[Expr], span: &Range<usize>) -> Evaluated {
        let (locals, body) = match arguments.split_first() {
            Some((first, rest)) if list(first).is_some() => (list(first).unwrap_or_default(), rest),
            _ => (&[][..], arguments),
        };
        let mut bound = Vec::new();
        for local in locals {
            bound.push(match &local.kind {
                ExprKind::Symbol(name) => (name.clone(), None),
                ExprKind::Binary { operator: BinaryOperator::Assign, left, right } if left.as_symbol().is_some() => {
                    let value = self.value(right)?;
                    (left.as_symbol().unwrap_or_default().to_owned(), Some(Binding::Value(Rc::new(value))))
                }
                _ => {
                    return Err(
                        Refusal::new("a local name is no name", "write block([a, b: 1], ..)", &local.span).into()
                    );
                }
            });
        }
        let functions = local_functions(body);
        let before: Vec<_> =
            functions.iter().map(|name| ((*name).to_owned(), self.state.functions.remove(*name))).collect();
        let saved: Saved = bound.into_iter().map(|(name, value)| self.state.bind(&name, value)).collect();
        let value = self.in_turn(body, span);
        self.state.restore(saved);
        for (name, function) in before {
            self.state.functions.remove(&name);
            self.state.functions.extend(function.map(|function| (name, function)));
        }
        match value {
            Err(Stop::Return(value)) => Ok(value),
            other => other,
        }
    }

    /// `ev(e, x=1, ..)`; what an option that cannot be obeyed leaves undone is not known.
    pub(super) fn ev_or_doubt(&mut self, inner: &Expr, options: &[Expr]) -> Evaluated {
        let value = self.ev(inner, options);
        if let Err(Stop::Refused(because)) = &value {
            self.doubt(inner, because);
        }
        value
    }

    /// `ev(e, x=1, ..)`: what is evaluated sees the equations, and its value is evaluated once more.
    fn ev(&mut self, inner: &Expr, options: &[Expr]) -> Evaluated {
        let mut equations = Vec::new();
        for option in options {
            let option = match &option.kind {
                ExprKind::List(items) => items.clone(),
                _ => vec![option.clone()],
            };
            for option in option {
                self.option(&option, &mut equations)?;
            }
        }
        let (names, values): (Vec<String>, Vec<Expr>) = equations.into_iter().unzip();
        if let ExprKind::Binary { operator: BinaryOperator::Assign, left, right } = &inner.kind {
            let value = self.twice(&names, &values, right);
            return self.assign(left, value, &inner.span);
        }
        self.twice(&names, &values, inner)
    }

    /// The value of the value of an expression, with values for some names.
    fn twice(&mut self, names: &[String], values: &[Expr], inner: &Expr) -> Evaluated {
        let once = self.bound(names, values.to_vec(), inner)?;
        self.bound(names, values.to_vec(), &once)
    }

    fn option(&mut self, option: &Expr, equations: &mut Vec<(String, Expr)>) -> Evaluated<()> {
        let unknown = || {
            Refusal::new("an option of `ev` that only Maxima obeys", "write the values as equations: x=1", &option.span)
        };
        match &option.kind {
            ExprKind::Symbol(name) if words::is_flag(name) => Ok(()),
            ExprKind::Symbol(name) if words::computes(name) || words::is_evaluation(name) => {
                let what = format!("it must be computed: `{name}` of `ev` tells Maxima to");
                Err(Refusal::new(what, COMPUTE, &option.span).into())
            }
            ExprKind::Binary {
                operator: BinaryOperator::Compare(Relation::Equal) | BinaryOperator::Assign,
                left,
                right,
            } => {
                let Some(name) = left.as_symbol() else { return Err(unknown().into()) };
                let value = self.value(right)?;
                if value.as_symbol().is_some_and(|value| words::changes_arithmetic(name, value)) {
                    return Err(unknown().into());
                }
                if !words::is_flag(name) {
                    equations.push((name.to_owned(), value));
                }
                Ok(())
            }
            _ => match self.value(option)? {
                // a name without a value says nothing to Maxima
                value if value == *option && self.says_nothing(option) => Ok(()),
                value if list(&value).is_some() || side(&value, true).is_some() => {
                    let items = list(&value).map_or_else(|| vec![value.clone()], <[Expr]>::to_vec);
                    for equation in items {
                        let (Some(left), Some(right)) = (side(&equation, true), side(&equation, false)) else {
                            return Err(unknown().into());
                        };
                        equations.push((left.as_symbol().ok_or_else(unknown)?.to_owned(), right));
                    }
                    Ok(())
                }
                value => Err(because_of(&[&value], unknown()).into()),
            },
        }
    }

    /// Whether an option of `ev` is a name that means nothing.
    fn says_nothing(&self, option: &Expr) -> bool {
        option.as_symbol().is_some_and(|name| !self.state.functions.contains_key(name))
    }

    /// `sum`, `product` and `makelist` between numbers, written out.
    fn series(
        &mut self,
        name: &str,
        item: &Expr,
        variable: &str,
        (from, to): (&Expr, &Expr),
        span: &Range<usize>,
    ) -> Evaluated {
        let (from, to) = (self.value(from)?, self.value(to)?);
        let (Some(first), Some(last)) = (small(&from), small(&to)) else {
            let what = format!("a {name} whose number of terms is not known");
            let because = Refusal::new(what, "write it with numbers as its ends", span);
            return Err(because_of(&[&from, &to], because).into());
        };
        if last.saturating_sub(first) >= ITEMS {
            let what = format!("a {name} of more than {ITEMS} terms");
            return Err(Refusal::new(what, "write a closed form of it", span).into());
        }
        let names = [variable.to_owned()];
        let mut items = Vec::new();
        for at in first..=last {
            items.push(self.bound(&names, vec![tree::number(at, span)], item)?);
        }
        if name == "makelist" {
            return Ok(Expr::new(ExprKind::List(items), span.clone()));
        }
        let (operator, empty) = if name == "sum" { (BinaryOperator::Add, 0) } else { (BinaryOperator::Multiply, 1) };
        let mut all = items.into_iter();
        let first = all.next().unwrap_or_else(|| tree::number(empty, span));
        all.try_fold(first, |sum, item| arrays::joined(operator, sum, item, span)).map_err(Stop::from)
    }
}

/// Whether something is assigned or defined in an expression.
pub(super) fn changes(expression: &Expr) -> bool {
    any(expression, &|part| match &part.kind {
        ExprKind::Binary { operator, .. } => matches!(
            operator,
            BinaryOperator::Assign | BinaryOperator::AssignValue | BinaryOperator::Define | BinaryOperator::DefineMacro
        ),
        _ => false,
    })
}

/// Whether something is a name that has no value.
fn is_name(value: &Expr) -> bool {
    value.as_symbol().is_some_and(|name| !name.starts_with(['%', super::evaluate::ROOT]))
}

/// The functions that `local` makes local to a block.
fn local_functions(body: &[Expr]) -> Vec<&str> {
    let locals = body.iter().filter_map(|statement| statement.as_call().filter(|(name, _)| *name == "local"));
    locals.flat_map(|(_, names)| names.iter().filter_map(Expr::as_symbol)).collect()
}

fn side(equation: &Expr, left_side: bool) -> Option<Expr> {
    match &equation.kind {
        ExprKind::Binary { operator: BinaryOperator::Compare(_), left, right } => {
            Some(if left_side { (**left).clone() } else { (**right).clone() })
        }
        _ => None,
    }
}

/// A value with others for names in it, as `subst` does it: in turn or all at once.
fn substituted(equations: &Expr, value: &Expr, in_turn: bool, span: &Range<usize>) -> Result<Expr, Refusal> {
    let equations = list(equations).map_or_else(|| vec![equations.clone()], <[Expr]>::to_vec);
    let mut pairs = Vec::new();
    for equation in &equations {
        let pair = side(equation, true).zip(side(equation, false));
        let pair = pair.and_then(|(old, new)| Some((old.as_symbol().filter(|name| is_free(name))?.to_owned(), new)));
        let what = "`subst` of something else than free names by values";
        let because = || because_of(&[equation], Refusal::new(what, "let Maxima do it, and write what it gives", span));
        pairs.push(pair.ok_or_else(because)?);
    }
    // what is still to be computed must not be computed with other names
    if any(value, &|part| part.as_call().is_some_and(|(name, _)| words::computes(name) || name == "lambda")) {
        let what = "it must be computed: `subst` into what only Maxima can compute";
        return Err(Refusal::new(what, COMPUTE, span));
    }
    if !in_turn {
        return Ok(put(value, &|name| pairs.iter().find(|(old, _)| old == name).map(|(_, new)| new.clone())));
    }
    Ok(pairs.iter().fold(value.clone(), |value, (old, new)| put(&value, &|name| (name == old).then(|| new.clone()))))
}

fn is_free(name: &str) -> bool {
    !name.starts_with([super::evaluate::PARAMETER, super::evaluate::ROOT, '%'])
}

fn factorial(number: &Expr, span: &Range<usize>) -> Expr {
    let operator = closedform_maxima::UnaryOperator::Factorial;
    Expr::new(ExprKind::Unary { operator, operand: Box::new(number.clone()) }, span.clone())
}

/// 1 of positive numbers, 0 of the others.
fn unit_step(number: &Expr, span: &Range<usize>) -> Expr {
    let (one, zero) = (tree::number(1, span), tree::number(0, span));
    let condition = tree::binary(BinaryOperator::Compare(Relation::Greater), number.clone(), zero.clone(), span);
    let branches = vec![Branch { condition, value: one }];
    Expr::new(ExprKind::If { branches, otherwise: Some(Box::new(zero)) }, span.clone())
}

/// Another form of a value. Forms of fractions would replace floats by fractions near them.
fn form(name: &str, value: &Expr, span: &Range<usize>) -> Result<Expr, Refusal> {
    if words::rounds_floats(name) && any(value, &|part| matches!(part.kind, ExprKind::Float(_))) {
        let what = format!("`{name}` replaces numbers with a decimal point by fractions near them");
        return Err(Refusal::new(what, "write such numbers as fractions: 1/10 instead of 0.1", span));
    }
    Ok(value.clone())
}
