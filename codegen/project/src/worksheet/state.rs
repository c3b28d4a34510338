//! What Maxima knows while it reads a worksheet: values of names, functions, assumptions, and what became unknown.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::rc::Rc;

use closedform_maxima::Expr;

/// Why something has no formula, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Refusal {
    /// What is wrong, as a sentence about the formula.
    pub(crate) what: String,
    /// What to do about it.
    pub(crate) remedy: String,
    /// Where it shows.
    pub(crate) span: Range<usize>,
    /// Where it comes from, if that is elsewhere.
    pub(crate) cause: Option<Range<usize>>,
}

impl Refusal {
    pub(super) fn new(what: impl Into<String>, remedy: impl Into<String>, span: &Range<usize>) -> Self {
        Self { what: what.into(), remedy: remedy.into(), span: span.clone(), cause: None }
    }
}

/// Why an evaluation gives no value.
#[derive(Debug)]
pub(super) enum Stop {
    /// There is none that can be known.
    Refused(Refusal),
    /// `return(value)` on its way to the block that it ends.
    Return(Expr),
}

impl From<Refusal> for Stop {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

/// The value of an expression, if it has one that is known.
pub(super) type Evaluated<T = Expr> = Result<T, Stop>;

/// What a name stands for.
#[derive(Debug, Clone)]
pub(super) enum Binding {
    /// A value.
    Value(Rc<Expr>),
    /// Something that only Maxima knows.
    Unknown(Rc<Refusal>),
}

/// A function of the worksheet.
#[derive(Debug, Clone)]
pub(super) struct Function {
    /// Its parameters, or why it cannot be called here.
    pub(super) parameters: Result<Vec<String>, Refusal>,
    /// What it is worth.
    pub(super) body: Rc<Expr>,
    /// Whether its value is evaluated once more, where it was called: `::=`.
    pub(super) is_macro: bool,
    /// Where it is defined.
    pub(super) span: Range<usize>,
}

/// All that a worksheet has said so far.
#[derive(Debug, Clone, Default)]
pub(super) struct State {
    /// Names with values; elements of arrays under `name[index]`.
    pub(super) variables: BTreeMap<String, Binding>,
    /// Functions by name.
    pub(super) functions: BTreeMap<String, Rc<Function>>,
    /// Functions of subscripts: `a[n]:=..`.
    pub(super) arrays: BTreeMap<String, Rc<Function>>,
    /// Names that are declared to depend on others.
    pub(super) dependent: BTreeSet<String>,
    /// What `assume` was told.
    pub(super) facts: Vec<Expr>,
    /// Why any other name may have a value too.
    pub(super) fog: Option<Refusal>,
    /// The value of the statement before.
    pub(super) last: Option<Binding>,
}

/// Names with what they stood for before.
pub(super) type Saved = Vec<(String, Option<Binding>)>;

impl State {
    /// Gives a name another meaning; what it stood for before is to be restored.
    pub(super) fn bind(&mut self, name: &str, binding: Option<Binding>) -> (String, Option<Binding>) {
        let before = match binding {
            Some(binding) => self.variables.insert(name.to_owned(), binding),
            None => self.variables.remove(name),
        };
        (name.to_owned(), before)
    }

    /// Ends local meanings, the last one first.
    pub(super) fn restore(&mut self, saved: Saved) {
        for (name, before) in saved.into_iter().rev() {
            self.bind(&name, before);
        }
    }

    /// From here on the value of a name is not known.
    pub(super) fn forget_value(&mut self, name: &str, because: &Refusal) {
        let unknown = Binding::Unknown(Rc::new(because.clone()));
        self.arrays.remove(name);
        let elements = format!("{name}[");
        for (_, binding) in self.variables.iter_mut().filter(|(element, _)| element.starts_with(&elements)) {
            *binding = unknown.clone();
        }
        self.variables.insert(name.to_owned(), unknown);
    }

    /// From here on nothing is known of a function.
    pub(super) fn forget_function(&mut self, name: &str, because: &Refusal) {
        let span = because.span.clone();
        let body = Rc::new(Expr::new(closedform_maxima::ExprKind::Symbol(name.to_owned()), span.clone()));
        let function = Function { parameters: Err(because.clone()), body, is_macro: false, span };
        self.functions.insert(name.to_owned(), Rc::new(function));
    }

    /// From here on nothing is known.
    pub(super) fn forget_all(&mut self, because: &Refusal) {
        let names: Vec<String> = self.variables.keys().cloned().collect();
        names.iter().for_each(|name| self.forget_value(name, because));
        let functions: Vec<String> = self.functions.keys().cloned().collect();
        functions.iter().for_each(|name| self.forget_function(name, because));
        self.facts.clear();
        self.arrays.clear();
        self.fog.get_or_insert_with(|| because.clone());
    }

    /// What differs from an earlier state is not known: it was done under a condition that nobody decided.
    pub(super) fn doubt(&mut self, earlier: Self, because: &Refusal) {
        let doubtful =
            |name: &&String, one: &Self, other: &Self| match (one.variables.get(*name), other.variables.get(*name)) {
                (Some(Binding::Value(one)), Some(Binding::Value(other))) => !Rc::ptr_eq(one, other),
                (None, None) => false,
                (Some(Binding::Unknown(_)), Some(Binding::Unknown(_))) => false,
                _ => true,
            };
        let names: Vec<String> = self
            .variables
            .keys()
            .chain(earlier.variables.keys())
            .filter(|name| doubtful(name, self, &earlier))
            .cloned()
            .collect();
        let functions: Vec<String> = self
            .functions
            .iter()
            .filter(|(name, now)| earlier.functions.get(*name).is_none_or(|before| !Rc::ptr_eq(now, before)))
            .map(|(name, _)| name.clone())
            .collect();
        names.iter().for_each(|name| self.forget_value(name, because));
        functions.iter().for_each(|name| self.forget_function(name, because));
        self.facts = earlier.facts;
    }
}
