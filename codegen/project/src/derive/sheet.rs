//! A worksheet without a contract: Maxima runs it and prints what its names stand for in the end.

use std::path::{Path, PathBuf};

use closedform_build::VERSION;
use closedform_maxima::{Expr, ExprKind, mentions, parse_expression, parse_what_can_be, print};

use super::ask::Options;
use super::error::DeriveError;
use crate::beside::beside;
use crate::family::Paths;
use crate::files;
use crate::maxima_process::{Message, reaching};
use crate::script::Script;
use crate::source;
use crate::statements::statements;
use crate::worksheet::{Wanted, ends_maxima, is_about_numbers, is_loading, is_package, wanted};

/// What Maxima left of a worksheet, not yet written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DerivedSheet {
    /// The text of `NAME.ref`.
    pub text: String,
    /// Where it is to be written.
    pub reference: PathBuf,
    /// How many formulas it holds.
    pub formulas: usize,
    /// What Maxima was not asked for or could not say, in words with their lines.
    pub passed: Vec<String>,
}

impl DerivedSheet {
    /// Writes `NAME.ref`.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&self) -> Result<(), DeriveError> {
        Ok(files::write_all(&[(&*self.reference, &*self.text)])?)
    }
}

/// Lets Maxima run a worksheet without a contract; writes nothing. Statements that draw, touch files, load what is not at
/// hand or do other things beyond the worksheet are passed over, unless they may.
///
/// # Errors
/// When it asks, fails, takes too long, reaches beyond itself, or leaves no formula.
pub fn derive_sheet(worksheet: &Path, options: &Options) -> Result<DerivedSheet, DeriveError> {
    let folder = worksheet.parent().unwrap_or(Path::new(""));
    let stem = worksheet.file_stem().unwrap_or_default().to_string_lossy();
    let reference = Paths::new(folder, &stem).reference;
    files::replaceable([&*reference])?;
    let script = Script::load(worksheet).map_err(crate::maxima_process::ProcessError::from)?;
    let line = |at: usize| script.text()[..at].matches('\n').count() + 1;
    let beyond = match options.maxima.allow_system {
        true => Vec::new(),
        false => reaching(&script, &beside(worksheet, script.text())),
    };
    let beyond: Vec<(usize, String)> = beyond.into_iter().chain(absent(&script, worksheet, options)).collect();
    let passed = beyond.iter().map(|(at, name)| format!("line {}: passed over: it calls `{name}`", line(*at)));
    let mut passed: Vec<String> = passed.collect();
    let end = end_of(script.text());
    passed.extend(end.map(|end| format!("line {}: passed over: `quit`, and what follows it", line(end))));
    let after = end.into_iter().flat_map(|end| statements_from(script.text(), end));
    let run = script.without(&beyond.iter().map(|(at, _)| *at).chain(after).collect::<Vec<_>>());
    let names = wanted(run.text());
    let messages = options.maxima.run_script(&run, worksheet, &driver(&names))?;
    let said = Said::read(&messages);
    let mut text = header(worksheet, said.version);
    said.facts().for_each(|fact| text += &format!("assume({fact})$\n"));
    let mut formulas = 0;
    for (index, wanted) in names.iter().enumerate() {
        let value = match wanted.not_asked {
            Some(because) => Err(because.to_owned()),
            None => said.value(index),
        };
        match value {
            Ok(Some(value)) => {
                text += &statement(wanted, &value);
                formulas += 1;
            }
            Ok(None) => {}
            Err(because) => {
                passed.push(format!("line {}: passed over: `{}`: {because}", line(wanted.start), wanted.name));
            }
        }
    }
    if formulas == 0 {
        return Err(DeriveError::Nothing { path: worksheet.to_owned(), passed });
    }
    let inputs = closedform_build::hash([&*source::read_bytes(worksheet)?]);
    Ok(DerivedSheet { text: closedform_build::stamped(&text, VERSION, inputs), reference, formulas, passed })
}

/// Where a statement ends Maxima, which is done all the same when it has read the file.
fn end_of(text: &str) -> Option<usize> {
    let (statements, _) = parse_what_can_be(text);
    statements.iter().map(|statement| &statement.expression).find(|it| ends_maxima(it)).map(|it| it.span.start)
}

