//! The columns of a table: their names and units, and what a row has in them.

use super::numbers::number;
use super::{Heading, Row, TableError, Timing};
use crate::motion::Knot;
use crate::segment::State;

const TIME: (&str, &str) = ("time", "s");
const DURATION: (&str, &str) = ("duration", "s");
const POSITION: (&str, &str) = ("position", "m");
const VELOCITY: (&str, &str) = ("velocity", "m/s");

/// Name and unit of every column.
pub(super) fn columns(heading: &Heading) -> Vec<(String, &'static str)> {
    let (name, unit) = match heading.timing {
        Timing::Absolute => TIME,
        Timing::Duration => DURATION,
    };
    let of_axis = |axis: &String| [POSITION, VELOCITY].map(|(what, unit)| (format!("{axis} {what}"), unit));
    std::iter::once((name.to_owned(), unit)).chain(heading.axes.iter().flat_map(of_axis)).collect()
}

/// A column as its header says it.
pub(super) fn title((name, unit): &(String, &str)) -> String {
    format!("{name} [{unit}]")
}

/// What a header says, the inverse of [`columns`] and [`title`].
pub(super) fn heading<'a>(titles: impl Iterator<Item = &'a str>) -> Result<Heading, TableError> {
    let titles: Vec<&str> = titles.map(str::trim).collect();
    let wrong = |index: usize| TableError::Header {
        column: index + 1,
        found: titles.get(index).copied().unwrap_or_default().to_owned(),
    };
    let first = titles.first().copied().unwrap_or_default();
    let named = |(name, unit): (&str, &str)| title(&(name.to_owned(), unit)) == first;
    let timing = match (named(TIME), named(DURATION)) {
        (true, _) => Timing::Absolute,
        (_, true) => Timing::Duration,
        _ => return Err(wrong(0)),
    };
    let name = titles.iter().skip(1).step_by(2).enumerate();
    let name = name.map(|(axis, text)| text.strip_suffix(" position [m]").ok_or_else(|| wrong(1 + 2 * axis)));
    let axes = name.map(|name| name.map(str::to_owned)).collect::<Result<Vec<String>, _>>()?;
    let heading = Heading { axes, timing };
    let expected: Vec<String> = columns(&heading).iter().map(title).collect();
    let longest = expected.len().max(titles.len());
    let differs = |index: &usize| expected.get(*index).map(String::as_str) != titles.get(*index).copied();
    if let Some(index) = (0..longest).find(differs) {
        return Err(wrong(index));
    }
    check(&heading)?;
    Ok(heading)
}

/// Whether a reader can tell the axes apart.
pub(super) fn check(heading: &Heading) -> Result<(), TableError> {
    let axes = &heading.axes;
    let bad = |(index, name): &(usize, &String)| {
        name.trim() != name.as_str() || name.is_empty() || axes[..*index].contains(name)
    };
    match axes.iter().enumerate().find(bad) {
        Some((index, name)) => Err(TableError::Header { column: 2 + 2 * index, found: name.clone() }),
        None => Ok(()),
    }
}

/// Makes the numbers of each row: checks them, and tells durations from times.
pub(super) struct Rows<'a> {
    heading: &'a Heading,
    columns: Vec<(String, &'static str)>,
    row: u64,
    /// The time of the row before, as a reader has it who adds durations.
    before: Option<f64>,
}

impl<'a> Rows<'a> {
    pub(super) fn new(heading: &'a Heading) -> Self {
        Self { heading, columns: columns(heading), row: 0, before: None }
    }

    /// How many rows there were.
    pub(super) fn count(&self) -> u64 {
        self.row
    }

    /// The numbers of a row.
    pub(super) fn numbers(&mut self, Row { knot, duration }: &Row) -> Result<Vec<f64>, TableError> {
        let time = match (self.advance(knot.time)?, duration) {
            (_, Some(own)) if self.heading.timing == Timing::Duration => *own,
            (time, _) => time,
        };
        let states = knot.states.iter().flat_map(|state| [state.position, state.velocity]);
        let numbers: Vec<f64> = std::iter::once(time).chain(states).collect();
        self.check(&numbers)?;
        Ok(numbers)
    }

    /// The knot that the fields of a row say, with no accelerations.
    pub(super) fn knot<'f>(&mut self, fields: impl Iterator<Item = &'f str>) -> Result<Knot, TableError> {
        let numbers = self.parse(fields)?;
        let time = match self.heading.timing {
            Timing::Absolute => numbers[0],
            Timing::Duration => self.before.map_or(numbers[0], |before| before + numbers[0]),
        };
        self.advance(time)?;
        self.check(&numbers)?;
        let state = |pair: &[f64]| State::cruise(pair[0], pair[1]);
        Ok(Knot { time, states: numbers[1..].chunks_exact(2).map(state).collect() })
    }

    fn parse<'f>(&self, fields: impl Iterator<Item = &'f str>) -> Result<Vec<f64>, TableError> {
        let row = self.row + 1;
        let fields: Vec<&str> = fields.collect();
        if fields.len() != self.columns.len() {
            return Err(TableError::Columns { row, found: fields.len(), expected: self.columns.len() });
        }
        let parse = |((column, _), text): (&(String, &str), &str)| {
            let error = || TableError::Number { row, column: column.clone(), text: text.to_owned() };
            number(text).ok_or_else(error)
        };
        self.columns.iter().zip(fields).map(parse).collect()
    }

    /// Goes on to the row of a time; what its first column says.
    fn advance(&mut self, time: f64) -> Result<f64, TableError> {
        self.row += 1;
        if let Some(before) = self.before.filter(|before| time <= *before) {
            return Err(TableError::Order { row: self.row, before, time });
        }
        // What is left to the time from where the durations so far lead: their roundings do not add up.
        let duration = self.before.map_or(time, |before| time - before);
        self.before = Some(match self.heading.timing {
            Timing::Absolute => time,
            Timing::Duration => self.before.map_or(time, |before| before + duration),
        });
        Ok(if self.heading.timing == Timing::Absolute { time } else { duration })
    }

    fn check(&self, numbers: &[f64]) -> Result<(), TableError> {
        let expected = self.columns.len();
        if numbers.len() != expected {
            return Err(TableError::Columns { row: self.row, found: numbers.len(), expected });
        }
        match numbers.iter().position(|number| !number.is_finite()) {
            Some(index) => {
                let column = self.columns[index].0.clone();
                Err(TableError::NotFinite { row: self.row, column, value: numbers[index] })
            }
            None => Ok(()),
        }
    }
}

/// Gives every knot the accelerations of the cubic that follows it, and the last one those of the cubic before it.
///
/// From (x0, v0) to (x1, v1) in the time t: a0 = (6*(x1-x0)/t - 4*v0 - 2*v1)/t, a1 = (2*v0 + 4*v1 - 6*(x1-x0)/t)/t.
pub(super) fn set_accelerations(rows: &mut [Knot]) {
    for index in 1..rows.len() {
        let (before, after) = rows.split_at_mut(index);
        let (from, to) = (&mut before[index - 1], &mut after[0]);
        let time = to.time - from.time;
        for (from, to) in from.states.iter_mut().zip(&mut to.states) {
            let speed = (to.position - from.position) / time;
            from.acceleration = (6.0 * speed - 4.0 * from.velocity - 2.0 * to.velocity) / time;
            to.acceleration = (2.0 * from.velocity + 4.0 * to.velocity - 6.0 * speed) / time;
        }
    }
}
