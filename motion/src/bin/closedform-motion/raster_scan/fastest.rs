//! A raster with the fastest turn-arounds: summary, table, triggers and picture.

use std::path::Path;

use closedform_motion::Motion;
use closedform_motion::plan::raster_scan::{RasterPlan, Slower};
use closedform_motion::plot::{Picture, with_unit};
use closedform_motion::table::save_triggers;

use super::input::Inputs;
use crate::error::{Failure, Outcome};
use crate::output::Output;
use crate::summary::Summary;

/// How many lines a picture shows at most: all of them, where they can be told apart.
const MOST_LINES: u64 = 12;

/// Plans, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    if let Some(path) = &inputs.triggers {
        output.writes(path, &["csv"])?;
    }
    let plan = inputs.fastest()?.plan()?;
    let shown = plan.motion(MOST_LINES)?;
    let mut summary = summary(&plan, &shown, inputs.pixels);
    output.table(&mut summary, &RasterPlan::AXES.map(str::to_owned), plan.row_count(), plan.rows())?;
    export(&mut summary, &plan, inputs.pixels, output)?;
    if let (Some(path), Some(pixels)) = (inputs.triggers.as_deref(), inputs.pixels) {
        let rows = triggers(path, &plan, pixels)?;
        summary.file(path, Some(rows));
    }
    output.picture(&mut summary, Picture::new(&shown).title(title(&plan)).note(note(&plan)))?;
    output.print(&summary)
}

/// What a controller takes of the whole raster.
fn export(summary: &mut Summary, plan: &RasterPlan, pixels: Option<u64>, output: &Output) -> Outcome<()> {
    if let Some((path, count)) = output.export.pixels(plan, pixels)? {
        summary.file(path, Some(count));
        return Ok(());
    }
    let whole = || Ok(plan.motion(plan.scan.lines)?);
    output.controller(summary, &RasterPlan::AXES.map(str::to_owned), plan.row_count(), plan.rows(), whole)
}

fn triggers(path: &Path, plan: &RasterPlan, pixels: u64) -> Outcome<u64> {
    let rows = plan.triggers(pixels);
    save_triggers(path, &RasterPlan::AXES, rows).map_err(|error| Failure::from(error).at(path))
}

fn title(plan: &RasterPlan) -> String {
    match plan.scan.lines {
        0..=MOST_LINES => "Raster scan".to_owned(),
        lines => format!("Raster scan: the first {MOST_LINES} of {lines} lines"),
    }
}

fn note(plan: &RasterPlan) -> String {
    match plan.slower {
        None => format!("one line in {}", with_unit(plan.duration, "s")),
        Some(_) => format!(
            "turn-around {}, overhead {:.1} % of {} a line",
            with_unit(plan.turn_time, "s"),
            100.0 * plan.overhead_share(),
            with_unit(plan.period, "s")
        ),
    }
}

fn summary(plan: &RasterPlan, shown: &Motion, pixels: Option<u64>) -> Summary {
    let mut summary = Summary::new("raster-scan");
    summary.number("duration", plan.duration, "s");
    summary.words("shape", "fastest").because("nothing under the limits below takes less time");
    summary.number("velocity on the line", plan.velocity(), "m/s").because("as given");
    summary.number("time on the line", plan.line_time, "s");
    if let Some(slower) = plan.slower {
        let limited = match slower {
            Slower::Fly => "fly axis",
            Slower::Step => "step axis",
            Slower::Both => "both axes",
        };
        summary
            .number("period", plan.period, "s")
            .because("from line to line")
            .number("overhead", plan.overhead, "s")
            .because("of the period, what is not the line")
            .number("overhead share", plan.overhead_share(), "%")
            .because("of the period")
            .number("turn-around", plan.turn_time, "s")
            .words("limited by", limited);
    }
    summary
        .count("lines", plan.scan.lines)
        .number("first line begins", plan.line_start(0), "s")
        .count("table rows", plan.row_count());
    if let Some(pixels) = pixels {
        summary.number("pixel time", plan.line_time / pixels as f64, "s");
    }
    if plan.scan.tick.is_some() || plan.scan.shortest > 0.0 {
        summary.number("tick cost", plan.tick_cost, "s").because("what the controller's cycle adds");
    }
    summary.peaks_of(shown);
    summary
}