fn statements_from(text: &str, start: usize) -> Vec<usize> {
    statements(text).into_iter().map(|statement| statement.place.start).filter(|place| *place >= start).collect()
}

/// The places that load what is neither at hand nor a package that is known.
fn absent(script: &Script, worksheet: &Path, options: &Options) -> Vec<(usize, String)> {
    if options.maxima.allow_system {
        return Vec::new();
    }
    let beside = beside(worksheet, script.text());
    let is_known = |name: &str| beside.contains_key(name) || is_package(name);
    let loads = mentions(script.text()).into_iter().filter(|mention| is_loading(&mention.name));
    let absent = loads.filter_map(|mention| Some((mention.span.start, mention.argument?)));
    absent.filter(|(_, name)| !is_known(name)).map(|(at, name)| (at, format!("load(\"{name}\")"))).collect()
}

fn header(worksheet: &Path, version: &str) -> String {
    let name = worksheet.file_name().unwrap_or_default().to_string_lossy();
    format!(
        "/* reference expressions, written by `closedform derive {name}` from {name}; do not edit */\n\
         /* Maxima {version} */\n"
    )
}

fn statement(wanted: &Wanted, value: &str) -> String {
    let name = spelt(&wanted.name);
    match &wanted.parameters {
        Some(parameters) => {
            let parameters: Vec<String> = parameters.iter().map(|parameter| spelt(parameter)).collect();
            format!("{name}({}):={value}$\n", parameters.join(","))
        }
        None => format!("{name}:{value}$\n"),
    }
}

/// A name with its backslashes.
fn spelt(name: &str) -> String {
    print(&Expr::from(ExprKind::Symbol(name.to_owned())))
}

/// Statements that say what Maxima assumes, and the value of every name; of a function its value for plain symbols.
fn driver(names: &[Wanted]) -> String {
    let mut driver = String::from(
        "closedform_ask_nothing()$\n\
         closedform_say(sconcat(\"version|\", closedform_version()))$\n\
         closedform_spell(closedform_value) := string(closedform_value)$\n\
         for closedform_fact in facts() do closedform_say(sconcat(\"fact|\", closedform_spell(closedform_fact)))$\n",
    );
    for (index, wanted) in names.iter().enumerate().filter(|(_, wanted)| wanted.not_asked.is_none()) {
        let name = spelt(&wanted.name);
        let asked = match &wanted.parameters {
            None => name,
            Some(parameters) => {
                let symbols: Vec<String> = parameters.iter().map(|name| format!("'{}", spelt(name))).collect();
                format!("{name}({})", symbols.join(", "))
            }
        };
        driver += &format!(
            "closedform_expression: errcatch({asked})$\n\
             closedform_say(simplode(cons(\"value|{index}|\", map(closedform_spell, closedform_expression))))$\n"
        );
    }
    driver
}

/// What the driver said.
struct Said<'a> {
    version: &'a str,
    messages: &'a [Message],
}

impl<'a> Said<'a> {
    fn read(messages: &'a [Message]) -> Self {
        let version = messages.iter().find_map(|message| message.text.strip_prefix("version|"));
        Self { version: version.unwrap_or("of unknown version"), messages }
    }

    /// What is assumed of numbers.
    fn facts(&self) -> impl Iterator<Item = &'a str> {
        let facts = self.messages.iter().filter_map(|message| message.text.strip_prefix("fact|"));
        facts.filter(|fact| parse_expression(fact).is_ok_and(|fact| is_about_numbers(&fact)))
    }

    /// The value of a name, none if it is a mere word or text; or why there is none.
    fn value(&self, index: usize) -> Result<Option<String>, String> {
        let about = format!("value|{index}|");
        let found = self.messages.iter().find_map(|message| Some((message.text.strip_prefix(&about)?, &message.noise)));
        match found {
            None => Err("Maxima says nothing of it".to_owned()),
            Some(("", noise)) => Err(format!("Maxima has no value: {}", noise.join(" "))),
            Some((text, _)) => match parse_expression(text) {
                Ok(value) if matches!(value.kind, ExprKind::Symbol(_) | ExprKind::String(_)) => Ok(None),
                Ok(_) => Ok(Some(text.to_owned())),
                Err(error) => Err(format!("what Maxima prints of it is not read: {error}")),
            },
        }
    }
}
