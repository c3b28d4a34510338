//! Points from text and from files.

use std::path::Path;

use crate::error::{Failure, Outcome};

/// A point from `X,Y` or `X,Y,Z`.
pub fn point(text: &str) -> Result<Vec<f64>, String> {
    let parse = |part: &str| part.trim().parse().map_err(|_| format!("`{part}` is not a number: write a point as X,Y"));
    text.split(',').map(parse).collect()
}

/// The points of a file, one a line; a first line of names is passed over.
pub fn read(path: &Path) -> Outcome<Vec<Vec<f64>>> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::Input(format!("{error}: give a file that can be read")))?;
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let is_name = |field: &str| field.trim().parse::<f64>().is_err();
    let names = |(number, line): &(usize, &str)| *number == 1 && line.split(',').all(is_name);
    let parse = |(number, line)| point(line).map_err(|error| Failure::Input(format!("line {number}: {error}")));
    lines.filter(|line| !names(line)).map(parse).collect()
}
