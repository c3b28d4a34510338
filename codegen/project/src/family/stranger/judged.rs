//! A worksheet judged: the formulas that kernels can be made of, and everything that is wrong with the others.

use std::collections::BTreeSet;

use closedform_maxima::Definition;

use super::super::reference::{self, ReferenceMistake};
use super::mistake::WorksheetMistake;
use super::summary::{Summary, summary};
use crate::contract::{Contract, KernelContract};
use crate::domain::Condition;
use crate::worksheet::{Formula, Reading, spelt};

/// A worksheet with its formulas, everything put in.
pub(super) struct Judged {
    pub(super) reading: Reading,
    text: String,
    mistakes: Vec<WorksheetMistake>,
}

/// Kernels with their reference expressions.
#[derive(Default)]
pub(super) struct Sound {
    pub(super) kernels: Vec<KernelContract>,
    pub(super) references: Vec<Definition>,
    pub(super) summary: Summary,
}

/// Conditions as people read them and in exact form.
pub(super) type Conditions = Vec<(String, Condition)>;

impl Judged {
    /// Of what a worksheet of this text comes to.
    pub(super) fn new(text: &str, mut reading: Reading) -> Self {
        let mut mistakes: Vec<WorksheetMistake> = reading.errors.drain(..).map(Into::into).collect();
        mistakes.extend(reading.refused.iter().map(|(name, because)| WorksheetMistake::refused(name, because)));
        if mistakes.is_empty() && reading.formulas.is_empty() {
            mistakes.push(WorksheetMistake::Nothing);
        }
        Self { reading, text: text.to_owned(), mistakes }
    }

    /// The kernels of a contract that can be made, and all mistakes of the worksheet in the order of its text.
    pub(super) fn against(mut self, contract: &Contract) -> (Sound, Vec<WorksheetMistake>) {
        let mut sound = Sound::default();
        let mut unfit = Vec::new();
        for kernel in &contract.kernels {
            if let Some((kernel, references)) = self.references(kernel, &mut unfit) {
                sound.kernels.push(kernel);
                sound.references.extend(references);
            }
        }
        sound.summary = summary(&self.text, &self.reading, &sound.kernels, &unfit);
        unfit.retain(|mistake| !self.follows(mistake));
        let unfit = reference::first_of_each(unfit).into_iter().map(WorksheetMistake::from);
        self.mistakes.extend(unfit);
        (sound, in_order(self.mistakes))
    }

    /// Whether a mistake may be none once others are corrected: what was not read defines the function.
    fn follows(&self, mistake: &ReferenceMistake) -> bool {
        match mistake {
            ReferenceMistake::UnknownFunction { name, .. } => self.seems_defined(name),
            ReferenceMistake::Missing { worksheet, .. } => self.seems_defined(worksheet),
            _ => false,
        }
    }

    /// Whether the text has something like `name(x):=` in it.
    fn seems_defined(&self, name: &str) -> bool {
        self.text.match_indices(name).any(|(at, _)| {
            let stands_alone = !self.text[..at].ends_with(|letter: char| letter.is_alphanumeric() || letter == '_');
            let head = self.text[at + name.len()..].trim_start().strip_prefix('(');
            let after = head.and_then(|rest| rest.split_once(')')).map(|(_, after)| after.trim_start());
            stands_alone && after.is_some_and(|after| after.starts_with(":="))
        })
    }

    /// A kernel with its reference expressions, if it has them all and nothing is wrong with them.
    fn references(
        &mut self,
        kernel: &KernelContract,
        unfit: &mut Vec<ReferenceMistake>,
    ) -> Option<(KernelContract, Vec<Definition>)> {
        let mut references = Some(Vec::new());
        let mut kernel = kernel.clone();
        for result in &kernel.results {
            let formula =
                self.reading.formulas.iter().find_map(|formula| Some((formula, formula.result(&result.worksheet)?)));
            let Some((formula, body)) = formula else {
                let refused = self.reading.refused.iter().any(|(name, _)| *name == result.worksheet);
                let (worksheet, kernel) = (result.worksheet.clone(), kernel.name.clone());
                unfit.extend((!refused).then_some(ReferenceMistake::Missing { worksheet, kernel }));
                references = None;
                continue;
            };
            let parameters = formula.inputs_as(&kernel.inputs);
            let (name, span) = (result.worksheet.clone(), formula.span.clone());
            let definition = Definition { name, parameters, body: body.clone(), span };
            let mistakes = reference::mistakes_of(&definition, &kernel.inputs);
            let conditions = conditions_of(formula, &kernel.inputs).unwrap_or_else(|mistake| {
                self.mistakes.push(mistake);
                references = None;
                Vec::new()
            });
            kernel.domain = kernel.domain.clone().with_natural(conditions);
            references = references.filter(|_| mistakes.is_empty()).map(|mut all: Vec<Definition>| {
                all.push(definition);
                all
            });
            unfit.extend(mistakes);
        }
        references.map(|references| (kernel, references))
    }
}

/// The conditions under which a formula is what its name stands for; all of them must be decided exactly.
fn conditions_of(formula: &Formula, inputs: &[String]) -> Result<Conditions, WorksheetMistake> {
    let exact = |condition: &closedform_maxima::Expr| {
        let read = Condition::read(condition, inputs);
        read.map(|read| (spelt(condition), read))
            .map_err(|error| WorksheetMistake::condition(&formula.name, condition, &error))
    };
    formula.conditions.iter().map(exact).collect()
}

/// What the worksheet assumes of the inputs of a formula, so far as it can be decided exactly.
pub(super) fn assumptions_of(formula: &Formula) -> Conditions {
    let exact = |fact: &closedform_maxima::Expr| Some((spelt(fact), Condition::read(fact, &formula.inputs).ok()?));
    formula.assumed.iter().filter_map(exact).collect()
}

/// The mistakes in the order of the text; what is put into several formulas is told once.
fn in_order(mut mistakes: Vec<WorksheetMistake>) -> Vec<WorksheetMistake> {
    let place = |mistake: &WorksheetMistake| mistake.span().map(|span| (span.offset(), span.len()));
    let mut seen = BTreeSet::new();
    mistakes.retain(|mistake| place(mistake).is_none_or(|place| seen.insert(place)));
    mistakes.sort_by_key(place);
    mistakes
}
