//! `errata/NAME.toml` as TOML spells it, before anything is checked.

use serde::Deserialize;
use toml::Spanned;

use super::judge::Verdict;

/// A text with its place in the file.
pub(super) type Text = Spanned<String>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    #[serde(alias = "scan")]
    pub(super) derivation: Heading,
    #[serde(default)]
    pub(super) output: Vec<Row>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Heading {
    pub(super) title: String,
    pub(super) source: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Row {
    pub(super) cell: Text,
    pub(super) live: Text,
    #[serde(alias = "scan")]
    pub(super) printed: Option<Text>,
    pub(super) verdict: Spanned<Verdict>,
    pub(super) repair: Option<Text>,
    pub(super) reads: Option<Text>,
    pub(super) example: Option<Text>,
    pub(super) error: Option<Text>,
    pub(super) right: Option<Text>,
    #[serde(default)]
    pub(super) proof: Vec<Text>,
    pub(super) shows: Option<[Text; 2]>,
    #[serde(default)]
    pub(super) kernel: Vec<Call>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Call {
    pub(super) call: Text,
    #[serde(default)]
    pub(super) part: Vec<Spanned<usize>>,
}
