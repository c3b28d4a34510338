//! Errors as people see them, for tests of their words.

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};

/// Wide enough that no line that is asked for is broken.
const WIDTH: usize = 160;

/// The error with its causes, its place and its remedy, without colours.
pub fn drawn(error: &dyn Diagnostic) -> String {
    let mut drawn = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::none()).with_width(WIDTH);
    handler.render_report(&mut drawn, error).unwrap();
    drawn.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
}

/// The text has all of these words.
#[track_caller]
pub fn has(text: &str, words: &[&str]) {
    for word in words {
        assert!(text.contains(word), "`{word}` is not in\n{text}");
    }
}
