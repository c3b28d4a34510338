//! A worksheet judged: the definitions that kernels can be made of, and everything that is wrong with the others.

use std::collections::BTreeSet;

use closedform_maxima::{Definition, Worksheet, defined_twice, readable_worksheet};
use miette::SourceSpan;

use super::super::reference::{self, ReferenceMistake};
use super::inline;
use super::mistake::WorksheetMistake;
use crate::contract::{Contract, KernelContract};

/// A worksheet whose definitions are put into each other.
pub(super) struct Judged<'a> {
    text: &'a str,
    /// The definitions that have a closed form.
    pub(super) definitions: Vec<Definition>,
    /// The functions that other definitions have.
    refused: BTreeSet<String>,
    mistakes: Vec<WorksheetMistake>,
}

/// Kernels with their reference expressions.
pub(super) type Sound = (Vec<KernelContract>, Vec<Definition>);

impl<'a> Judged<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let (sheet, errors) = readable_worksheet(text);
        let mut mistakes: Vec<WorksheetMistake> = errors.into_iter().map(Into::into).collect();
        if mistakes.is_empty() && sheet.definitions.is_empty() && sheet.others.is_empty() {
            mistakes.push(WorksheetMistake::Nothing);
        }
        mistakes.extend(computing(&sheet));
        let wrong = wrong_heads(&sheet.definitions);
        let wrong_names: BTreeSet<String> = wrong.iter().map(|(name, _)| name.clone()).collect();
        mistakes.extend(wrong.into_iter().map(|(_, mistake)| mistake));
        let (mut definitions, endless) = inline::inline(&sheet.definitions);
        mistakes.extend(endless);
        definitions.retain(|definition| !wrong_names.contains(&definition.name));
        let has_form = |name: &String| definitions.iter().any(|definition| definition.name == *name);
        let refused = sheet.definitions.into_iter().map(|definition| definition.name).filter(|name| !has_form(name));
        let refused = refused.collect();
        Self { text, definitions, refused, mistakes }
    }

    /// The kernels of a contract that can be made, and all mistakes of the worksheet in the order of its text.
    pub(super) fn against(mut self, contract: &Contract) -> (Sound, Vec<WorksheetMistake>) {
        let mut sound = Sound::default();
        let mut unfit = Vec::new();
        for kernel in &contract.kernels {
            if let Some(references) = self.references(kernel, &mut unfit) {
                sound.0.push(kernel.clone());
                sound.1.extend(references);
            }
        }
        let follows = |mistake: &ReferenceMistake| self.follows(mistake);
        unfit.retain(|mistake| !follows(mistake));
        let unfit = reference::first_of_each(unfit).into_iter().map(WorksheetMistake::from);
        self.mistakes.extend(unfit);
        (sound, in_order(self.mistakes))
    }

    /// The reference expressions of a kernel, if it has them all and nothing is wrong with them.
    fn references(&self, kernel: &KernelContract, unfit: &mut Vec<ReferenceMistake>) -> Option<Vec<Definition>> {
        let mut references = Some(Vec::new());
        for result in &kernel.results {
            let definition = self.definitions.iter().find(|definition| definition.name == result.worksheet);
            let mistakes = match definition {
                Some(definition) => reference::mistakes_of(definition, &kernel.inputs),
                None if self.refused.contains(&result.worksheet) => Vec::new(),
                None => {
                    vec![ReferenceMistake::Missing { worksheet: result.worksheet.clone(), kernel: kernel.name.clone() }]
                }
            };
            references = references.zip(definition).filter(|_| mistakes.is_empty()).map(|(mut all, definition)| {
                all.push(definition.clone());
                all
            });
            unfit.extend(mistakes);
        }
        references
    }

    /// Whether a mistake may be none once others are corrected: a statement that was not run or not read defines the name.
    fn follows(&self, mistake: &ReferenceMistake) -> bool {
        let computes = self.mistakes.iter().any(|mistake| matches!(mistake, WorksheetMistake::Computes { .. }));
        match mistake {
            ReferenceMistake::UnknownVariable { .. } => computes,
            ReferenceMistake::UnknownFunction { name, .. } => computes || self.seems_defined(name),
            ReferenceMistake::Missing { worksheet, .. } => computes || self.seems_defined(worksheet),
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
}

fn computing(sheet: &Worksheet) -> Option<WorksheetMistake> {
    let first = sheet.others.first()?;
    Some(WorksheetMistake::Computes { statements: sheet.others.len(), span: first.expression.span.clone().into() })
}

/// What is wrong with definitions besides their bodies, each with the function.
fn wrong_heads(definitions: &[Definition]) -> Vec<(String, WorksheetMistake)> {
    let twice = defined_twice(definitions).into_iter().filter_map(|error| match &error {
        closedform_maxima::Error::DefinedTwice { name, .. } => Some((name.clone(), error.into())),
        _ => None,
    });
    let parameters = definitions.iter().filter_map(|definition| {
        let (name, span) = (definition.name.clone(), SourceSpan::from(definition.span.clone()));
        let mistake = match repeated(&definition.parameters) {
            _ if definition.parameters.is_empty() => WorksheetMistake::Constant { name, span },
            Some(parameter) => WorksheetMistake::Parameter { name, parameter, span },
            None => return None,
        };
        Some((definition.name.clone(), mistake))
    });
    twice.chain(parameters).collect()
}

fn repeated(names: &[String]) -> Option<String> {
    let mut seen = BTreeSet::new();
    names.iter().find(|name| !seen.insert(*name)).cloned()
}

/// The mistakes in the order of the text; what is put into several formulas is told once.
fn in_order(mut mistakes: Vec<WorksheetMistake>) -> Vec<WorksheetMistake> {
    let place = |mistake: &WorksheetMistake| mistake.span().map(|span| (span.offset(), span.len()));
    let mut seen = BTreeSet::new();
    mistakes.retain(|mistake| place(mistake).is_none_or(|place| seen.insert(place)));
    mistakes.sort_by_key(place);
    mistakes
}
