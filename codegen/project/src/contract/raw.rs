//! A contract as TOML spells it, before anything is checked.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Contract {
    pub(super) family: Family,
    #[serde(default)]
    pub(super) inputs: BTreeMap<Spanned<String>, Input>,
    #[serde(default)]
    pub(super) kernel: Vec<Spanned<Kernel>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Family {
    pub(super) title: Spanned<String>,
    #[serde(default)]
    pub(super) source: String,
    #[serde(default = "yes")]
    pub(super) few_roundings: bool,
}

fn yes() -> bool {
    true
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Input {
    pub(super) name: Spanned<String>,
    pub(super) unit: Spanned<String>,
    pub(super) typical: Option<Spanned<[f64; 2]>>,
    #[serde(default)]
    pub(super) doc: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Kernel {
    pub(super) name: Spanned<String>,
    pub(super) doc: String,
    #[serde(default)]
    pub(super) source: String,
    pub(super) inputs: Spanned<Vec<Spanned<String>>>,
    #[serde(default)]
    pub(super) domain: Vec<Spanned<String>>,
    pub(super) branch: Option<String>,
    pub(super) few_roundings: Option<bool>,
    #[serde(default)]
    pub(super) one_division: bool,
    pub(super) edges: Option<String>,
    pub(super) returns: Option<Spanned<String>>,
    #[serde(default)]
    pub(super) result: Vec<Result>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Result {
    pub(super) name: Spanned<String>,
    pub(super) worksheet: Spanned<String>,
    pub(super) unit: Spanned<String>,
}
