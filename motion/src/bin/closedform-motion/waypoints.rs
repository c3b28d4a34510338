//! `waypoints`: polynomials through points.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use closedform_motion::Limits;
use closedform_motion::plan::waypoints::{Freedom, Problem, Timing, WaypointPlan, Waypoints};
use closedform_motion::plot::{Mark, Panel, Picture, with_unit};
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::merged;
use crate::limits::{limits, moved};
use crate::output::Output;
use crate::points::{self, point};
use crate::summary::Summary;

/// What may change so that the path is faster.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Fastest {
    /// One factor for all segments: the path of a constant mean speed, as fast as the limits allow
    Factor,
    /// The time of each segment, by a search: faster, and the path between the points changes
    Segments,
}

/// What is known of the path.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// Problem of the derivation, a to f: a linear; b quadratic, linear, quadratic; c and d quadratic, cubic, quadratic;
    /// e cubics; f quartic, cubic, quartic; c, e, f start and end at rest [default: e]
    #[arg(long, value_name = "LETTER")]
    problem: Option<char>,
    /// A point, in m, such as 0.1,0.2, of any number of coordinates (twice or more; problems b, c and d four times or more)
    #[arg(long = "point", alias = "points", value_name = "X[,Y[,Z..]]", value_parser = point, allow_hyphen_values = true)]
    #[serde(alias = "point", skip_serializing_if = "Vec::is_empty")]
    points: Vec<Point>,
    /// Points from a CSV file, a point a line, in m; `-` for standard input
    #[arg(long, value_name = "FILE")]
    points_file: Option<PathBuf>,
    /// Mean speed along each chord, in m/s [default: 1, unless durations or limits are given]
    #[arg(long, value_name = "M/S")]
    speed: Option<f64>,
    /// Durations of the segments, in s, such as 0.5,1,0.5
    #[arg(long, value_name = "S,S,..", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    times: Vec<f64>,
    /// Limit of the velocity, in m/s: one for all axes, or one an axis; with a limit and without --speed and --times the path
    /// is as fast as all limits allow
    #[arg(long, value_name = "M/S,..", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    v_max: Vec<f64>,
    /// Limit of the acceleration, in m/s²
    #[arg(long, value_name = "M/S2,..", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    a_max: Vec<f64>,
    /// Limit of the jerk, in m/s³
    #[arg(long, value_name = "M/S3,..", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    j_max: Vec<f64>,
    /// What may change so that the path is faster [default: factor]
    #[arg(long)]
    fastest: Option<Fastest>,
    /// Velocity at the first point, in m/s, of problem e [default: rest]
    #[arg(long, value_name = "X[,Y..]", value_parser = point, allow_hyphen_values = true)]
    start_velocity: Option<Point>,
    /// Velocity at the last point, in m/s, of problem e [default: rest]
    #[arg(long, value_name = "X[,Y..]", value_parser = point, allow_hyphen_values = true)]
    end_velocity: Option<Point>,
}

/// The coordinates of a point.
type Point = Vec<f64>;

impl Inputs {
    fn waypoints(&self) -> Outcome<Waypoints> {
        let letter = self.problem.unwrap_or('e');
        let problem = Problem::of_letter(letter.to_ascii_lowercase())
            .ok_or_else(|| Failure(format!("problem is {letter}: give a letter from a to f")))?;
        let end = |velocity: &Option<Point>| velocity.clone().unwrap_or_default();
        let ends = [end(&self.start_velocity), end(&self.end_velocity)];
        Ok(Waypoints { problem, points: self.all_points()?, timing: self.timing()?, limits: self.limits()?, ends })
    }

