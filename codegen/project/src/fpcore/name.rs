//! Names that Maxima reads as names, and formats whose numbers are real ones.

use closedform_maxima::{Expr, ExprKind, parse_expression, print};

use super::mistake::CoreMistake;
use super::read::Node;
use crate::expression::remedy_of_constant;

/// Formats whose numbers are real ones, and so are what a formula in them means.
const FORMATS: [&str; 6] = ["real", "binary16", "binary32", "binary64", "binary80", "binary128"];

/// How many letters are put behind a name at most.
const LONGEST_ENDING: usize = 3;

/// The name, or one near it where Maxima reads something else.
pub(super) fn maxima_name(name: &str) -> String {
    let mut maxima = name.to_owned();
    let is_free = |maxima: &str| {
        let symbol = Expr::from(ExprKind::Symbol(maxima.to_owned()));
        let constant =
            maxima.starts_with('%') || remedy_of_constant(maxima).is_some() || ["true", "false"].contains(&maxima);
        !constant && parse_expression(&print(&symbol)) == Ok(symbol)
    };
    while !is_free(&maxima) && maxima.len() < name.len() + LONGEST_ENDING {
        maxima.push('_');
    }
    maxima
}

/// Refuses formats whose numbers are no real ones, among properties.
pub(super) fn formats(properties: &[Node]) -> Result<(), CoreMistake> {
    properties.chunks_exact(2).try_for_each(|pair| format(&pair[0], &pair[1]))
}

/// Refuses a format whose numbers are no real ones, if the property names one.
pub(super) fn format(key: &Node, value: &Node) -> Result<(), CoreMistake> {
    if key.atom() != Some(":precision") || value.atom().is_some_and(|format| FORMATS.contains(&format)) {
        return Ok(());
    }
    let remedy = format!("known are {}; kernels compute the real function", FORMATS.join(", "));
    Err(CoreMistake::new("a format that is not for real numbers", remedy, value.span.clone()))
}
