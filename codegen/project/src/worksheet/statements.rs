//! Statements that change what Maxima knows instead of computing: assumptions, kills, declarations, other files.

use std::ops::Range;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator, parse_what_can_be, print};

use super::evaluate::Evaluator;
use super::state::{Evaluated, Refusal};
use super::tree::{at, binary, list, symbol};
use super::words;

/// Such functions.
const STATEMENTS: [&str; 10] =
    ["assume", "declare", "depends", "forget", "kill", "local", "remfunction", "remvalue", "tellsimp", "tellsimpafter"];

/// What a line of Lisp is a call of.
const LISP: &str = ":lisp";

/// Declarations under which a name stands for no real number.
const NOT_REAL: [&str; 2] = ["complex", "imaginary"];

impl Evaluator {
    pub(super) fn is_statement(&self, name: &str) -> bool {
        STATEMENTS.contains(&name)
            || name == LISP
            || words::is_changing(name)
            || words::is_sweeping(name)
            || words::is_loading(name)
    }

    pub(super) fn statement(&mut self, whole: &Expr, name: &str, arguments: &[Expr]) -> Evaluated {
        let span = &whole.span;
        if name == LISP {
            self.absent.push(("a line of Lisp: names that it may define are inputs".to_owned(), span.clone()));
            return Ok(symbol("done", span));
        }
        match name {
            "assume" => self.assume(arguments)?,
            "forget" => {
                let facts: Vec<Expr> = arguments.iter().map(|fact| self.value(fact)).collect::<Evaluated<_>>()?;
                let told: Vec<Expr> = facts.iter().flat_map(facts_in).collect();
                self.state.facts.retain(|fact| !told.contains(fact));
            }
            "declare" => arguments.chunks(2).for_each(|pair| self.declare(pair)),
            "kill" | "remvalue" | "remfunction" => arguments.iter().for_each(|argument| self.kill(name, argument)),
            "local" => {}
            "depends" => {
                let of = arguments.iter().step_by(2).flat_map(super::tree::names);
                self.state.dependent.extend(of);
            }
            "tellsimp" | "tellsimpafter" if arguments.first().is_some_and(is_of_a_function) => {
                let name = arguments[0].as_call().map_or("", |(name, _)| name);
                let because = Refusal::new("it has a rule of simplification", "write it as a function", span);
                self.state.forget_function(name, &because);
            }
            _ if words::is_loading(name) => return self.load(name, arguments, span),
            _ if words::is_sweeping(name) => {
                return Err(self.sweep(&format!("calls `{name}`, which may change what anything means"), span));
            }
            _ => self.leave(whole, &format!("a call of `{name}`")),
        }
        Ok(symbol("done", span))
    }

    fn assume(&mut self, facts: &[Expr]) -> Evaluated<()> {
        for fact in facts {
            let fact = self.value(fact)?;
            for told in facts_in(&fact) {
                if !self.state.facts.contains(&told) {
                    self.state.facts.push(told);
                }
            }
        }
        Ok(())
    }

    fn declare(&mut self, pair: &[Expr]) {
        let [names, properties] = pair else { return };
        let items = |expression: &Expr| list(expression).map_or_else(|| vec![expression.clone()], <[Expr]>::to_vec);
        let properties = items(properties);
        let word = properties.iter().filter_map(Expr::as_symbol).find(|word| NOT_REAL.contains(word));
        let Some(word) = word else { return };
        for name in items(names) {
            if let Some(name) = name.as_symbol() {
                let what = format!("`{name}` is declared {word}, and kernels compute real numbers");
                let because = Refusal::new(what, "define the real and the imaginary part", &names.span);
                self.state.forget_value(name, &because);
            }
        }
    }

    fn kill(&mut self, word: &str, what: &Expr) {
        match (word, what.as_symbol()) {
            ("kill", Some("all")) => self.state = super::state::State::default(),
            ("remvalue", Some("all")) | ("kill", Some("values")) => self.state.variables.clear(),
            ("remfunction", Some("all")) | ("kill", Some("functions")) => self.state.functions.clear(),
            ("kill", Some(name)) => {
                self.remove_value(name);
                self.state.functions.remove(name);
                self.state.arrays.remove(name);
                self.state.dependent.remove(name);
                let mentions = |fact: &Expr| super::tree::names(fact).iter().any(|other| other == name);
                self.state.facts.retain(|fact| !mentions(fact));
            }
            ("remvalue", Some(name)) => self.remove_value(name),
            ("remfunction", Some(name)) => _ = self.state.functions.remove(name),
            _ => {
                let because = Refusal::new("it may be killed here", "kill names one by one", &what.span);
                self.state.forget_all(&because);
            }
        }
    }

    fn remove_value(&mut self, name: &str) {
        let elements = format!("{name}[");
        self.state.variables.retain(|other, _| other != name && !other.starts_with(&elements));
    }

