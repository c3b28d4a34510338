//! Every error as a reader sees it: cause, caret, remedy.

use closedform_maxima::definitions;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, Report};

/// The report on `text`, drawn without colours.
fn report(text: &str, error: impl Diagnostic + Send + Sync + 'static) -> String {
    let report = Report::new(error).with_source_code(NamedSource::new("sheet.mac", text.to_owned()));
    let mut drawn = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::none()).with_width(120);
    handler.render_report(&mut drawn, report.as_ref()).expect("strings take everything");
    drawn.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
}

/// Every case of the file: a text, `----`, its report; cases are parted by a line of `====`.
///
/// With `UPDATE=1` in the environment the file is written instead of compared.
#[test]
fn messages_point_at_the_mistake() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/messages.txt");
    let golden = std::fs::read_to_string(path).expect("messages.txt is there");
    let actual: Vec<String> = golden
        .split("====\n")
        .map(|case| {
            let text = case.split_once("----\n").expect("a text and its report").0;
            let errors = definitions(text).expect_err(text);
            format!("{text}----\n{}\n", report(text, errors).trim_matches('\n'))
        })
        .collect();
    let actual = actual.join("====\n");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path, &actual).expect("messages.txt can be written");
    }
    assert!(actual == golden || std::env::var_os("UPDATE").is_some(), "messages changed:\n{actual}");
}
