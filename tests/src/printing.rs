//! Maxima text to expression to Maxima text: a fixed point.

use closedform_maxima::{Statement, parse_statements, print_statement};

/// Demands that the text parses, and that what is printed of it means the same and prints the same.
///
/// # Errors
///
/// What does not.
pub fn check_printing(text: &str) -> Result<(), String> {
    let read = parsed(text)?;
    let printed = print(&read);
    let again = parsed(&printed)?;
    if print(&again) != printed {
        return Err(format!("prints as `{printed}`, and then as `{}`", print(&again)));
    }
    let changed = again.iter().zip(&read).find(|(again, read)| again.expression != read.expression);
    match changed {
        Some((again, _)) => Err(format!("printed, it means another thing: `{}`", print_statement(again))),
        None => Ok(()),
    }
}

fn parsed(text: &str) -> Result<Vec<Statement>, String> {
    parse_statements(text).map_err(|errors| errors.to_string())
}

fn print(statements: &[Statement]) -> String {
    statements.iter().map(|statement| print_statement(statement) + "\n").collect()
}
