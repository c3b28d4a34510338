//! A raster as scanspec has it: the JSON of its `Spec.serialize`, lines times pixels, with the time of a pixel.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::error::ExportError;
use super::scaling::{self, Scaling};
use crate::file::write_whole;
use crate::plan::raster_scan::{Order, RasterPlan};

/// Writes what a raster scans into a file, whole or not at all; how many pixels there are.
///
/// The motion is that of whoever runs it: a spec says where pixels are and how long they take, not how axes turn around.
///
/// # Errors
///
/// Not as many scalings as axes; more pixels than 2^53; the file system.
pub fn save_scan_spec(
    path: &Path,
    names: &[String; 2],
    scalings: &[Scaling],
    plan: &RasterPlan,
    pixels: u64,
) -> Result<u64, ExportError> {
    write_whole(path, |out| write_scan_spec(out, names, scalings, plan, pixels))
}

/// The same to any place.
///
/// # Errors
///
/// As of [`save_scan_spec`].
pub fn write_scan_spec(
    out: &mut impl Write,
    names: &[String; 2],
    scalings: &[Scaling],
    plan: &RasterPlan,
    pixels: u64,
) -> Result<u64, ExportError> {
    let scalings = scaling::of_axes(scalings, 2)?;
    let scan = &plan.scan;
    let (start, lines) = (scan.start, scan.lines);
    let most = 1 << 53;
    let count = lines.checked_mul(pixels).filter(|count| *count <= most).ok_or(ExportError::Many { most })?;
    let middle = |pixel: f64| start[0] + scan.line_length * (pixel + 0.5) / pixels as f64;
    let fly = linspace(&names[0], scalings[0], middle(0.0), middle((pixels - 1) as f64), pixels);
    let last = start[1] + scan.step * (lines - 1) as f64;
    let step = linspace(&names[1], scalings[1], start[1], last, lines);
    let line = match scan.order {
        Order::Snake => json!({ "type": "Snake", "spec": fly }),
        Order::OneWay(_) => fly,
    };
    let product = json!({ "type": "Product", "outer": step, "inner": line, "gap": true });
    let time = plan.line_time / pixels as f64;
    let timed = json!({ "type": "ConstantDuration", "constant_duration": time, "spec": product });
    writeln!(out, "{}", json!({ "type": "Fly", "spec": timed }))?;
    out.flush()?;
    Ok(count)
}

fn linspace(name: &str, scaling: Scaling, start: f64, stop: f64, count: u64) -> Value {
    let (start, stop) = (scaling.position(start), scaling.position(stop));
    json!({ "type": "Linspace", "axis": name, "start": start, "stop": stop, "num": count })
}
