//! What must hold of any text that is read as a worksheet.

use closedform_maxima::{Statement, parse_statements, print_statement};

/// The text is read or refused, and what was read means the same after it was printed.
pub fn worksheet(text: &str) {
    let Ok(read) = parse_statements(text) else { return };
    let printed: String = read.iter().map(|statement| print_statement(statement) + "\n").collect();
    let again = parse_statements(&printed).unwrap_or_else(|errors| panic!("printed as {printed:?}: {errors}"));
    let expressions = |statements: &[Statement]| -> Vec<_> {
        statements.iter().map(|statement| statement.expression.clone()).collect()
    };
    assert_eq!(expressions(&again), expressions(&read), "printed as {printed:?}");
}
