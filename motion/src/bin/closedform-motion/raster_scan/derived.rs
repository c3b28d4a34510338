//! A raster with the turn-arounds of the derivation: summary, table and picture.

use closedform_motion::Motion;
use closedform_motion::plan::derived_raster::{DerivedRaster, DerivedRasterPlan, Limiting};
use closedform_motion::plot::{Picture, with_unit};

use crate::error::Outcome;
use crate::output::Output;
use crate::summary::Summary;

/// The names of the axes in tables.
const AXES: [&str; 2] = ["fly", "step"];

/// Plans, writes and prints.
pub fn run(scan: &DerivedRaster, output: &Output) -> Outcome<()> {
    let plan = scan.plan()?;
    let shown = shown(&plan)?;
    let mut summary = summary(&plan, &shown);
    output.table(&mut summary, &AXES.map(str::to_owned), plan.knot_count(), plan.rows())?;
    let whole = || Ok(plan.motion()?);
    output.controller(&mut summary, &AXES.map(str::to_owned), plan.knot_count(), plan.rows(), whole)?;
    let note = format!(
        "turn-around {}, overhead {:.1} % of {} a line",
        with_unit(plan.turn.duration(), "s"),
        100.0 * plan.overhead_share,
        with_unit(plan.period, "s")
    );
    output.picture(&mut summary, Picture::new(&shown).title(title(&plan)).note(note))?;
    output.print(&summary)
}

/// The lines that a picture shows: two of them show the turn-around, and on paper more are a carpet.
fn shown(plan: &DerivedRasterPlan) -> Outcome<Motion> {
    let lines = plan.scan.lines.min(2);
    Ok(DerivedRasterPlan { scan: DerivedRaster { lines, ..plan.scan }, ..plan.clone() }.motion()?)
}

fn title(plan: &DerivedRasterPlan) -> String {
    match plan.scan.lines {
        0..=2 => "Raster scan".to_owned(),
        lines => format!("Raster scan: the first 2 of {lines} lines"),
    }
}

fn summary(plan: &DerivedRasterPlan, shown: &Motion) -> Summary {
    let mut summary = Summary::new("raster-scan");
    summary.number("duration", plan.duration, "s");
    summary.words("shape", "derivation").because("--shape fastest takes the least time");
    summary.number("velocity on the line", plan.v1_scan, "m/s");
    if plan.v1_scan != plan.scan.v1_scan {
        summary.because("less than given, so that times are multiples of the tick");
    }
    if plan.scan.lines > 1 {
        turn_around(&mut summary, plan);
    }
    summary.count("lines", plan.scan.lines).count("table rows", plan.knot_count());
    if plan.scan.tick.is_some() {
        summary.number("tick cost", plan.tick_cost, "s").because("what the controller's cycle adds");
    }
    summary.peaks_of(shown);
    summary
}

fn turn_around(summary: &mut Summary, plan: &DerivedRasterPlan) {
    let turn = &plan.turn;
    summary
        .number("period", plan.period, "s")
        .because("from line to line")
        .number("overhead", plan.overhead_share * plan.period, "s")
        .because("of the period, what is not the line")
        .number("overhead share", plan.overhead_share, "%")
        .because("of the period")
        .number("turn-around", turn.duration(), "s")
        .number("t_in", turn.leaving.t_in, "s")
        .number("t_out", turn.leaving.t_out, "s")
        .number("t_edge", turn.t_edge, "s")
        .number("v1_diff", turn.leaving.v1_diff, "m/s")
        .words(
            "limited by",
            match plan.limiting {
                Limiting::Fly => "fly axis",
                Limiting::Step => "step axis",
                Limiting::Both => "both axes",
            },
        );
}
