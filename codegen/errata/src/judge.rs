//! From facts to a verdict, or to what is wrong with the stated one; a pure function.

use std::fmt;

use serde::Deserialize;

use super::contrast::{Contrast, contrast};
use super::facts::{Comparison, Facts, FormFacts, Left, Value};
use super::problem::{Form, Problem};
use super::sheet::Row;

/// What is to be said of a printed output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
pub enum Verdict {
    /// The derivation prints what the cell gives.
    #[serde(rename = "equal")]
    Equal,
    /// It does after the repair of an obvious slip.
    #[serde(rename = "repaired")]
    Repaired,
    /// It does after more than that.
    #[serde(rename = "garbled")]
    Garbled,
    /// The derivation does not show it.
    #[serde(rename = "elided")]
    Elided,
    /// What the cell gives is not true.
    #[serde(rename = "worksheet error")]
    WorksheetError,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Equal, Self::Repaired, Self::Garbled, Self::Elided, Self::WorksheetError];
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Equal => "equal",
            Self::Repaired => "repaired",
            Self::Garbled => "garbled",
            Self::Elided => "elided",
            Self::WorksheetError => "worksheet error",
        })
    }
}

/// A row whose stated verdict is what its facts say.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// What the printed form and the true one are worth at the example, where they differ.
    pub contrast: Option<Contrast>,
    /// What the true form is worth at the example.
    pub values: Vec<Value>,
}

/// How the printed text becomes what the cell gives.
enum Reading {
    /// As it stands.
    Printed,
    /// By a repair, if it has values to compare.
    Misread(Option<Contrast>),
    /// Not at all: the derivation does not show it.
    Elided,
}

/// Compares the stated verdict of a row with its facts.
pub fn judge(row: &Row, facts: &Facts) -> Result<Judged, Problem> {
    if let Some(said) = &facts.live.failed {
        return Err(Problem::Failed { form: Form::Live, said: said.clone() });
    }
    if !facts.bound {
        return Err(Problem::NotReplayed);
    }
    let reading = reading(row, facts)?;
    let error = worksheet_error(row, facts)?;
    let agrees = match (&reading, &error) {
        (_, Some(_)) => row.verdict == Verdict::WorksheetError,
        (Reading::Printed, None) => row.verdict == Verdict::Equal,
        (Reading::Misread(_), None) => matches!(row.verdict, Verdict::Repaired | Verdict::Garbled),
        (Reading::Elided, None) => row.verdict == Verdict::Elided,
    };
    if !agrees {
        return Err(Problem::Stated { stated: row.verdict, found: found(&reading, error.is_some()) });
    }
    let truth = if error.is_some() { &facts.right } else { &facts.live };
    let misread = match reading {
        Reading::Misread(contrast) => contrast,
        Reading::Printed | Reading::Elided => None,
    };
    Ok(Judged { contrast: error.or(misread), values: truth.values.clone().unwrap_or_default() })
}

fn found(reading: &Reading, error: bool) -> &'static str {
    match reading {
        _ if error => "`worksheet error`: it has `error`, `right` and `proof`, and they hold",
        Reading::Printed => "`equal`: the derivation prints what the cell gives, and nothing is said against it",
        Reading::Misread(_) => "`repaired` or `garbled`: after the repair the text is what the cell gives",
        Reading::Elided => "`elided`: there is no `printed`",
    }
}

fn reading(row: &Row, facts: &Facts) -> Result<Reading, Problem> {
    match (&row.printed, &row.repair, &row.reads) {
        (None, Some(_), _) => Err(Problem::Needless("repair", "nothing is printed that it could repair")),
        (Some(_), None, Some(_)) => Err(Problem::Needless("reads", "no `repair` says how the text becomes that")),
        (None, None, None) => {
            Err(Problem::Missing("reads", "a row without `printed` must write out what Maxima gives"))
        }
        (Some(_), Some(_), None) => Err(Problem::Missing("reads", "a repair leads to another text")),
        (None, None, Some(_)) => equal(Form::Reads, &facts.reads, &facts.live).map(|()| Reading::Elided),
        (Some(printed), None, None) => match &printed.form {
            Err(error) => Err(Problem::Unparsable(error.clone())),
            Ok(_) => equal(Form::Printed, &facts.printed, &facts.live).map(|()| Reading::Printed),
        },
        (Some(printed), Some(_), Some(_)) => {
            equal(Form::Reads, &facts.reads, &facts.live)?;
            let contrast = if printed.form.is_ok() { Some(misread(row, facts)?) } else { None };
            Ok(Reading::Misread(contrast))
        }
    }
}

