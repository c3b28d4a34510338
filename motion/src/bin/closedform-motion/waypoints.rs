//! `waypoints`: polynomials through points.

use std::path::PathBuf;

use clap::Args;
use closedform_motion::plan::waypoints::{Problem, Timing, Waypoints};
use closedform_motion::plot::{Mark, Panel, Picture};
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::merged;
use crate::output::Output;
use crate::points::{self, point};
use crate::summary::Summary;

/// What is known of the path.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// Problem of the derivation, a to f: a linear; b quadratic, linear, quadratic; c and d quadratic, cubic, quadratic;
    /// e cubics; f quartic, cubic, quartic; c, e, f start and end at rest [default: e]
    #[arg(long, value_name = "LETTER")]
    problem: Option<char>,
    /// A point, in m, such as 0.1,0.2 (four times or more)
    #[arg(long = "point", value_name = "X[,Y[,Z]]", value_parser = point, allow_hyphen_values = true)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    points: Vec<Point>,
    /// Points from a CSV file, a point a line, in m
    #[arg(long, value_name = "FILE")]
    points_file: Option<PathBuf>,
    /// Mean speed along each chord, in m/s [default: 1, unless durations are given]
    #[arg(long, value_name = "M/S")]
    speed: Option<f64>,
    /// Durations of the segments, in s, such as 0.5,1,0.5
    #[arg(long, value_name = "S,S,..", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    times: Vec<f64>,
}

/// The coordinates of a point.
type Point = Vec<f64>;

impl Inputs {
    fn waypoints(&self) -> Outcome<Waypoints> {
        let letter = self.problem.unwrap_or('e');
        let problem = Problem::of_letter(letter.to_ascii_lowercase())
            .ok_or_else(|| Failure::Input(format!("problem is {letter}: give a letter from a to f")))?;
        let timing = match (self.speed, self.times.as_slice()) {
            (Some(_), [_, ..]) => {
                return Err(Failure::Input("speed and times are both given: give one of them".to_owned()));
            }
            (speed, []) => Timing::Speed(speed.unwrap_or(1.0)),
            (None, times) => Timing::Durations(times.to_vec()),
        };
        Ok(Waypoints { problem, points: self.all_points()?, timing })
    }

    fn all_points(&self) -> Outcome<Vec<Point>> {
        match (&self.points_file, self.points.as_slice()) {
            (None, points) => Ok(points.to_vec()),
            (Some(path), []) => points::read(path).map_err(|failure| failure.at(path)),
            _ => Err(Failure::Input("points and points-file are both given: give one of them".to_owned())),
        }
    }
}

/// Plans, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(inputs, output.file.as_deref())?;
    output.spares(inputs.points_file.as_deref())?;
    let waypoints = inputs.waypoints()?;
    let plan = waypoints.plan()?;
    let motion = plan.motion();
    let mut summary = Summary::new("waypoints");
    summary
        .words("problem", &format!("({})", waypoints.problem.letter()))
        .count("points", waypoints.points.len() as u64)
        .number("duration", motion.duration(), "s")
        .peaks_of(&motion);
    output.table_of(&mut summary, &motion)?;
    let title = format!("Waypoints, problem ({})", waypoints.problem.letter());
    output.picture(&mut summary, picture(Picture::new(&motion).title(title), &waypoints))?;
    output.print(&summary)
}

/// With the points marked, and no jerk where there is none.
fn picture<'a>(picture: Picture<'a>, waypoints: &Waypoints) -> Picture<'a> {
    let is_plane = waypoints.points.iter().all(|point| point.len() > 1);
    let mark = |(index, point): (usize, &Point)| Mark { x: point[0], y: point[1], name: format!("{}", index + 1) };
    let marks = match is_plane && waypoints.points.len() <= 20 {
        true => waypoints.points.iter().enumerate().map(mark).collect(),
        false => Vec::new(),
    };
    let mut panels = vec![Panel::Position, Panel::Velocity, Panel::Acceleration, Panel::Jerk];
    if waypoints.problem == Problem::Linear {
        panels.truncate(2);
    }
    if is_plane {
        panels.insert(0, Panel::Path);
    }
    picture.panels(&panels).marks(marks)
}
