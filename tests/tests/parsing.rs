//! Maxima text to expression to Maxima text: a fixed point.

use closedform_maxima::{Statement, parse_statements, print_statement};
use closedform_tests::worksheets;

#[test]
fn references_survive_printing() {
    survives("ref");
}

#[test]
fn worksheets_survive_printing() {
    survives("mac");
}

/// Every file of this kind parses, and the text that is printed means the same and prints the same.
fn survives(extension: &str) {
    let families = worksheets::families(extension);
    assert!(!families.is_empty(), "no files *.{extension}");
    for family in families {
        let read = parsed(&family, &worksheets::read(&family, extension));
        let printed = text(&read);
        let again = parsed(&family, &printed);
        assert_eq!(text(&again), printed, "{family}.{extension}");
        for (again, read) in again.iter().zip(&read) {
            assert_eq!(again.expression, read.expression, "{family}.{extension}");
        }
    }
}

fn parsed(family: &str, text: &str) -> Vec<Statement> {
    parse_statements(text).unwrap_or_else(|errors| panic!("{family}: {errors}"))
}

fn text(statements: &[Statement]) -> String {
    statements.iter().map(|statement| print_statement(statement) + "\n").collect()
}
