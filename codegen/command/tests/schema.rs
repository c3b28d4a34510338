//! Schemas say what is read and written: no key more, none less, and the same ones must be there.

#[path = "schema/checker.rs"]
mod checker;
mod common;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use checker::{Checker, keys};
use closedform_project::{Project, contract};
use common::{closedform, project, repository, succeeds};
use serde_json::Value;

fn schema(name: &str) -> Value {
    serde_json::from_str(&succeeds(&repository(), &["schema", name])).unwrap()
}

fn wrong(schema: &Value, value: &Value) -> Vec<String> {
    let mut checker = Checker::new(schema);
    checker.check(value);
    checker.wrong
}

fn json_of(text: &str) -> Value {
    serde_json::to_value(text.parse::<toml::Table>().unwrap()).unwrap()
}

fn toml_of(value: &Value) -> String {
    toml::to_string(value).unwrap()
}

/// A contract that says all that can be said.
const CONTRACT: &str = r#"
[family]
title = "Braking"
source = "section 2"
few_roundings = false

[inputs]
v0 = { name = "speed", unit = "m/s", typical = [0.1, 50.0], doc = "at the start" }

[[kernel]]
name = "way"
doc = "Way."
source = "%o2"
inputs = ["v0"]
domain = ["v0 > 0"]
branch = "+"
few_roundings = true
one_division = true
edges = "none"
returns = "Way"

[[kernel.result]]
name = "way"
worksheet = "wayFn"
unit = "m"

[[kernel.result]]
name = "time"
worksheet = "timeFn"
unit = "s"
"#;

/// What the reader of contracts says of one; nothing if it takes it.
fn contract_error(value: &Value) -> Option<String> {
    let error = contract::parse(Path::new("braking.toml"), &toml_of(value)).err()?;
    let contract::ContractError::Mistakes { mistakes, .. } = error else { panic!("{error}") };
    Some(mistakes.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
}

/// What the reader of `closedform.toml` says of one.
fn project_error(value: &Value) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("closedform.toml"), toml_of(value)).unwrap();
    Project::at(folder.path()).err().map(|error| error.to_string())
}

/// The places of all tables and of all else in a value.
fn places(value: &Value, at: &str, tables: &mut Vec<String>, others: &mut Vec<String>) {
    match value {
        Value::Object(parts) => {
            tables.push(at.to_owned());
            parts.iter().for_each(|(key, part)| places(part, &format!("{at}/{key}"), tables, others));
        }
        Value::Array(parts) => {
            others.push(at.to_owned());
            parts.iter().enumerate().for_each(|(key, part)| places(part, &format!("{at}/{key}"), tables, others));
        }
        _ => others.push(at.to_owned()),
    }
}

/// The value with something else at a place.
fn with(value: &Value, place: &str, other: Value) -> Value {
    let mut changed = value.clone();
    *changed.pointer_mut(place).unwrap() = other;
    changed
}

/// Holds a schema to a reader, by a value that has every key, each with the reader's type: its keys are those that the reader
/// names, the same ones are required, and other types are refused.
fn agree(schema: &Value, full: &Value, error: impl Fn(&Value) -> Option<String>) {
    assert_eq!((wrong(schema, full), error(full)), (Vec::new(), None));
    let (mut tables, mut others) = (Vec::new(), Vec::new());
    places(full, "", &mut tables, &mut others);
    for table in &tables {
        let known: BTreeSet<String> = full.pointer(table).unwrap().as_object().unwrap().keys().cloned().collect();
        let mut more = full.clone();
        more.pointer_mut(table).unwrap()["zzz"] = 1.into();
        assert!(!wrong(schema, &more).is_empty() && error(&more).is_some(), "{table}/zzz");
        if let Some((_, expected)) = error(&more).unwrap().split_once("unknown field `zzz`, expected ") {
            let read: BTreeSet<String> = expected.split('`').skip(1).step_by(2).map(str::to_owned).collect();
            assert_eq!(read, known, "keys of {table}");
        }
        for key in &known {
            let mut less = full.clone();
            less.pointer_mut(table).unwrap().as_object_mut().unwrap().remove(key);
            let (by_schema, by_reader) = (!wrong(schema, &less).is_empty(), error(&less));
            assert!(!by_schema || by_reader.is_some(), "{table}/{key} is required by the schema only");
            let missing = by_reader.is_some_and(|error| error.contains("missing field") || error.contains("has no "));
            assert!(by_schema || !missing, "{table}/{key} is not required by the schema");
        }
    }
    for place in others {
        let text = full.pointer(&place).unwrap().is_string();
        let other = with(full, &place, if text { 7.into() } else { "seven".into() });
        assert!(!wrong(schema, &other).is_empty() && error(&other).is_some(), "{place} of another type");
    }
}

#[test]
fn the_schema_of_contracts_says_what_is_read() {
    let (schema, full) = (schema("contract"), json_of(CONTRACT));
    agree(&schema, &full, contract_error);
    let mut checker = Checker::new(&schema);
    checker.check(&full);
    assert_eq!(checker.met, keys(&schema, "#"), "a key that the contract of this test lacks");
}

