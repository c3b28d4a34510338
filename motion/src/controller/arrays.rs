//! The arrays of a trajectory as JSON: positions and velocities an axis, durations in whole microseconds, and user programs,
//! which say where data are collected, as ophyd-async's PMAC driver sends them.

use std::io::Write;

use super::error::ExportError;
use super::points::{Point, Points, Times};
use crate::table::Row;

pub(super) const TIMES: Times = Times { per_second: 1e6, longest: 4_095_999.0 };

/// User programs: in a window of collection, between two, and after the last.
const COLLECTION_WINDOW: i32 = 1;
const GAP: i32 = 2;
const END: i32 = 8;

pub(super) fn write<I: Iterator<Item = Row>>(
    out: &mut impl Write,
    names: &[String],
    points: Points<I>,
) -> Result<u64, ExportError> {
    let points: Vec<Point> = points.collect::<Result<_, _>>()?;
    // the first point is where the axes are: the driver moves there before
    let sent = points.get(1..).unwrap_or_default();
    let axis = |of: fn(&(f64, f64)) -> f64| {
        let values = |index: usize| sent.iter().map(|point| of(&point.axes[index])).collect::<Vec<f64>>();
        names.iter().enumerate().map(|(index, name)| (name.clone(), values(index).into())).collect()
    };
    let programs = |(index, point): (usize, &Point)| match point.is_steady {
        _ if index + 1 == sent.len() => END,
        true => COLLECTION_WINDOW,
        false => GAP,
    };
    let start: Vec<f64> = points.first().map_or_else(Vec::new, |point| point.axes.iter().map(|axis| axis.0).collect());
    let positions: serde_json::Map<String, serde_json::Value> = axis(|axis| axis.0);
    let velocities: serde_json::Map<String, serde_json::Value> = axis(|axis| axis.1);
    let all = serde_json::json!({
        "start": start,
        "positions": positions,
        "velocities": velocities,
        "durations": sent.iter().map(|point| point.steps as u64).collect::<Vec<u64>>(),
        "user_programs": sent.iter().enumerate().map(programs).collect::<Vec<i32>>(),
    });
    writeln!(out, "{all}")?;
    out.flush()?;
    Ok(sent.len() as u64)
}
