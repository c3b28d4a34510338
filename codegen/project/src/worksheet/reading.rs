//! What a worksheet comes to: its formulas, and everything else that is worth telling.

use std::collections::BTreeSet;
use std::ops::Range;

use closedform_maxima::Error;

use super::formula::Formula;
use super::state::Refusal;

/// What a worksheet comes to.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    /// Its formulas, in the order in which their names are defined last.
    pub(crate) formulas: Vec<Formula>,
    /// Names without one, and why.
    pub(crate) refused: Vec<(String, Refusal)>,
    /// Names that stand for numbers, texts or settings.
    pub(crate) constants: Vec<String>,
    /// Names whose values were put into formulas.
    pub(crate) inlined: BTreeSet<String>,
    /// Definitions that later ones replace.
    pub(crate) replaced: Vec<(String, Range<usize>)>,
    /// Statements that are no formulas, each with a word for what it is.
    pub(crate) passed: Vec<(String, Range<usize>)>,
    /// What is no Maxima.
    pub(crate) errors: Vec<Error>,
}

impl Reading {
    /// Refuses formulas one of whose results would be called as another one is.
    pub(super) fn refuse_clashes(&mut self) {
        let mut taken = BTreeSet::new();
        // what has one result has its name, whatever the parts of others are called
        self.formulas.sort_by_key(|formula| formula.results.len() > 1);
        let mut clashing = Vec::new();
        self.formulas.retain(|formula| {
            let names: Vec<String> = formula.results.iter().map(|(field, _)| formula.worksheet_name(field)).collect();
            let clash = names.iter().find(|name| taken.contains(*name)).cloned();
            match &clash {
                None => taken.extend(names),
                Some(clash) => clashing.push((formula.name.clone(), clash.clone(), formula.span.clone())),
            }
            clash.is_none()
        });
        for (name, clash, span) in clashing {
            let what = format!("two values of the worksheet would be called `{clash}`");
            self.refused.push((name, Refusal::new(what, "rename one of them", &span)));
        }
        self.formulas.sort_by_key(|formula| formula.span.start);
    }
}
