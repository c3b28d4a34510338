//! The arrays of a profile move as JSON: the process variables of EPICS' `profileMoveController.template` and
//! `profileMoveAxis.template`, without their prefix, and what is to be put into each.
//!
//! The arrays have positions and times, no velocities. `Times` has a number for each point: how long the element takes
//! that begins there. After the last point drivers use it for the way out, so it is that of the element before.

use std::io::Write;

use serde_json::{Map, Value, json};

use super::error::ExportError;
use super::points::{Point, Points, Times};
use crate::table::Row;

pub(super) const TIMES: Times = Times { per_second: 1e6, longest: 1e12 };

/// `TimeMode`: every element has a time of its own.
const ARRAY: i32 = 1;
/// `MoveMode`: positions, not distances.
const ABSOLUTE: i32 = 0;

pub(super) fn write<I: Iterator<Item = Row>>(
    out: &mut impl Write,
    names: &[String],
    points: Points<I>,
) -> Result<u64, ExportError> {
    let points: Vec<Point> = points.collect::<Result<_, _>>()?;
    let mut times: Vec<f64> = points.iter().skip(1).map(|point| point.steps / TIMES.per_second).collect();
    times.extend(times.last().copied());
    let mut all = Map::new();
    let mut put = |name: String, value: Value| all.insert(name, value);
    put("NumAxes".to_owned(), json!(names.len()));
    put("NumPoints".to_owned(), json!(points.len()));
    put("TimeMode".to_owned(), json!(ARRAY));
    put("MoveMode".to_owned(), json!(ABSOLUTE));
    put("Times".to_owned(), json!(times));
    for axis in 0..names.len() {
        let positions: Vec<f64> = points.iter().map(|point| point.axes[axis].0).collect();
        put(format!("M{}UseAxis", axis + 1), json!(1));
        put(format!("M{}Positions", axis + 1), json!(positions));
    }
    writeln!(out, "{}", Value::Object(all))?;
    out.flush()?;
    Ok(points.len() as u64)
}
