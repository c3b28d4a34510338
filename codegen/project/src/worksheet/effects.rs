//! What a piece of a worksheet that is not evaluated may change.

use std::collections::BTreeSet;

use closedform_maxima::{BinaryOperator, Expr, ExprKind};

use super::state::{Refusal, State};
use super::tree::parts;
use super::words;

/// Names that may be something else afterwards.
#[derive(Default)]
pub(super) struct Effects {
    variables: BTreeSet<String>,
    functions: BTreeSet<String>,
    called: BTreeSet<String>,
    everything: bool,
}

impl Effects {
    /// What an expression may change, with all functions that it calls.
    pub(super) fn of(expression: &Expr, state: &State) -> Self {
        let mut effects = Self::default();
        effects.collect(expression, state);
        effects
    }

    pub(super) fn apply(self, state: &mut State, because: &Refusal) {
        self.variables.iter().for_each(|name| state.forget_value(name, because));
        self.functions.iter().for_each(|name| state.forget_function(name, because));
        if self.everything {
            state.forget_all(because);
        }
    }

    fn collect(&mut self, expression: &Expr, state: &State) {
        match &expression.kind {
            ExprKind::Binary { operator: BinaryOperator::Assign, left, .. } => self.target(left),
            ExprKind::Binary { operator: BinaryOperator::AssignValue, .. } => self.everything = true,
            ExprKind::Binary { operator: BinaryOperator::Define | BinaryOperator::DefineMacro, left, .. } => {
                self.head(left);
                return;
            }
            ExprKind::Symbol(name) => self.function(name, state),
            ExprKind::Call { arguments, .. } => {
                if let Some((name, _)) = expression.as_call() {
                    self.call(name, arguments);
                }
            }
            _ => {}
        }
        parts(expression).into_iter().for_each(|part| self.collect(part, state));
    }

    /// A function of the worksheet that is called, or handed on to something that calls it.
    fn function(&mut self, name: &str, state: &State) {
        if let Some(function) = state.functions.get(name)
            && self.called.insert(name.to_owned())
        {
            self.collect(&function.body, state);
        }
    }

    fn call(&mut self, name: &str, arguments: &[Expr]) {
        match name {
            "define" => arguments.first().into_iter().for_each(|head| self.head(head)),
            "kill" | "remvalue" | "remfunction" => {
                let names = arguments.iter().filter_map(Expr::as_symbol);
                self.everything |=
                    arguments.iter().any(|argument| argument.as_symbol().is_none_or(|name| name == "all"));
                names.for_each(|name| {
                    self.variables.insert(name.to_owned());
                    self.functions.insert(name.to_owned());
                });
            }
            _ if words::is_changing(name) => {
                self.variables.extend(arguments.iter().filter_map(Expr::as_symbol).map(str::to_owned))
            }
            _ if words::is_sweeping(name) || words::is_loading(name) => self.everything = true,
            _ => {}
        }
    }

    fn target(&mut self, target: &Expr) {
        match &target.kind {
            ExprKind::Symbol(name) => _ = self.variables.insert(name.clone()),
            ExprKind::List(items) => items.iter().for_each(|item| self.target(item)),
            ExprKind::Subscript { array, .. } => self.target(array),
            _ => self.everything = true,
        }
    }

    fn head(&mut self, head: &Expr) {
        match &head.kind {
            ExprKind::Call { function, .. } => self.head(function),
            ExprKind::Subscript { array, .. } => self.head(array),
            ExprKind::Symbol(name) => {
                self.functions.insert(name.clone());
                self.variables.insert(name.clone());
            }
            _ => self.everything = true,
        }
    }
}
