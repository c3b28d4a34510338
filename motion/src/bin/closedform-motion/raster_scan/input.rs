//! What is known of a raster, and which shape its turn-arounds have.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use closedform_motion::plan::derived_raster::{Choice, DerivedRaster, Ramps, Raster};
use closedform_motion::plan::raster_scan::{Order, RasterScan};
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::need;
use crate::limits::limits;
use crate::points::point;

/// The shape of the turn-arounds.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// The shortest turn-around that the limits of velocity, acceleration and jerk allow: both axes move in the least time,
    /// and the slower one sets it; nothing under these limits is faster
    Fastest,
    /// Accelerations that are linear in time and continuous on the line, with the least overhead as the derivation counts
    /// it; slower, and without limits of velocity and jerk
    Derivation,
}

/// Whether the ramps in belong to the line.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RampsFlag {
    Outside,
    Inside,
}

/// What is known of the raster.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// Velocity of the fly axis on the line, in m/s: it is kept
    #[arg(long, visible_alias = "v1-scan", value_name = "M/S")]
    #[serde(alias = "v1-scan")]
    v_scan: Option<f64>,
    /// Length of a line, in m; negative where the first line goes the other way
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    line_length: Option<f64>,
    /// Step from line to line, in m, of either sign; 0 repeats one line
    #[arg(long, visible_alias = "d2-step", value_name = "M", allow_hyphen_values = true)]
    #[serde(alias = "d2-step")]
    step: Option<f64>,
    /// Number of lines
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(..=1 << 53))]
    lines: Option<u64>,
    /// Limit of the velocity of the fly axis, in m/s
    #[arg(long, value_name = "M/S")]
    fly_v_max: Option<f64>,
    /// Limit of the acceleration of the fly axis, in m/s²
    #[arg(long, visible_alias = "a1-max", value_name = "M/S2")]
    #[serde(alias = "a1-max")]
    fly_a_max: Option<f64>,
    /// Limit of the jerk of the fly axis, in m/s³ [default: none, the acceleration may jump]
    #[arg(long, value_name = "M/S3")]
    fly_j_max: Option<f64>,
    /// Limit of the velocity of the step axis, in m/s
    #[arg(long, value_name = "M/S")]
    step_v_max: Option<f64>,
    /// Limit of the acceleration of the step axis, in m/s²
    #[arg(long, visible_alias = "a2-max", value_name = "M/S2")]
    #[serde(alias = "a2-max")]
    step_a_max: Option<f64>,
    /// Limit of the jerk of the step axis, in m/s³ [default: none, the acceleration may jump]
    #[arg(long, value_name = "M/S3")]
    step_j_max: Option<f64>,
    /// All lines in one direction, with a way back, instead of to and fro
    #[arg(long, num_args = 0..=1, default_missing_value = "true", value_name = "BOOL")]
    one_way: Option<bool>,
    /// Limit of the velocity on the way back, in m/s, with --one-way [default: that of the fly axis]
    #[arg(long, visible_alias = "v1-return", value_name = "M/S")]
    #[serde(alias = "v1-return")]
    v_return: Option<f64>,
    /// Time at the velocity of the line before each line, and after it, in s
    #[arg(long, value_name = "S")]
    run_up: Option<f64>,
    /// Time that the step axis rests before each line, in s
    #[arg(long, value_name = "S")]
    settle: Option<f64>,
    /// Cycle of the controller, in s: all times of the table are multiples of it; the velocity on the line stays
    #[arg(long, value_name = "S")]
    tick: Option<f64>,
    /// Shortest time from row to row of the table, in s
    #[arg(long, value_name = "S")]
    shortest: Option<f64>,
    /// Where the first line begins, in m
    #[arg(long, value_name = "FLY,STEP", value_parser = point, allow_hyphen_values = true)]
    start: Option<Point>,
    /// Number of pixels of a line, for their triggers
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1 << 53))]
    pub pixels: Option<u64>,
    /// Write when and where each pixel begins there, with --pixels: .csv
    #[arg(long, value_name = "FILE")]
    pub triggers: Option<PathBuf>,
    /// Shape of the turn-arounds [default: fastest, or derivation where one of the next four is given]
    #[arg(long)]
    shape: Option<Shape>,
    /// Derivation: whether the ramps in belong to the line [default: outside]
    #[arg(long)]
    ramps: Option<RampsFlag>,
    /// Derivation: velocity that the fly axis loses in the ramp in, in m/s, instead of that of the least overhead
    #[arg(long, value_name = "M/S")]
    v1_diff: Option<f64>,
    /// Derivation: time of the ramp in, in s, with --v1-diff
    #[arg(long, value_name = "S")]
    t_in: Option<f64>,
    /// Derivation: time of the ramp out, in s, instead of that of the least overhead
    #[arg(long, value_name = "S")]
    t_out: Option<f64>,
}

/// Of both axes.
type Point = Vec<f64>;

impl Inputs {
    /// Whether the turn-arounds are those of the derivation.
    pub fn is_derived(&self) -> bool {
        let given = self.ramps.is_some() || self.v1_diff.is_some() || self.t_in.is_some() || self.t_out.is_some();
        self.shape.map_or(given, |shape| shape == Shape::Derivation)
    }