    fn timing(&self) -> Outcome<Timing> {
        let has_limits = !(self.v_max.is_empty() && self.a_max.is_empty() && self.j_max.is_empty());
        match (self.speed, self.times.as_slice(), self.fastest) {
            (Some(_), [_, ..], _) => Err(Failure("speed and times are both given: give one of them".to_owned())),
            (Some(_), _, Some(_)) | (_, [_, ..], Some(_)) => {
                Err(Failure("fastest needs no speed and no times: leave them out, or fastest".to_owned()))
            }
            (Some(speed), [], None) => Ok(Timing::Speed(speed)),
            (None, times @ [_, ..], None) => Ok(Timing::Durations(times.to_vec())),
            (None, [], fastest) if has_limits || fastest.is_some() => Ok(Timing::Fastest(match fastest {
                Some(Fastest::Segments) => Freedom::Segments,
                _ => Freedom::Factor,
            })),
            (None, [], _) => Ok(Timing::Speed(1.0)),
        }
    }

    /// One for all axes, or one an axis.
    fn limits(&self) -> Outcome<Vec<Limits>> {
        let lists = [&self.v_max, &self.a_max, &self.j_max];
        let count = lists.iter().map(|list| list.len()).max().unwrap_or(0);
        if lists.iter().any(|list| list.len() > 1 && list.len() != count) {
            let message =
                "v-max, a-max and j-max are of different numbers of axes: give each one number, or one an axis";
            return Err(Failure(message.to_owned()));
        }
        let of = |list: &[f64], axis: usize| list.get(axis).or(list.first()).copied();
        let limits = |axis| limits("", of(&self.v_max, axis), of(&self.a_max, axis), of(&self.j_max, axis));
        (0..count).map(limits).collect()
    }

    /// A file of points that a file names lies beside it.
    fn beside(mut self, flags: &Self, output: &Output) -> Self {
        let folder = output.file.as_deref().and_then(Path::parent);
        if let (None, Some(named), Some(folder)) = (&flags.points_file, &self.points_file, folder) {
            self.points_file = Some(folder.join(named));
        }
        self
    }

    fn all_points(&self) -> Outcome<Vec<Point>> {
        match (&self.points_file, self.points.as_slice()) {
            (None, points) => Ok(points.to_vec()),
            (Some(path), []) => points::read(path).map_err(|failure| failure.at(path)),
            _ => Err(Failure("points and points-file are both given: give one of them".to_owned())),
        }
    }
}

/// Plans, writes and prints.
pub fn run(flags: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(flags, output.file.as_deref())?.beside(flags, output);
    output.spares(inputs.points_file.as_deref())?;
    let waypoints = inputs.waypoints()?;
    let plan = waypoints.plan()?;
    let motion = plan.motion();
    let mut summary = Summary::new("waypoints");
    summary
        .words("problem", &format!("({})", waypoints.problem.letter()))
        .count("points", waypoints.points.len() as u64)
        .number("duration", motion.duration(), "s");
    if let Timing::Fastest(freedom) = waypoints.timing {
        let timing = match freedom {
            Freedom::Factor => "one factor for all segments",
            Freedom::Segments => "segment times by a search",
        };
        summary.words("fastest", timing).because(&moved(&motion));
    }
    overshoot(&mut summary, &plan, &waypoints.points);
    summary.peaks_of(&motion);
    output.table_of(&mut summary, &motion)?;
    let title = format!("Waypoints, problem ({})", waypoints.problem.letter());
    output.picture(&mut summary, picture(Picture::new(&motion).title(title), &waypoints))?;
    output.print(&summary)
}

/// Says how far each axis goes beyond its points, where that is more than rounding.
fn overshoot(summary: &mut Summary, plan: &WaypointPlan, points: &[Point]) {
    let beyond = plan.overshoot(points);
    let mut said = Vec::new();
    for (axis, sides) in plan.motion().axes().iter().zip(beyond) {
        let largest = points.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (side, way) in ["below", "above"].into_iter().zip(sides) {
            if way > ROUNDING * largest {
                said.push(format!("{} {} {side} its points", axis.name, with_unit(way, "m")));
            }
        }
    }
    let said = if said.is_empty() { "none".to_owned() } else { said.join(", ") };
    summary.words("overshoot", &said);
}

/// Of the largest coordinate, what is no overshoot.
const ROUNDING: f64 = 1e-12;

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
