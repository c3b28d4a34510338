//! `scan-skip`: a raster scan that flies along one axis and steps the other.

use clap::{Args, ValueEnum};
use closedform_motion::Motion;
use closedform_motion::plan::scan_skip::{Choice, Limiting, Ramps, Raster, ScanSkip, ScanSkipPlan};
use closedform_motion::plot::{Picture, with_unit};
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::{merged, need};
use crate::output::Output;
use crate::summary::Summary;

/// The names of the axes in tables.
const AXES: [&str; 2] = ["fly", "step"];

/// Whether the ramps in belong to the line.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum RampsFlag {
    Outside,
    Inside,
}

/// What is known of the raster.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// Velocity of the fly axis on the line, in m/s
    #[arg(long, value_name = "M/S")]
    v1_scan: Option<f64>,
    /// Largest acceleration of the fly axis, in m/s²
    #[arg(long, value_name = "M/S2")]
    a1_max: Option<f64>,
    /// Step from line to line, in m
    #[arg(long, value_name = "M")]
    d2_step: Option<f64>,
    /// Largest acceleration of the step axis, in m/s²
    #[arg(long, value_name = "M/S2")]
    a2_max: Option<f64>,
    /// Length of a line, in m
    #[arg(long, value_name = "M")]
    line_length: Option<f64>,
    /// Number of lines
    #[arg(long, value_name = "N")]
    lines: Option<u64>,
    /// Whether the ramps in belong to the line [default: outside]
    #[arg(long)]
    ramps: Option<RampsFlag>,
    /// All lines in one direction, with a way back, instead of to and fro
    #[arg(long, num_args = 0..=1, default_missing_value = "true", value_name = "BOOL")]
    one_way: Option<bool>,
    /// Velocity of the way back, in m/s, with --one-way [default: that of the line]
    #[arg(long, value_name = "M/S")]
    v1_return: Option<f64>,
    /// Velocity that the fly axis loses in the ramp in, in m/s, instead of the fastest turn-around
    #[arg(long, value_name = "M/S")]
    v1_diff: Option<f64>,
    /// Time of the ramp in, in s, with --v1-diff
    #[arg(long, value_name = "S")]
    t_in: Option<f64>,
    /// Time of the ramp out, in s, instead of the fastest turn-around
    #[arg(long, value_name = "S")]
    t_out: Option<f64>,
    /// Cycle of the controller, in s: all times become multiples of it
    #[arg(long, value_name = "S")]
    tick: Option<f64>,
}

impl Inputs {
    fn scan(&self) -> Outcome<ScanSkip> {
        Ok(ScanSkip {
            v1_scan: need(self.v1_scan, "v1-scan", "the velocity on the line in m/s")?,
            a1_max: need(self.a1_max, "a1-max", "the largest acceleration of the fly axis in m/s²")?,
            d2_step: need(self.d2_step, "d2-step", "the step from line to line in m")?,
            a2_max: need(self.a2_max, "a2-max", "the largest acceleration of the step axis in m/s²")?,
            line_length: need(self.line_length, "line-length", "the length of a line in m")?,
            lines: need(self.lines, "lines", "the number of lines")?,
            ramps: match self.ramps {
                Some(RampsFlag::Inside) => Ramps::Inside,
                _ => Ramps::Outside,
            },
            raster: self.raster()?,
            choice: self.choice()?,
            tick: self.tick,
        })
    }

    fn raster(&self) -> Outcome<Raster> {
        match (self.one_way, self.v1_return) {
            (Some(true), v1_return) => Ok(Raster::OneWay { v1_return }),
            (_, None) => Ok(Raster::Snake),
            (_, Some(_)) => {
                Err(Failure::Input("v1-return is of a way back: add --one-way, or leave it out".to_owned()))
            }
        }
    }

    fn choice(&self) -> Outcome<Choice> {
        match (self.v1_diff, self.t_in, self.t_out) {
            (None, None, None) => Ok(Choice::Fastest),
            (Some(v1_diff), None, None) => Ok(Choice::V1Diff(v1_diff)),
            (Some(v1_diff), Some(t_in), None) => Ok(Choice::Ramp { v1_diff, t_in }),
            (None, None, Some(t_out)) => Ok(Choice::TOut(t_out)),
            _ => Err(Failure::Input(
                "v1-diff, t-in and t-out together say too much or too little: give none, v1-diff, v1-diff and t-in, or t-out"
                    .to_owned(),
            )),
        }
    }
}

/// Plans, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let plan = merged(inputs, output.file.as_deref())?.scan()?.plan()?;
    let shown = shown(&plan)?;
    let mut summary = summary(&plan, &shown);
    output.table(&mut summary, &AXES.map(str::to_owned), plan.knots())?;
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
fn shown(plan: &ScanSkipPlan) -> Outcome<Motion> {
    let lines = plan.scan.lines.min(2);
    Ok(ScanSkipPlan { scan: ScanSkip { lines, ..plan.scan }, ..plan.clone() }.motion()?)
}

fn title(plan: &ScanSkipPlan) -> String {
    match plan.scan.lines {
        0..=2 => "Raster scan".to_owned(),
        lines => format!("Raster scan: the first 2 of {lines} lines"),
    }
}

fn summary(plan: &ScanSkipPlan, shown: &Motion) -> Summary {
    let mut summary = Summary::new("scan-skip");
    let turn = &plan.turn;
    summary
        .number("duration", plan.duration, "s")
        .number("period", plan.period, "s")
        .because("from line to line")
        .number("overhead share", plan.overhead_share, "%")
        .because("of the period")
        .number("overhead", plan.overhead, "s")
        .because("of half a turn-around")
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
        )
        .count("lines", plan.scan.lines)
        .count("table rows", plan.knot_count());
    if plan.scan.tick.is_some() {
        summary.number("tick cost", plan.tick_cost, "s").because("what the controller's cycle adds");
    }
    summary.peaks_of(shown);
    summary
}