    /// With the fastest turn-arounds.
    pub fn fastest(&self) -> Outcome<RasterScan> {
        if self.ramps.is_some() || self.v1_diff.is_some() || self.t_in.is_some() || self.t_out.is_some() {
            let message =
                "ramps, v1-diff, t-in and t-out are of the derivation: leave them out, or give --shape derivation";
            return Err(Failure(message.to_owned()));
        }
        if self.triggers.is_some() && self.pixels.is_none() {
            return Err(Failure("triggers are those of pixels: give their number with --pixels".to_owned()));
        }
        let start = match self.start.as_deref() {
            None => [0.0; 2],
            Some([fly, step]) => [*fly, *step],
            Some(_) => return Err(Failure("start has two numbers: give it as FLY,STEP".to_owned())),
        };
        let order = match (self.one_way, self.v_return) {
            (Some(true), back) => Order::OneWay(back),
            (_, None) => Order::Snake,
            (_, Some(_)) => return Err(no_way_back()),
        };
        Ok(RasterScan {
            velocity: self.velocity()?,
            line_length: self.length()?,
            step: self.stepping()?,
            lines: self.number()?,
            fly: limits("fly-", self.fly_v_max, self.fly_acceleration(self.fly_j_max.is_some())?, self.fly_j_max)?,
            stepping: limits(
                "step-",
                self.step_v_max,
                self.step_acceleration(self.step_j_max.is_some())?,
                self.step_j_max,
            )?,
            order,
            run_up: self.run_up.unwrap_or(0.0),
            settle: self.settle.unwrap_or(0.0),
            tick: self.tick,
            shortest: self.shortest.unwrap_or(0.0),
            start,
        })
    }

    /// With those of the derivation.
    pub fn derived(&self) -> Outcome<DerivedRaster> {
        let only = [
            ("fly-v-max", self.fly_v_max.is_some()),
            ("fly-j-max", self.fly_j_max.is_some()),
            ("step-v-max", self.step_v_max.is_some()),
            ("step-j-max", self.step_j_max.is_some()),
            ("run-up", self.run_up.is_some()),
            ("settle", self.settle.is_some()),
            ("shortest", self.shortest.is_some()),
            ("start", self.start.is_some()),
            ("pixels", self.pixels.is_some()),
            ("triggers", self.triggers.is_some()),
        ];
        if let Some((name, _)) = only.into_iter().find(|(_, given)| *given) {
            let message = format!("{name} is of the fastest turn-around: leave it out, or give --shape fastest");
            return Err(Failure(message));
        }
        let unlimited = |limit: Option<f64>| limit.unwrap_or(f64::INFINITY);
        Ok(DerivedRaster {
            v1_scan: self.velocity()?,
            a1_max: unlimited(self.fly_acceleration(false)?),
            d2_step: self.stepping()?,
            a2_max: unlimited(self.step_acceleration(false)?),
            line_length: self.length()?,
            lines: self.number()?,
            ramps: match self.ramps {
                Some(RampsFlag::Inside) => Ramps::Inside,
                _ => Ramps::Outside,
            },
            raster: match (self.one_way, self.v_return) {
                (Some(true), v1_return) => Raster::OneWay { v1_return },
                (_, None) => Raster::Snake,
                (_, Some(_)) => return Err(no_way_back()),
            },
            choice: self.choice()?,
            tick: self.tick,
        })
    }

    fn choice(&self) -> Outcome<Choice> {
        match (self.v1_diff, self.t_in, self.t_out) {
            (None, None, None) => Ok(Choice::Fastest),
            (Some(v1_diff), None, None) => Ok(Choice::V1Diff(v1_diff)),
            (Some(v1_diff), Some(t_in), None) => Ok(Choice::Ramp { v1_diff, t_in }),
            (None, None, Some(t_out)) => Ok(Choice::TOut(t_out)),
            _ => Err(Failure(
                "v1-diff, t-in and t-out together say too much or too little: give none, v1-diff, v1-diff and t-in, or t-out"
                    .to_owned(),
            )),
        }
    }

    fn velocity(&self) -> Outcome<f64> {
        need(self.v_scan, "v-scan", "the velocity on the line in m/s")
    }

    fn length(&self) -> Outcome<f64> {
        need(self.line_length, "line-length", "the length of a line in m")
    }

    fn stepping(&self) -> Outcome<f64> {
        need(self.step, "step", "the step from line to line in m")
    }

    fn number(&self) -> Outcome<u64> {
        need(self.lines, "lines", "the number of lines")
    }

    /// Needed, unless the jerk is limited.
    fn fly_acceleration(&self, is_limited: bool) -> Outcome<Option<f64>> {
        let limit = "the limit of the acceleration of the fly axis in m/s²";
        if is_limited { Ok(self.fly_a_max) } else { need(self.fly_a_max, "fly-a-max", limit).map(Some) }
    }

    fn step_acceleration(&self, is_limited: bool) -> Outcome<Option<f64>> {
        let limit = "the limit of the acceleration of the step axis in m/s²";
        if is_limited { Ok(self.step_a_max) } else { need(self.step_a_max, "step-a-max", limit).map(Some) }
    }
}

fn no_way_back() -> Failure {
    Failure("v-return is of a way back: add --one-way, or leave it out".to_owned())
}
