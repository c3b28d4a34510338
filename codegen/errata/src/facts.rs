//! Facts of a row, as Maxima tells them.

use closedform_project::maxima_process::Message;

/// What is known of one row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Facts {
    /// Whether what the cell gives is made of a name that the replay binds.
    pub bound: bool,
    /// What the cell gives.
    pub live: FormFacts,
    /// The printed form.
    pub printed: FormFacts,
    /// The repaired form, or the one that the derivation does not show.
    pub reads: FormFacts,
    /// The right form.
    pub right: FormFacts,
    /// The two forms to be shown.
    pub shows: [FormFacts; 2],
    /// What the terms of the proof leave.
    pub proof: Vec<Left>,
}

/// What is known of one form; nothing where it was not asked.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FormFacts {
    /// What Maxima said when the form or a fact of it failed.
    pub failed: Option<String>,
    /// How it compares with what the cell gives.
    pub same: Option<Comparison>,
    /// The values of its entries at the example.
    pub values: Option<Vec<Value>>,
}

/// How a form compares with what the cell gives.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Comparison {
    /// They agree exactly.
    Equal,
    /// They have different numbers of entries.
    Entries {
        /// Those of the form.
        found: usize,
        /// Those of the cell.
        live: usize,
    },
    /// An entry could not be shown to agree.
    Entry {
        /// Which, from 1.
        entry: usize,
        /// What is left of the difference.
        left: String,
    },
}

/// What is left of a term of a proof.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Left {
    /// Nothing: it is 0.
    Zero,
    /// This.
    Term(String),
    /// Maxima stopped.
    Failed(String),
}

/// The value of an entry at an example.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A real number.
    Number(f64),
    /// A number that is not real.
    NotReal,
    /// A division by zero.
    Nothing,
    /// Symbols are left.
    Symbols(String),
    /// The digits do not settle.
    Unstable,
}

impl Facts {
    /// Sorts messages into the facts of so many rows; a message names its row and its subject.
    pub(super) fn read(messages: &[Message], rows: usize) -> Vec<Self> {
        let mut facts = vec![Self::default(); rows];
        for message in messages {
            let words: Vec<&str> = message.text.split('|').collect();
            let [row, subject, rest @ ..] = &words[..] else { continue };
            let Some(facts) = row.parse::<usize>().ok().and_then(|row| facts.get_mut(row)) else { continue };
            facts.take(subject, rest, message.noise.join(" "));
        }
        facts
    }

    fn take(&mut self, subject: &str, words: &[&str], noise: String) {
        match subject.split_once(' ') {
            Some(("proof", _)) => self.proof.push(left(words, noise)),
            Some(("shows", number)) => {
                let number = usize::from(number != "0");
                self.shows[number].take(words, noise);
            }
            _ => match (subject, words) {
                ("live", ["bound"]) => self.bound = true,
                ("live", _) => self.live.take(words, noise),
                ("printed", _) => self.printed.take(words, noise),
                ("reads", _) => self.reads.take(words, noise),
                ("right", _) => self.right.take(words, noise),
                _ => (),
            },
        }
    }
}

impl FormFacts {
    fn take(&mut self, words: &[&str], noise: String) {
        match words {
            [.., "failed"] => self.failed = Some(noise),
            ["same", "equal"] => self.same = Some(Comparison::Equal),
            ["same", "entries", found, live] => {
                let number = |word: &str| word.parse().unwrap_or_default();
                self.same = Some(Comparison::Entries { found: number(found), live: number(live) });
            }
            ["same", "entry", entry, left @ ..] => {
                let entry = entry.parse().unwrap_or_default();
                self.same = Some(Comparison::Entry { entry, left: left.join("|") });
            }
            ["at", "values", values @ ..] => {
                self.values = Some(values.iter().map(|value| self::value(value)).collect())
            }
            _ => (),
        }
    }
}

fn left(words: &[&str], noise: String) -> Left {
    match words {
        ["zero"] => Left::Zero,
        ["left", term @ ..] => Left::Term(term.join("|")),
        _ => Left::Failed(noise),
    }
}

fn value(text: &str) -> Value {
    match (text.strip_prefix('='), text) {
        (Some(number), _) => number.replace('b', "e").parse().map_or(Value::Unstable, Value::Number),
        (None, "complex") => Value::NotReal,
        (None, "none") => Value::Nothing,
        (None, "unstable") => Value::Unstable,
        (None, other) => Value::Symbols(other.strip_prefix("symbols ").unwrap_or(other).to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_sorted() {
        let said = [
            "replayed",
            "0|live|bound",
            "0|printed|same|entry|2|a|b",
            "0|printed|at|values|=1.5b-3|complex|none|symbols x",
            "0|proof 0|zero",
            "0|proof 1|left|x-1",
            "1|reads|same|entries|1|2",
            "1|shows 1|at|values|=0",
            "1|right|failed",
        ];
        let message = |text: &&str| Message { text: (*text).to_owned(), noise: vec!["oh".to_owned()] };
        let facts = Facts::read(&said.iter().map(message).collect::<Vec<_>>(), 2);
        assert!(facts[0].bound && !facts[1].bound);
        assert_eq!(facts[0].printed.same, Some(Comparison::Entry { entry: 2, left: "a|b".to_owned() }));
        let values = [Value::Number(1.5e-3), Value::NotReal, Value::Nothing, Value::Symbols("x".to_owned())];
        assert_eq!(facts[0].printed.values.as_deref(), Some(&values[..]));
        assert_eq!(facts[0].proof, [Left::Zero, Left::Term("x-1".to_owned())]);
        assert_eq!(facts[1].reads.same, Some(Comparison::Entries { found: 1, live: 2 }));
        assert_eq!(facts[1].shows[1].values, Some(vec![Value::Number(0.0)]));
        assert_eq!(facts[1].right.failed, Some("oh".to_owned()));
    }
}
