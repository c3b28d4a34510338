//! What is wrong with a verdict: found, where, and what to do.

use std::fmt;
use std::ops::Range;

use thiserror::Error;

use super::formula::FormulaError;
use super::judge::Verdict;
use super::sheet::Row;

/// How much of a long expression is told.
const SHOWN: usize = 240;

/// A form of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// What the cell gives.
    Live,
    /// What is printed.
    Printed,
    /// What is meant.
    Reads,
    /// What is true.
    Right,
    /// A term of the proof.
    Proof(usize),
    /// One of the two forms to be shown.
    Shown(usize),
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Live => f.write_str("`live`"),
            Self::Printed => f.write_str("`printed`"),
            Self::Reads => f.write_str("`reads`"),
            Self::Right => f.write_str("`right`"),
            Self::Proof(number) => write!(f, "term {} of `proof`", number + 1),
            Self::Shown(number) => write!(f, "form {} of `shows`", number + 1),
        }
    }
}

/// Why the stated verdict of a row does not stand.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Problem {
    /// The facts say another verdict.
    #[error("the verdict is stated as `{stated}`, but the facts say {found}")]
    Stated {
        /// What is stated.
        stated: Verdict,
        /// What is found.
        found: &'static str,
    },
    /// The printed text does not parse, and no repair is named.
    #[error("what is printed does not parse, and no repair is named: {0}")]
    Unparsable(FormulaError),
    /// A form is not what the cell gives.
    #[error("{form} is not shown to be what the cell gives: the difference in entry {entry} is {}", short(left))]
    Differs {
        /// The form.
        form: Form,
        /// The entry, from 1.
        entry: usize,
        /// What is left of the difference.
        left: String,
    },
    /// A form has more or fewer entries than the cell gives.
    #[error("{form} has {found} entries, but the cell gives {live}")]
    Entries {
        /// The form.
        form: Form,
        /// Its entries.
        found: usize,
        /// Those of the cell.
        live: usize,
    },
    /// A form agrees with what the cell gives, but has another value.
    #[error("{form} and `live` agree after simplification, but not at the example")]
    OtherBranch {
        /// The form.
        form: Form,
    },
    /// A repair of what is right as it is.
    #[error("a repair is named, but the form as printed is what the cell gives")]
    NothingToRepair,
    /// Two forms that should differ do not.
    #[error("{printed} and {other} have the same value at the example")]
    SameValue {
        /// The form that should be wrong.
        printed: Form,
        /// The form that is right.
        other: Form,
    },
    /// A term of the proof is not 0.
    #[error("term {} of the proof is not 0: {} is left", number + 1, short(left))]
    Unproved {
        /// Its position.
        number: usize,
        /// What is left.
        left: String,
    },
    /// A key that is needed.
    #[error("`{0}` is missing: {1}")]
    Missing(&'static str, &'static str),
    /// A key that has no place here.
    #[error("`{0}` has no place in this row: {1}")]
    Needless(&'static str, &'static str),
    /// An example that leaves symbols.
    #[error("the example leaves no number, but {}", short(.0))]
    NoNumber(String),
    /// An example at which digits do not settle.
    #[error("the digits at the example do not settle")]
    Unstable,
    /// What should come from the replay does not.
    #[error("`live` names nothing that the replay binds")]
    NotReplayed,
    /// Maxima stopped.
    #[error("Maxima cannot work out {form}: {}", if said.is_empty() { "it gives no reason" } else { said })]
    Failed {
        /// The form.
        form: Form,
        /// What it said.
        said: String,
    },
}

impl Problem {
    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Stated { .. } => "state the verdict that is found, or give what the stated one needs",
            Self::Unparsable(_) => {
                "correct the transcription; if the derivation prints it so, name the `repair` and what it `reads`"
            }
            Self::Differs { form: Form::Printed, .. } | Self::Entries { form: Form::Printed, .. } => {
                "correct the transcription; if the derivation prints it so, name the `repair`, what it `reads`, and an `example`"
            }
            Self::Differs { .. } | Self::Entries { .. } => {
                "correct `reads`, or `live`; if they are equal only under a condition, assume it in the replay"
            }
            Self::OtherBranch { .. } => {
                "a root is taken in another branch: choose an example in the physical domain, or correct it"
            }
            Self::NothingToRepair => "remove `repair` and `reads`",
            Self::SameValue { .. } => "choose an example at which they differ, or `shows` what differs",
            Self::Unproved { .. } => "correct `right` or its proof",
            Self::Missing(..) => "add it; book/src/errata.md has the keys of each verdict",
            Self::Needless(..) => "remove it, or add what belongs to it",
            Self::NoNumber(_) => "give every symbol a number in `example`, or let `shows` pick what has a number",
            Self::Unstable => "choose another example",
            Self::NotReplayed => "bind the output in the replay, and name it in `live`",
            Self::Failed { .. } => "correct it; try it in Maxima after batch(\"NAME.mac\")",
        }
    }

    /// The place in the file that it is about.
    pub(super) fn place(&self, row: &Row) -> Range<usize> {
        let place = match self {
            Self::Differs { form, .. } | Self::Entries { form, .. } | Self::Failed { form, .. } => place(*form, row),
            Self::OtherBranch { form } => place(*form, row),
            Self::Unparsable(_) | Self::NothingToRepair => place(Form::Printed, row),
            Self::SameValue { .. } | Self::NoNumber(_) | Self::Unstable => {
                row.example.as_ref().map(|example| example.place.clone())
            }
            Self::Unproved { number, .. } => place(Form::Proof(*number), row),
            Self::NotReplayed => place(Form::Live, row),
            Self::Stated { .. } | Self::Missing(..) | Self::Needless(..) => None,
        };
        place.unwrap_or(row.place.clone())
    }
}

fn place(form: Form, row: &Row) -> Option<Range<usize>> {
    let formula = match form {
        Form::Printed => return row.printed.as_ref().map(|printed| printed.place.clone()),
        Form::Live => Some(&row.live),
        Form::Reads => row.reads.as_ref(),
        Form::Right => row.right.as_ref(),
        Form::Proof(number) => row.proof.get(number),
        Form::Shown(number) => row.shows.as_ref().and_then(|shows| shows.get(number)),
    };
    formula.map(|formula| formula.place.clone())
}

fn short(text: &str) -> String {
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}