#[test]
fn the_schema_of_projects_says_what_is_read() {
    let text = "worksheets = \"a\"\nkernels = \"b\"\nrecords = \"c\"\ntable = \"d.md\"\njudges = false\n\
                [limits]\nmaxima = 1\nkernel = 2\nwait = 3\n";
    let (schema, full) = (schema("project"), json_of(text));
    agree(&schema, &full, project_error);
    let mut checker = Checker::new(&schema);
    checker.check(&full);
    assert_eq!(checker.met, keys(&schema, "#"), "a key that the project of this test lacks");
}

#[test]
fn every_contract_here_is_one_by_the_schema() {
    let schema = schema("contract");
    let mut folders = ["maxima-ref", "codegen/command/example"].map(|folder| repository().join(folder)).to_vec();
    folders.push(repository().join("codegen/command/tests/rules"));
    let files = folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap()).map(|entry| entry.unwrap().path());
    let contracts: Vec<_> = files.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    assert!(contracts.len() > 5, "{contracts:?}");
    for path in contracts {
        let contract = json_of(&fs::read_to_string(&path).unwrap());
        assert_eq!(wrong(&schema, &contract), Vec::<String>::new(), "{}", path.display());
    }
    let project = json_of(&fs::read_to_string(repository().join("closedform.toml")).unwrap());
    assert_eq!(wrong(&self::schema("project"), &project), Vec::<String>::new());
}

#[test]
fn a_new_project_names_its_schemas() {
    let folder = tempfile::tempdir().unwrap();
    succeeds(folder.path(), &["new", "braking"]);
    for file in ["braking/closedform.toml", "braking/maxima-ref/braking.toml"] {
        let path = folder.path().join(file);
        let text = fs::read_to_string(&path).unwrap();
        let named = text.lines().next().and_then(|line| line.strip_prefix("#:schema ")).unwrap();
        let schema = fs::read_to_string(path.parent().unwrap().join(named)).unwrap();
        assert_eq!(wrong(&serde_json::from_str(&schema).unwrap(), &json_of(&text)), Vec::<String>::new(), "{file}");
    }
}

/// What a command writes, whether it finds something wrong or not.
fn output(folder: &Path, arguments: &[&str]) -> Value {
    let output = closedform(folder, arguments);
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|cause| panic!("{arguments:?}: {cause}\n{}", String::from_utf8_lossy(&output.stderr)))
}

/// Holds the schema of an output to what commands write: no value breaks it, and no key of it is in none of them.
fn describes(name: &str, values: &[Value]) {
    let schema = schema(name);
    let mut checker = Checker::new(&schema);
    values.iter().for_each(|value| checker.check(value));
    assert_eq!(checker.wrong, Vec::<String>::new(), "{name}");
    assert_eq!(checker.met, keys(&schema, "#"), "keys of {name} that are never written");
}

#[test]
fn schemas_say_what_is_written_of_kernels() {
    let here = repository();
    describes("list", &[output(&here, &["list", "--json"])]);
    let shown = ["turnaround::t_in", "pvt::turn_out"].map(|kernel| output(&here, &["show", kernel, "--json"]));
    describes("show", &shown);
    let point = ["eval", "pvt::turn_out", "v0=1", "a1=-2", "--json"];
    describes("eval", &[output(&here, &point), output(&here, &[&point[..], &["--digits", "20"]].concat())]);
}

#[test]
fn schemas_say_what_is_written_of_measurements() {
    let here = repository();
    let sampled = output(&here, &["verify", "pvt::turn_out", "--points", "3", "--json"]);
    let searched = output(&here, &["verify", "turnaround::t_in", "--steps", "0", "--json"]);
    describes("verify", &[sampled, searched]);
    let folder = tempfile::tempdir().unwrap();
    succeeds(folder.path(), &["new", "braking"]);
    describes("ledger", &[output(&folder.path().join("braking"), &["ledger", "--json"])]);
}

#[test]
fn the_schema_of_mutants_says_what_is_written() {
    let project = project();
    let arguments = ["mutants", LISTED, "--json"];
    let excused = output(project.path(), &arguments);
    fs::remove_file(project.path().join("tests/EQUIVALENT.toml")).unwrap();
    describes("mutants", &[excused, output(project.path(), &arguments)]);
}

#[test]
fn the_schema_of_plans_says_what_is_written() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("part.nc"), "T1 M6\nG1 X10 F600\nT2 M6\nY5\nM30\n").unwrap();
    let step = ["plan", "step", "--travel", "1e-3", "--v-max", "0.1", "--a-max", "2", "--json", "--table", "table.csv"];
    let milling = ["plan", "milling", "--gcode", "part.nc", "--json"];
    describes("plan", &[output(folder.path(), &step), output(folder.path(), &milling)]);
}

#[test]
fn the_schema_of_tables_says_what_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let plan = ["plan", "step", "--travel", "1e-3", "--v-max", "0.1", "--a-max", "2", "--table", "table.json"];
    succeeds(folder.path(), &plan);
    let table = fs::read_to_string(folder.path().join("table.json")).unwrap();
    describes("table", &[serde_json::from_str(&table).unwrap()]);
}

/// A kernel of which a mutant is the same function for a reason that is listed.
const LISTED: &str = "pvt::arrival_first";