    /// Another file: a package that changes no formula, a file that is at hand, or one that may say anything.
    fn load(&mut self, word: &str, arguments: &[Expr], span: &Range<usize>) -> Evaluated {
        let named = arguments.first().and_then(|argument| match &argument.kind {
            ExprKind::String(name) | ExprKind::Symbol(name) => Some(name.clone()),
            _ => None,
        });
        let Some(named) = named else {
            let what = format!("`{word}` of a file whose name is computed: names that it may define are inputs");
            self.absent.push((what, span.clone()));
            return Ok(symbol("done", span));
        };
        match self.files.remove(&named) {
            Some(text) => self.read(&named, &text, span),
            None if words::is_package(&named) => Ok(symbol("done", span)),
            // what it defines is not known; what this text says holds all the same
            None => {
                let what = format!("`{named}` is not at hand: names that it may define are inputs");
                self.absent.push((what, span.clone()));
                Ok(symbol("done", span))
            }
        }
    }

    /// The statements of another file, as if they stood where it is loaded.
    fn read(&mut self, named: &str, text: &str, span: &Range<usize>) -> Evaluated {
        let (statements, errors) = parse_what_can_be(text);
        if let Some(error) = errors.first() {
            let line = text[..error.span().start].matches('\n').count() + 1;
            return Err(self.sweep(&format!("reads `{named}`, whose line {line} is not Maxima: {error}"), span));
        }
        for statement in statements {
            self.rest();
            let statement = at(&statement.expression, span);
            let done = self.spliced(&statement).and_then(|statement| self.value(&statement));
            if let Err(super::state::Stop::Refused(because)) = &done
                && super::calls::changes(&statement)
                && statement.as_call().is_some()
            {
                super::effects::Effects::of(&statement, &self.state).apply(&mut self.state, because);
            }
        }
        Ok(symbol("done", span))
    }
}

/// Whether a pattern is a call of a function without a meaning of its own.
fn is_of_a_function(pattern: &Expr) -> bool {
    let meaning = |name: &str| crate::expression::is_known_function(name) || words::computes(name);
    pattern.as_call().is_some_and(|(name, _)| !meaning(name))
}

/// Comparisons that must hold, of what `assume` was told.
fn facts_in(fact: &Expr) -> Vec<Expr> {
    match &fact.kind {
        ExprKind::Binary { operator: BinaryOperator::And, left, right } => [facts_in(left), facts_in(right)].concat(),
        ExprKind::List(items) => items.iter().flat_map(facts_in).collect(),
        _ => vec![comparison(fact)],
    }
}

/// `equal(a,b)` and `notequal(a,b)` as comparisons, wherever they stand.
pub(super) fn comparison(fact: &Expr) -> Expr {
    let turned = |relation, left: &Expr, right: &Expr| {
        binary(BinaryOperator::Compare(relation), left.clone(), right.clone(), &fact.span)
    };
    match fact.as_call() {
        Some(("equal", [left, right])) => turned(Relation::Equal, left, right),
        Some(("notequal", [left, right])) => turned(Relation::NotEqual, left, right),
        Some(("is" | "maybe", [inner])) => comparison(inner),
        _ => match &fact.kind {
            ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right }
                if is_truth(left)
                    && let Some(wanted) = told(*relation, right) =>
            {
                if wanted {
                    comparison(left)
                } else {
                    negated(comparison(left), &fact.span)
                }
            }
            ExprKind::Unary { .. } | ExprKind::Binary { operator: BinaryOperator::And | BinaryOperator::Or, .. } => {
                let Ok(mapped) = super::tree::map::<std::convert::Infallible>(fact, &mut |part| Ok(comparison(part)));
                mapped
            }
            _ => fact.clone(),
        },
    }
}

/// Whether something is true or false, and no number.
pub(super) fn is_truth(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Binary { operator, .. } => {
            operator.is_comparison() || matches!(operator, BinaryOperator::And | BinaryOperator::Or)
        }
        ExprKind::Unary { operator, .. } => *operator == UnaryOperator::Not,
        ExprKind::Symbol(word) => ["true", "false"].contains(&word.as_str()),
        _ => matches!(value.as_call(), Some(("is" | "maybe" | "equal" | "notequal", _))),
    }
}

/// What must be so for `= true`, `= false` or `#` of one of them to hold.
fn told(relation: Relation, word: &Expr) -> Option<bool> {
    let word = match word.as_symbol()? {
        "true" => true,
        "false" => false,
        _ => return None,
    };
    match relation {
        Relation::Equal => Some(word),
        Relation::NotEqual => Some(!word),
        _ => None,
    }
}

fn negated(condition: Expr, span: &Range<usize>) -> Expr {
    Expr::new(ExprKind::Unary { operator: UnaryOperator::Not, operand: Box::new(condition) }, span.clone())
}

/// A fact as people read it.
pub(crate) fn spelt(fact: &Expr) -> String {
    match &fact.kind {
        ExprKind::Binary { operator: operator @ BinaryOperator::Compare(_), left, right } => {
            format!("{} {} {}", print(left), operator.symbol(), print(right))
        }
        _ => print(fact),
    }
}
