//! `step`: a move from rest to rest, the fastest or by a shape of the derivation.

use clap::{Args, ValueEnum};
use closedform_motion::plan::fastest::Fastest;
use closedform_motion::plan::step_move::{Frame, StepMove, StepShape, StepTime};
use closedform_motion::plot::Picture;
use closedform_motion::{Limits, Motion, State};
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::{merged, need};
use crate::limits::{limits, moved};
use crate::output::Output;
use crate::summary::Summary;

/// The shape of the step.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Shape {
    /// The least time under --v-max, --a-max and --j-max; without --j-max the acceleration jumps, and with --time the same,
    /// slower
    Fastest,
    /// Four segments that start hard and settle gently; the limits are checked
    Derivation,
}

/// What is known of the step.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// The whole travel, in m
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    travel: Option<f64>,
    /// Shape of the step [default: fastest, or derivation where one of its letters is given]
    #[arg(long)]
    shape: Option<Shape>,
    /// Acceleration with which the settling begins, in m/s², negative: first and last segment make a quarter each; with --t1
    #[arg(long, value_name = "M/S2", allow_hyphen_values = true)]
    a3: Option<f64>,
    /// Time of the second and of the third segment, each, in s; with --a3, or with --ki and --ko
    #[arg(long, value_name = "S")]
    t1: Option<f64>,
    /// Twice the travel of the first segment, as a fraction of the whole; with --ko, or with --t-out
    #[arg(long, value_name = "FRACTION")]
    ki: Option<f64>,
    /// Twice the travel of the last segment, as a fraction of the whole; with --ki
    #[arg(long, value_name = "FRACTION")]
    ko: Option<f64>,
    /// Time of the whole step, in s, no less than the fastest; in the derivation with --ki and --ko
    #[arg(long, value_name = "S")]
    time: Option<f64>,
    /// Symmetric frame: time of the second and of the third segment, each, in s; with --ki or --t-ie-skip
    #[arg(long, value_name = "S")]
    t_out: Option<f64>,
    /// Symmetric frame: time of the first and of the last segment, each, in s; with --t-out
    #[arg(long, value_name = "S")]
    t_ie_skip: Option<f64>,
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
    fn step(&self) -> Outcome<StepMove> {
        let travel = need(self.travel, "travel", "the whole travel in m")?;
        Ok(StepMove { travel, shape: self.shape()?, limits: limits("", self.v_max, self.a_max, self.j_max)? })
    }

    fn shape(&self) -> Outcome<StepShape> {
        match (self.a3, self.t1, self.ki, self.ko, self.time, self.t_out, self.t_ie_skip) {
            (Some(a3), Some(t1), None, None, None, None, None) => Ok(StepShape::Quarter { a3, t1 }),
            (None, Some(t1), Some(ki), Some(ko), None, None, None) => {
                Ok(StepShape::Fractions { ki, ko, time: StepTime::Middle(t1) })
            }
            (None, None, Some(ki), Some(ko), Some(time), None, None) => {
                Ok(StepShape::Fractions { ki, ko, time: StepTime::Total(time) })
            }
            (None, None, Some(ki), None, None, Some(t_out), None) => {
                Ok(StepShape::Symmetric { frame: Frame::Ki(ki), t_out })
            }
            (None, None, None, None, None, Some(t_out), Some(t)) => {
                Ok(StepShape::Symmetric { frame: Frame::TIESkip(t), t_out })
            }
            _ => Err(Failure(
                "the shape of the step is not clear: give a3 and t1, or ki, ko and time (or t1), or t-out and ki (or t-ie-skip)"
                    .to_owned(),
            )),
        }
    }
}

/// Plans, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(inputs, output.file.as_deref())?;
    if inputs.is_derived() { derived(&inputs, output) } else { fastest(&inputs, output) }
}

impl Inputs {
    fn is_derived(&self) -> bool {
        let letters = [self.a3, self.t1, self.ki, self.ko, self.t_out, self.t_ie_skip];
        self.shape.map_or(letters.iter().any(Option::is_some), |shape| shape == Shape::Derivation)
    }

    fn travel(&self) -> Outcome<f64> {
        let travel = need(self.travel, "travel", "the whole travel in m")?;
        if travel != 0.0 && travel.is_finite() {
            return Ok(travel);
        }
        Err(Failure(format!("travel is {travel}: give a finite number other than 0")))
    }

    fn limits(&self) -> Outcome<Limits> {
        let found = limits("", self.v_max, self.a_max, self.j_max)?;
        if found.acceleration.min(found.jerk).is_finite() {
            return Ok(found);
        }
        let message = "the step has no limit: give --a-max, --j-max, or both, in m/s² and m/s³ (or the letters of the \
                       derivation: a3 and t1, or ki, ko and time or t1, or t-out and ki or t-ie-skip)";
        Err(Failure(message.to_owned()))
    }
}

/// In the least time, or stretched.
fn fastest(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let travel = inputs.travel()?;
    let limits = inputs.limits()?;
    let fastest = Fastest::new(State::rest(0.0), State::rest(travel), limits)?;
    let plan = inputs.time.map_or(Ok(fastest), |time| fastest.stretched(time))?;
    let motion =
        Motion::new(vec![closedform_motion::Axis { name: "step".to_owned(), profile: plan.profile()?, limits }]);
    let mut summary = Summary::new("step");
    summary.number("duration", plan.duration(), "s");
    if inputs.time.is_some() {
        summary.number("fastest", fastest.duration(), "s").because("the least time under the limits");
    }
    summary.words("shape", "fastest").because(&moved(&motion));
    summary.peaks_of(&motion);
    output.table_of(&mut summary, &motion)?;
    output.picture(&mut summary, Picture::new(&motion).title("Step from rest to rest"))?;
    output.print(&summary)
}

/// By the letters of the derivation.
fn derived(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let plan = inputs.step()?.plan()?;
    let mut summary = Summary::new("step");
    let [t0, t1, _, t4] = plan.times;
    summary
        .number("duration", plan.duration(), "s")
        .number("t0", t0, "s")
        .because("first segment")
        .number("t1", t1, "s")
        .because("second and third segment, each")
        .number("t4", t4, "s")
        .because("last segment")
        .number("a00", plan.a00, "m/s²")
        .because("before x0")
        .number("a0", plan.a0, "m/s²")
        .because("after x0")
        .number("a3", plan.a3, "m/s²")
        .because("settling")
        .peaks_of(plan.motion());
    output.table_of(&mut summary, plan.motion())?;
    output.picture(&mut summary, Picture::new(plan.motion()).title("Step in four segments"))?;
    output.print(&summary)
}
