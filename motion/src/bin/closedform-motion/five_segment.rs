//! `five-segment`: a step in five segments, symmetric in time.

use clap::Args;
use closedform_motion::plan::five_segment::{FiveSegment, FiveSegmentBy};
use closedform_motion::plot::Picture;
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::{merged, need};
use crate::limits::limits;
use crate::output::Output;
use crate::summary::Summary;

/// What is known of the step.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// The whole travel, in m
    #[arg(long, value_name = "M")]
    delta_x: Option<f64>,
    /// Twice the travel of the first segment, as a fraction of the whole
    #[arg(long, value_name = "FRACTION")]
    ki: Option<f64>,
    /// Acceleration after the first segment, in m/s²; with --a1 and --t1
    #[arg(long, value_name = "M/S2")]
    a0: Option<f64>,
    /// Acceleration after the second segment, in m/s², of either sign; with --a0 and --t1
    #[arg(long, value_name = "M/S2", allow_hyphen_values = true)]
    a1: Option<f64>,
    /// Time of the first and of the last segment, each, in s; with --t1 and --t2
    #[arg(long, value_name = "S")]
    t0: Option<f64>,
    /// Time of the second and of the fourth segment, each, in s
    #[arg(long, value_name = "S")]
    t1: Option<f64>,
    /// Time of the segment in the middle, in s; with --t0 and --t1
    #[arg(long, value_name = "S")]
    t2: Option<f64>,
    /// Limit of the velocity, in m/s
    #[arg(long, value_name = "M/S")]
    v_max: Option<f64>,
    /// Limit of the acceleration, in m/s²
    #[arg(long, value_name = "M/S2")]
    a_max: Option<f64>,
    /// Limit of the jerk, in m/s³
    #[arg(long, value_name = "M/S3")]
    j_max: Option<f64>,
}

impl Inputs {
    fn step(&self) -> Outcome<FiveSegment> {
        let given = match (self.a0, self.a1, self.t0, self.t1, self.t2) {
            (Some(a0), Some(a1), None, Some(t1), None) => FiveSegmentBy::Accelerations { a0, a1, t1 },
            (None, None, Some(t0), Some(t1), Some(t2)) => FiveSegmentBy::Times { t0, t1, t2 },
            _ => {
                let message = "the shape of the step is not clear: give a0, a1 and t1, or t0, t1 and t2";
                return Err(Failure(message.to_owned()));
            }
        };
        Ok(FiveSegment {
            delta_x: need(self.delta_x, "delta-x", "the whole travel in m")?,
            ki: need(self.ki, "ki", "twice the travel of the first segment, as a fraction of the whole,")?,
            given,
            limits: limits("", self.v_max, self.a_max, self.j_max)?,
        })
    }
}

/// Plans, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let plan = merged(inputs, output.file.as_deref())?.step()?.plan()?;
    let mut summary = Summary::new("five-segment");
    summary
        .number("duration", plan.duration(), "s")
        .number("t0", plan.t0, "s")
        .because("first and last segment, each")
        .number("t1", plan.t1, "s")
        .because("second and fourth segment, each")
        .number("t2", plan.t2, "s")
        .because("in the middle")
        .number("a0", plan.a0, "m/s²")
        .number("a1", plan.a1, "m/s²")
        .peaks_of(plan.motion());
    output.table_of(&mut summary, plan.motion())?;
    output.picture(&mut summary, Picture::new(plan.motion()).title("Step in five segments"))?;
    output.print(&summary)
}
