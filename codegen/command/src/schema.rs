//! `closedform schema NAME`: JSON schemas of contracts, of `closedform.toml`, and of what commands write as JSON.

use std::collections::BTreeSet;

use clap::ValueEnum;
use closedform_system::output;
use miette::IntoDiagnostic;
use serde_json::{Value, json};

/// Of contracts `NAME.toml`.
pub const CONTRACT: &str = include_str!("../schema/contract.schema.json");

/// Of `closedform.toml`.
pub const PROJECT: &str = include_str!("../schema/project.schema.json");

/// Of every output, as definitions of one document.
const OUTPUTS: &str = include_str!("../schema/outputs.schema.json");

/// How a part of a document refers to a definition.
const DEFINITION: &str = "#/definitions/";

/// Print the JSON schema of a contract or of closedform.toml, by which editors complete and check them, or of what a
/// command writes as JSON
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// What the schema is of
    name: Name,
}

/// What has a schema.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Name {
    /// NAME.toml beside a worksheet
    Contract,
    /// closedform.toml
    Project,
    /// `list --json`
    List,
    /// `show --json`
    Show,
    /// `eval --json`
    Eval,
    /// `verify --json`
    Verify,
    /// `ledger --json`
    Ledger,
    /// `mutants --json`
    Mutants,
    /// `plan --json`
    Plan,
    /// `plan --table FILE.json`
    Table,
}

/// Prints a schema.
///
/// # Errors
///
/// When it cannot be written.
pub fn run(args: &Args) -> miette::Result<()> {
    match args.name {
        Name::Contract => output::print(CONTRACT)?,
        Name::Project => output::print(PROJECT)?,
        output => output::print_json(&of_output(output).into_diagnostic()?)?,
    }
    Ok(())
}

/// A document of its own for an output, with the definitions that it needs.
fn of_output(name: Name) -> serde_json::Result<Value> {
    let mut document: Value = serde_json::from_str(OUTPUTS)?;
    let name = name.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
    let mut needed = BTreeSet::new();
    collect(&document["definitions"], &name, &mut needed);
    if let Some(definitions) = document["definitions"].as_object_mut() {
        definitions.retain(|name, _| needed.contains(name));
    }
    document["allOf"] = json!([{ "$ref": format!("{DEFINITION}{name}") }]);
    Ok(document)
}

/// The names of a definition and of all that it refers to.
fn collect(definitions: &Value, name: &str, needed: &mut BTreeSet<String>) {
    if !needed.insert(name.to_owned()) {
        return;
    }
    let mut parts = vec![&definitions[name]];
    while let Some(part) = parts.pop() {
        match part {
            Value::Object(keys) => parts.extend(keys.values()),
            Value::Array(items) => parts.extend(items),
            Value::String(text) => {
                text.strip_prefix(DEFINITION).into_iter().for_each(|name| collect(definitions, name, needed));
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_has_what_it_refers_to_and_no_more() {
        let document = of_output(Name::Eval).unwrap();
        let names: Vec<&str> = document["definitions"].as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(names, ["bound", "eval", "full_name", "number", "unit", "worksheet"]);
        assert_eq!(document["allOf"][0]["$ref"], "#/definitions/eval");
    }

    #[test]
    fn every_name_has_a_schema() {
        let outputs: Value = serde_json::from_str(OUTPUTS).unwrap();
        for name in Name::value_variants().iter().filter(|name| !matches!(name, Name::Contract | Name::Project)) {
            let name = name.to_possible_value().unwrap();
            assert!(outputs["definitions"][name.get_name()].is_object(), "{}", name.get_name());
        }
    }
}
