//! How long to search: so many evaluations, or until a point in time.

use std::time::{Duration, Instant};

/// How often the clock is looked at, in evaluations.
const BETWEEN_LOOKS: u64 = 64;

/// What one search may spend.
#[derive(Clone, Copy, Debug)]
pub enum Budget {
    /// Evaluations for each result: the same search for the same seed.
    Steps(u64),
    /// Wall time for all results.
    Time(Duration),
}

/// What is left of a budget.
#[derive(Clone, Debug)]
pub(super) struct Allowance {
    spent: u64,
    empty: bool,
    limit: Limit,
}

#[derive(Clone, Copy, Debug)]
enum Limit {
    Steps(u64),
    Until(Instant),
}

impl Budget {
    /// The budget of the next of `left` results, from the same start.
    pub(super) fn allowance(self, begin: Instant, left: usize) -> Allowance {
        let limit = match self {
            Budget::Steps(steps) => Limit::Steps(steps),
            Budget::Time(time) => {
                let share = time.saturating_sub(begin.elapsed()) / left.max(1) as u32;
                Limit::Until(Instant::now() + share)
            }
        };
        Allowance { spent: 0, empty: false, limit }
    }
}

impl Allowance {
    /// Pays for one evaluation; false when nothing is left, and ever after.
    pub(super) fn pay(&mut self) -> bool {
        self.empty = self.empty
            || match self.limit {
                Limit::Steps(steps) => self.spent >= steps,
                Limit::Until(end) => self.spent.is_multiple_of(BETWEEN_LOOKS) && Instant::now() >= end,
            };
        self.spent += u64::from(!self.empty);
        !self.empty
    }

    /// How many evaluations were paid for.
    pub(super) fn spent(&self) -> u64 {
        self.spent
    }
}

/// A duration as people write it: `60s`, `2min`, `90`.
///
/// # Errors
///
/// What is expected instead.
pub fn parse_duration(text: &str) -> Result<Duration, String> {
    let split = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let (number, unit) = text.split_at(split);
    let seconds = match unit.trim() {
        "" | "s" => 1.0,
        "m" | "min" => 60.0,
        "h" => 3600.0,
        _ => return Err(format!("`{unit}` is no unit of time: write s, min or h, such as 60s")),
    };
    let number: f64 = number.parse().map_err(|_| "write a number and a unit, such as 60s or 2min".to_owned())?;
    Duration::try_from_secs_f64(number * seconds).map_err(|_| "that is too long".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_read_as_people_write_them() {
        for (text, seconds) in [("60s", 60.0), ("2min", 120.0), ("0.5m", 30.0), ("90", 90.0), ("1h", 3600.0)] {
            assert_eq!(parse_duration(text), Ok(Duration::from_secs_f64(seconds)), "{text}");
        }
        for text in ["", "s", "-1s", "1 week", "1e99999h", "1..2s"] {
            assert!(parse_duration(text).is_err(), "{text}");
        }
    }

    #[test]
    fn what_is_spent_stays_spent() {
        let mut allowance = Budget::Steps(3).allowance(Instant::now(), 1);
        assert_eq!([(); 5].map(|()| allowance.pay()), [true, true, true, false, false]);
        assert_eq!(allowance.spent(), 3);
        let mut allowance = Budget::Time(Duration::ZERO).allowance(Instant::now(), 1);
        assert!((0..2 * BETWEEN_LOOKS).all(|_| !allowance.pay()));
    }
}
