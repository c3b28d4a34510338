//! Two forms at the same example: the first entry where they are worth something else, and how bad that is.

use std::cmp::Ordering;

use super::facts::Value;
use super::problem::Problem;

/// Numbers that agree in so many digits are no evidence of a difference.
const TOLERANCE: f64 = 1e-12;

/// Where two forms differ.
#[derive(Debug, Clone, PartialEq)]
pub enum Contrast {
    /// In the value of an entry.
    Values {
        /// Which of how many, from 1.
        entry: (usize, usize),
        /// What it is worth.
        wrong: Value,
        /// What it should be worth.
        right: Value,
    },
    /// In the number of entries.
    Entries {
        /// Those that are there.
        wrong: usize,
        /// Those that should be.
        right: usize,
    },
}

impl Contrast {
    /// How wrong it is, the worst first: what does not exist, then a flipped sign, then the relative difference.
    pub fn compare_badness(&self, other: &Self) -> Ordering {
        let ((class, difference), (other_class, other_difference)) = (self.badness(), other.badness());
        class.cmp(&other_class).then(other_difference.total_cmp(&difference))
    }

    /// The relative difference of two numbers.
    pub fn relative(&self) -> Option<f64> {
        match self {
            Self::Values { wrong: Value::Number(wrong), right: Value::Number(right), .. } => {
                Some(((wrong - right) / right).abs())
            }
            _ => None,
        }
    }

    fn badness(&self) -> (u8, f64) {
        match (self, self.relative()) {
            (Self::Values { wrong: Value::Number(wrong), right: Value::Number(right), .. }, Some(relative)) => {
                (if wrong * right < 0.0 { 1 } else { 2 }, relative)
            }
            (Self::Values { .. }, _) => (0, f64::INFINITY),
            (Self::Entries { .. }, _) => (3, 0.0),
        }
    }
}

/// The first entry in which the forms differ; `None` where they do not.
///
/// # Errors
///
/// When it takes a value to decide that the example does not give.
pub fn contrast(wrong: &[Value], right: &[Value]) -> Result<Option<Contrast>, Problem> {
    if wrong.len() != right.len() {
        return Ok(Some(Contrast::Entries { wrong: wrong.len(), right: right.len() }));
    }
    for (position, (one, other)) in wrong.iter().zip(right).enumerate() {
        if differ(one, other)? {
            let entry = (position + 1, right.len());
            return Ok(Some(Contrast::Values { entry, wrong: one.clone(), right: other.clone() }));
        }
    }
    Ok(None)
}

fn differ(one: &Value, other: &Value) -> Result<bool, Problem> {
    match (one, other) {
        (Value::Symbols(left), _) | (_, Value::Symbols(left)) => Err(Problem::NoNumber(left.clone())),
        (Value::Unstable, _) | (_, Value::Unstable) => Err(Problem::Unstable),
        (Value::Number(one), Value::Number(other)) => Ok((one - other).abs() > TOLERANCE * one.abs().max(other.abs())),
        (Value::Number(_), _) | (_, Value::Number(_)) => Ok(true),
        _ => Ok(false),
    }
}
