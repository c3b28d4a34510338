//! The question: Maxima statements that make a replayed derivation tell the facts of all its rows in one run.

use closedform_maxima::{Expr, print};

use super::formula::{self, Formula};
use super::sheet::Row;
use closedform_project::derive::VALUES;

/// Functions that find facts.
const FACTS: &str = include_str!("facts.mac");

/// Statements that say the facts of every row. The first message says that the replay came to its end: what is printed
/// before it is the replay's own.
pub(super) fn driver(rows: &[Row]) -> String {
    let mut driver = format!("closedform_say(\"replayed\")$\n{VALUES}{FACTS}");
    rows.iter().enumerate().for_each(|(index, row)| driver += &question(index, row));
    driver
}

fn question(index: usize, row: &Row) -> String {
    let printed = row.printed.as_ref().and_then(|printed| printed.form.as_ref().ok());
    let reads = row.reads.as_ref().map(|form| &form.expression);
    let right = row.right.as_ref().map(|form| &form.expression);
    let mut text = replayed(index, row);
    for (key, form) in [("live", Some(&row.live.expression)), ("printed", printed), ("reads", reads), ("right", right)]
    {
        text += &match form {
            Some(form) => format!("closedform_{key}: closedform_form(\"{index}|{key}\", errcatch({}))$\n", print(form)),
            None => format!("closedform_{key}: []$\n"),
        };
    }
    for key in ["printed", "reads"] {
        text += &format!("closedform_compare(\"{index}|{key}|same\", closedform_{key}, closedform_live)$\n");
    }
    for key in ["live", "printed", "reads", "right"] {
        text += &values(index, key, &format!("closedform_{key}"), row);
    }
    text + about_right(index, row).as_str()
}

/// Whether what the cell gives is made of something that the replay binds.
fn replayed(index: usize, row: &Row) -> String {
    let names: Vec<String> = formula::names(&row.live.expression).iter().map(|name| format!("'{name}")).collect();
    let names = names.join(", ");
    format!(
        "if not disjointp(setify([{names}]), setify(closedform_bound)) then closedform_say(\"{index}|live|bound\")$\n"
    )
}

fn values(index: usize, key: &str, form: &str, row: &Row) -> String {
    match &row.example {
        Some(_) => format!("closedform_evaluate(\"{index}|{key}|at\", {form}, {})$\n", example(row)),
        None => String::new(),
    }
}

/// The symbols of the example and their numbers, as two lists; empty ones where there is none.
fn example(row: &Row) -> String {
    let numbers = row.example.iter().flat_map(|example| &example.numbers);
    let (symbols, numbers): (Vec<String>, Vec<String>) =
        numbers.map(|(symbol, number)| (format!("'{symbol}"), print(number))).unzip();
    format!("[{}], [{}]", symbols.join(", "), numbers.join(", "))
}

/// What is asked over `live`, `reads` and `right`.
fn about_right(index: usize, row: &Row) -> String {
    let bound = |statement: String| {
        let names = ["live", "reads", "right"].map(|name| format!("{name}: closedform_only(closedform_{name})"));
        format!("block([{}], {})$\n", names.join(", "), statement.trim_end_matches(['$', '\n']))
    };
    let caught = |expression: &Expr| format!("errcatch({})", print(expression));
    let proof = |(number, proof): (usize, &Formula)| {
        format!("closedform_prove(\"{index}|proof {number}\", {}, {})", caught(&proof.expression), example(row))
    };
    let shows = |(number, shown): (usize, &Formula)| {
        let key = format!("shows {number}");
        let form = format!("closedform_form(\"{index}|{key}\", {})", caught(&shown.expression));
        values(index, &key, &form, row)
    };
    let proofs = row.proof.iter().enumerate().map(proof);
    let shown = row.shows.iter().flatten().enumerate().map(shows).filter(|statement| !statement.is_empty());
    proofs.chain(shown).map(bound).collect()
}
