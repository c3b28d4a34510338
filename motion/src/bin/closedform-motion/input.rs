//! Inputs of a plan: flags, over those of a TOML file with the same names.

use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{Failure, Outcome};

/// The flags, over what the file says. A name that the file must not have is an error with its line.
pub fn merged<T: Serialize + DeserializeOwned>(flags: &T, file: Option<&Path>) -> Outcome<T> {
    let internal = |error: &dyn std::fmt::Display| Failure(format!("the flags cannot be merged: {error}"));
    let flags = toml::Table::try_from(flags).map_err(|error| internal(&error))?;
    let mut table = match file {
        Some(path) => read::<T>(path)?,
        None => toml::Table::new(),
    };
    table.extend(flags);
    table.try_into().map_err(|error| internal(&error))
}

fn read<T: Serialize + DeserializeOwned>(path: &Path) -> Outcome<toml::Table> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure(format!("{error}: give a file that can be read after --file")).at(path))?;
    // Some editors begin a file with a mark of the order of its bytes.
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let wrong = |error: toml::de::Error| {
        let before = error.span().map_or("", |span| text.get(..span.start).unwrap_or_default());
        let (line, message) = (before.matches('\n').count() + 1, error.message().trim().replace('\n', " "));
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        Failure(format!("line {line}, column {column}: {message}: use the names and values of the flags")).at(path)
    };
    // An alias becomes the name that it stands for.
    let inputs = toml::from_str::<T>(text).map_err(wrong)?;
    toml::Table::try_from(inputs).map_err(|error| Failure(error.to_string()))
}

/// A value that must be there.
pub fn need<T: Copy>(value: Option<T>, name: &str, what: &str) -> Outcome<T> {
    value.ok_or_else(|| {
        Failure(format!("{name} is missing: give {what} as --{name}, or as `{name} = ..` in the file of --file"))
    })
}
