//! A program in ACSPL+ for SPiiPlus controllers: `PVSPLINE` with the time of each point, `POINT`, and `ENDS`.
//!
//! `PVSPLINE` drives cubics between points that have positions and velocities. With `/t` each `POINT` says its own time, in
//! ms. A point has the positions of all axes, then their velocities in units a second, then the time, in the order of the C
//! library's `acsc_AddPVTPointM(Axis, Point, Velocity, TimeInterval)`.

use std::io::Write;

use super::error::ExportError;
use super::number::plain;
use super::points::{Point, Points, Times};
use crate::table::Row;

pub(super) const TIMES: Times = Times { per_second: 1e6, longest: 1e12 };

pub(super) fn write<I: Iterator<Item = Row>>(
    out: &mut impl Write,
    names: &[String],
    points: Points<I>,
) -> Result<u64, ExportError> {
    for (axis, name) in names.iter().enumerate() {
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        writeln!(out, "! axis {axis} is {name}")?;
    }
    writeln!(out, "! times in ms; velocities a second")?;
    let numbers: Vec<String> = (0..names.len()).map(|axis| axis.to_string()).collect();
    let axes = format!("({})", numbers.join(","));
    let mut count = 0;
    for point in points {
        let point = point?;
        let positions = listed(&point, |axis| axis.0);
        match count {
            0 => writeln!(out, "PTP/e {axes}, {positions}\nPVSPLINE/t {axes}")?,
            _ => {
                let (velocities, time) = (listed(&point, |axis| axis.1), plain(point.steps / 1000.0));
                writeln!(out, "POINT {axes}, {positions}, {velocities}, {time}")?;
            }
        }
        count += 1;
    }
    writeln!(out, "ENDS {axes}\nSTOP")?;
    out.flush()?;
    Ok(count)
}

fn listed(point: &Point, of: impl Fn(&(f64, f64)) -> f64) -> String {
    point.axes.iter().map(|axis| plain(of(axis))).collect::<Vec<_>>().join(", ")
}
