//! A motion program in PVT mode, as the Turbo PMAC Software Reference has it: `PVT{data}` and `{axis}{data}:{data}`.
//!
//! `PVT` says the time of the segments after it in ms, up to 4095.9998 in steps of a quarter of a microsecond (with I42 = 0).
//! A segment says where each axis ends and how fast, in its units and those a second where Isx90 is 1000.

use std::io::Write;

use super::error::ExportError;
use super::number::plain;
use super::points::{Point, Points, Times};
use crate::table::Row;

pub(super) const TIMES: Times = Times { per_second: 4e6, longest: 16_383_999.0 };

/// The letters of the axes of a coordinate system.
const LETTERS: [char; 9] = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'];

pub(super) fn write<I: Iterator<Item = Row>>(
    out: &mut impl Write,
    names: &[String],
    points: Points<I>,
) -> Result<u64, ExportError> {
    if names.len() > LETTERS.len() {
        return Err(ExportError::Axes { axes: names.len(), most: LETTERS.len() });
    }
    for (letter, name) in LETTERS.iter().zip(names) {
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        writeln!(out, "; {letter} is {name}")?;
    }
    writeln!(out, "; velocities a second: Isx90 = 1000; times in quarters of a microsecond: I42 = 0")?;
    writeln!(out, "OPEN PROG 1 CLEAR\nABS")?;
    let mut count = 0;
    let mut steps = 0.0;
    for point in points {
        let point = point?;
        if count == 0 {
            let places: Vec<String> = words(&point, |(position, _)| plain(*position));
            writeln!(out, "RAPID {}\nDWELL0", places.join(" "))?;
        } else {
            if point.steps != steps {
                steps = point.steps;
                writeln!(out, "PVT{}", plain(steps / 4000.0))?;
            }
            let places = words(&point, |(position, velocity)| format!("{}:{}", plain(*position), plain(*velocity)));
            writeln!(out, "{}", places.join(" "))?;
        }
        count += 1;
    }
    writeln!(out, "CLOSE")?;
    out.flush()?;
    Ok(count)
}

fn words(point: &Point, say: impl Fn(&(f64, f64)) -> String) -> Vec<String> {
    LETTERS.iter().zip(&point.axes).map(|(letter, axis)| format!("{letter}{}", say(axis))).collect()
}
