//! Places: where in its source a refused kernel has what is refused.

use crate::refusal::{Reason, Refusal};
use crate::text::text;
use closedform_syntax::{Condition, Expr, Kernel, condition_text};
use proc_macro2::Span;
use std::ops::Range;

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Its line, from 1.
    pub line: usize,
    /// The column where it begins, from 1.
    pub column: usize,
    /// Its bytes.
    pub bytes: Range<usize>,
}

impl Place {
    /// From the beginning of one span to the end of another.
    #[must_use]
    pub fn between(first: Span, last: Span) -> Self {
        let start = first.start();
        Self { line: start.line, column: start.column + 1, bytes: first.byte_range().start..last.byte_range().end }
    }

    /// A place and what is wrong there, as compilers show it.
    #[must_use]
    pub fn shown(&self, file: &str, source: &str, message: &str) -> String {
        let line = source.lines().nth(self.line - 1).unwrap_or_default();
        let number = self.line.to_string();
        let (edge, indent) = (" ".repeat(number.len()), " ".repeat(self.column - 1));
        let wide = source.get(self.bytes.clone()).unwrap_or_default().lines().next().unwrap_or_default();
        let caret = "^".repeat(wide.chars().count().max(1));
        format!("{file}:{number}:{}: {message}\n{edge} |\n{number} | {line}\n{edge} | {indent}{caret}", self.column)
    }
}

/// Where a kernel has what is refused: the expression, else its step, else the kernel's name.
#[must_use]
pub fn place(kernel: &Kernel, refusal: &Refusal) -> Place {
    let name = kernel.name.span();
    if matches!(refusal.reason, Reason::Understated { .. } | Reason::Overstated { .. }) {
        let stated = kernel.meta.bound_place.unwrap_or(name);
        return Place::between(stated, stated);
    }
    let quoted = refusal.reason.quoted();
    let within = |value| quoted.and_then(|quoted| find(value, quoted));
    if refusal.step == "require!" {
        let comparisons = kernel.requires.iter().flat_map(|require| require.condition.comparisons());
        let found = comparisons.filter_map(|comparison| of_comparison(comparison, quoted)).next();
        return found.unwrap_or_else(|| Place::between(name, name));
    }
    if let Some(step) = kernel.lets.iter().find(|step| step.name == refusal.step) {
        return within(&step.value).unwrap_or_else(|| Place::between(step.name.span(), step.name.span()));
    }
    kernel.output.values().find_map(within).unwrap_or_else(|| Place::between(name, name))
}

fn of_comparison(comparison: &Condition, quoted: Option<&str>) -> Option<Place> {
    let Condition::Compare { left, right, .. } = comparison else { return None };
    let quoted = quoted?;
    if condition_text(comparison) == quoted {
        return Some(Place::between(ends(left)?.0, ends(right)?.1));
    }
    find(left, quoted).or_else(|| find(right, quoted))
}

/// The part of an expression that a message quotes.
fn find(expr: &Expr, quoted: &str) -> Option<Place> {
    if text(expr) == quoted {
        return ends(expr).map(|(first, last)| Place::between(first, last));
    }
    expr.children().into_iter().find_map(|part| find(part, quoted))
}

/// The first and the last literal or name.
fn ends(expr: &Expr) -> Option<(Span, Span)> {
    match expr {
        Expr::Literal { span, .. } | Expr::Pi(span) => Some((*span, *span)),
        Expr::Name(name) => Some((name.ident.span(), name.ident.span())),
        _ => {
            let parts = expr.children();
            Some((ends(parts.first()?)?.0, ends(parts.last()?)?.1))
        }
    }
}