/// Demands that a form is what the cell gives.
fn equal(form: Form, facts: &FormFacts, live: &FormFacts) -> Result<(), Problem> {
    match (&facts.same, &facts.failed) {
        (Some(Comparison::Equal), _) => same_branch(form, facts, live),
        (Some(Comparison::Entries { found, live }), _) => Err(Problem::Entries { form, found: *found, live: *live }),
        (Some(Comparison::Entry { entry, left }), _) => {
            Err(Problem::Differs { form, entry: *entry, left: left.clone() })
        }
        (None, said) => Err(Problem::Failed { form, said: said.clone().unwrap_or_default() }),
    }
}

/// Demands that forms that simplify to the same have the same values: a root may have been taken with the other sign.
fn same_branch(form: Form, facts: &FormFacts, live: &FormFacts) -> Result<(), Problem> {
    let (Some(values), Some(live)) = (&facts.values, &live.values) else { return Ok(()) };
    match contrast(values, live) {
        Ok(Some(_)) => Err(Problem::OtherBranch { form }),
        _ => Ok(()),
    }
}

/// Demands that a printed text that parses is worth something else than the repaired one.
fn misread(row: &Row, facts: &Facts) -> Result<Contrast, Problem> {
    if facts.printed.same == Some(Comparison::Equal) {
        return Err(Problem::NothingToRepair);
    }
    let (printed, repaired) = (values(row, Form::Printed, &facts.printed)?, values(row, Form::Reads, &facts.reads)?);
    contrast(printed, repaired)?.ok_or(Problem::SameValue { printed: Form::Printed, other: Form::Reads })
}

/// What a cell that is not true is worth, and what the right form is worth; `None` where the row claims no error.
fn worksheet_error(row: &Row, facts: &Facts) -> Result<Option<Contrast>, Problem> {
    let claims = row.error.is_some() || row.right.is_some() || !row.proof.is_empty() || row.shows.is_some();
    if !claims && row.verdict != Verdict::WorksheetError {
        return Ok(None);
    }
    let missing = |key, why| Err(Problem::Missing(key, why));
    match row {
        _ if row.error.is_none() => return missing("error", "a worksheet error says why the cell is not true"),
        _ if row.right.is_none() => return missing("right", "a worksheet error says what is true instead"),
        _ if row.proof.is_empty() => return missing("proof", "the right form must satisfy its defining equations"),
        _ => (),
    }
    if let Some(said) = &facts.right.failed {
        return Err(Problem::Failed { form: Form::Right, said: said.clone() });
    }
    proved(row, facts)?;
    let (forms, facts) = match &row.shows {
        Some(_) => ([Form::Shown(0), Form::Shown(1)], [&facts.shows[0], &facts.shows[1]]),
        None => ([Form::Live, Form::Right], [&facts.live, &facts.right]),
    };
    let (wrong, right) = (values(row, forms[0], facts[0])?, values(row, forms[1], facts[1])?);
    let contrast = contrast(wrong, right)?;
    contrast.map(Some).ok_or(Problem::SameValue { printed: forms[0], other: forms[1] })
}

/// Demands that every term of the proof is 0.
fn proved(row: &Row, facts: &Facts) -> Result<(), Problem> {
    for number in 0..row.proof.len() {
        match facts.proof.get(number) {
            Some(Left::Zero) => (),
            Some(Left::Term(left)) => return Err(Problem::Unproved { number, left: left.clone() }),
            Some(Left::Failed(said)) => return Err(Problem::Failed { form: Form::Proof(number), said: said.clone() }),
            None => return Err(Problem::Failed { form: Form::Proof(number), said: String::new() }),
        }
    }
    Ok(())
}

/// The values of a form at the example.
fn values<'a>(row: &Row, form: Form, facts: &'a FormFacts) -> Result<&'a [Value], Problem> {
    match (&row.example, &facts.values) {
        (None, _) => Err(Problem::Missing("example", "only an example shows that two forms differ")),
        (Some(_), Some(values)) => Ok(values),
        (Some(_), None) => Err(Problem::Failed { form, said: facts.failed.clone().unwrap_or_default() }),
    }
}
