//! `milling`: the time of a G-code file or of a polyline.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use closedform_motion::plan::milling::gcode::{DwellUnit, Event, Reading, Summary as Job, Unknown};
use closedform_motion::plan::milling::{Feed, Machine, Milling, Model, Path as Way, Row};
use closedform_motion::plot::{Panel, Picture};
use closedform_motion::table::{TableError, save_moves};
use indicatif::{ProgressBar, ProgressStyle};
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};
use crate::input::merged;
use crate::output::{Output, note};
use crate::shown::{MOST, shown};
use crate::summary::Summary;

/// Lines that were passed over are told one by one up to this many.
const TOLD: u64 = 10;

/// What becomes of a line that is not understood.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum UnknownFlag {
    Refuse,
    Skip,
}

/// The unit of P in a dwell.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum DwellFlag {
    Seconds,
    Milliseconds,
}

/// What is known of the job.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// The program
    #[arg(long, value_name = "FILE")]
    gcode: Option<PathBuf>,
    /// Instead of a program, the corners of a polyline: a CSV file with a point (X,Y,Z in mm) a line; with --feed
    #[arg(long, value_name = "FILE")]
    points_file: Option<PathBuf>,
    /// Feed of the polyline, or of a program before its first F, in mm/s
    #[arg(long, value_name = "MM/S")]
    feed: Option<f64>,
    /// Limit of the acceleration, in mm/s²: one for all axes, or X,Y,Z [default: 500]
    #[arg(long, value_name = "A[,A,A]", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    acceleration: Vec<f64>,
    /// Limit of the speed, in mm/s: one for all axes, or X,Y,Z [default: none]
    #[arg(long, value_name = "V[,V,V]", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    speed: Vec<f64>,
    /// Speed of rapid moves (G0) along the path, in mm/s [default: 100]
    #[arg(long, value_name = "MM/S")]
    rapid: Option<f64>,
    /// Largest feed along the path, in mm/s; a larger one is cut to it [default: none]
    #[arg(long, value_name = "MM/S")]
    max_feed: Option<f64>,
    /// Count the time in steps of constant speed, at most so long, in mm, as the derivation does [default: 1]
    #[arg(long, value_name = "MM")]
    step: Option<f64>,
    /// Count it with constant acceleration, the limit of short steps
    #[arg(long, num_args = 0..=1, default_missing_value = "true", value_name = "BOOL")]
    continuous: Option<bool>,
    /// What becomes of a line that is not understood [default: refuse]
    #[arg(long)]
    unknown: Option<UnknownFlag>,
    /// Unit of P in a dwell, G4 P [default: seconds]
    #[arg(long)]
    dwell: Option<DwellFlag>,
    /// Leave out lines that begin with `/`
    #[arg(long, num_args = 0..=1, default_missing_value = "true", value_name = "BOOL")]
    block_delete: Option<bool>,
}

impl Inputs {
    fn milling(&self) -> Outcome<Milling> {
        let usual = Machine::default();
        let machine = Machine {
            acceleration: of_axes("acceleration", &self.acceleration, usual.acceleration)?,
            speed: of_axes("speed", &self.speed, usual.speed)?,
            rapid: self.rapid.unwrap_or(usual.rapid),
            feed: self.max_feed.unwrap_or(usual.feed),
        };
        let model = match (self.continuous, self.step) {
            (Some(true), Some(_)) => {
                let message = "step and continuous are both given: leave one of them out";
                return Err(Failure::Input(message.to_owned()));
            }
            (Some(true), None) => Model::Continuous,
            (_, Some(length)) => Model::Steps { length },
            _ => Model::default(),
        };
        Ok(Milling::new(machine, model)?)
    }

    fn reading(&self) -> Reading {
        Reading {
            unknown: match self.unknown {
                Some(UnknownFlag::Skip) => Unknown::Skip,
                _ => Unknown::Refuse,
            },
            default_feed: self.feed,
            dwell: match self.dwell {
                Some(DwellFlag::Milliseconds) => DwellUnit::Milliseconds,
                _ => DwellUnit::Seconds,
            },
            block_delete: self.block_delete.unwrap_or(false),
            ..Reading::default()
        }
    }
}

/// One number for all axes, or one an axis.
fn of_axes(name: &str, given: &[f64], usual: [f64; 3]) -> Outcome<[f64; 3]> {
    match *given {
        [] => Ok(usual),
        [all] => Ok([all; 3]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(Failure::Input(format!("{name} has {} numbers: give one for all axes, or three", given.len()))),
    }
}

/// What takes the moves as they are timed.
type Sink<'a> = &'a mut dyn FnMut(&Row) -> Result<(), TableError>;

/// Times, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(inputs, output.file.as_deref())?;
    output.spares(inputs.points_file.as_deref())?;
    output.spares(inputs.gcode.as_deref())?;
    let milling = inputs.milling()?;
    let mut kept = Vec::new();
    let mut keep = |row: &Row| {
        if output.picture.is_some() && kept.len() < MOST {
            kept.push(row.cut);
        }
    };
    let (job, rows) = match &output.table {
        None => (
            time(&inputs, &milling, &mut |row| {
                keep(row);
                Ok(())
            })?,
            None,
        ),
        Some(path) => {
            let run = |writer: &mut closedform_motion::table::MoveWriter| {
                let job = time(&inputs, &milling, &mut |row| {
                    keep(row);
                    writer.push(row)
                })?;
                Ok::<_, Failure>((job, Some(writer.rows())))
            };
            save_moves(path, run)?
        }
    };
    let mut summary = summary(&job);
    if let (Some(path), rows) = (&output.table, rows) {
        summary.file(path, rows);
    }
    if output.picture.is_some() {
        let motion = shown(&milling, &kept)?;
        let title =
            if job.moves > MOST as u64 { format!("Milling: the first {MOST} moves") } else { "Milling".to_owned() };
        let panels = [Panel::Path, Panel::Position, Panel::Velocity, Panel::Acceleration];
        let has_arcs = kept.iter().any(|cut| matches!(cut.path, Way::Arc(_)));
        let note =
            if has_arcs { "with constant acceleration; arcs as their chords" } else { "with constant acceleration" };
        output.picture(&mut summary, Picture::new(&motion).title(title).note(note).panels(&panels))?;
    }
    output.print(&summary)
}

fn time(inputs: &Inputs, milling: &Milling, sink: Sink) -> Outcome<Job> {
    match (&inputs.gcode, &inputs.points_file) {
        (Some(path), None) => program(path, milling, &inputs.reading(), sink).map_err(|failure| failure.at(path)),
        (None, Some(path)) => polyline(path, milling, inputs.feed, sink).map_err(|failure| failure.at(path)),
        _ => Err(Failure::Input("what to mill is not clear: give gcode or points-file, one of them".to_owned())),
    }
}

fn program(path: &Path, milling: &Milling, reading: &Reading, sink: Sink) -> Outcome<Job> {
    let file = File::open(path).map_err(|error| Failure::Input(format!("{error}: give a file that can be read")))?;
    let size = file.metadata().map_or(0, |data| data.len());
    let bar = ProgressBar::new(size).with_style(style());
    let (mut told, mut wrong) = (0, None);
    let job = milling.gcode(BufReader::new(file), reading, |event| match event {
        Event::Row(row) => wrong = wrong.take().or_else(|| sink(row).err()),
        Event::Progress(progress) => bar.set_position(progress.bytes),
        Event::Notice(notice) => {
            told += 1;
            if told <= TOLD {
                bar.suspend(|| note(&format!("{}: passed over: {notice}", path.display())));
            }
        }
    });
    bar.finish_and_clear();
    if told > TOLD {
        note(&format!("{}: {} more lines passed over", path.display(), told - TOLD));
    }
    match wrong {
        Some(error) => Err(error.into()),
        None => Ok(job?),
    }
}

fn style() -> ProgressStyle {
    let template = "{bar:40} {percent} % of {total_bytes}, {eta} left";
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

fn polyline(path: &Path, milling: &Milling, feed: Option<f64>, sink: Sink) -> Outcome<Job> {
    let points = crate::points::read(path)?;
    let spatial = |(index, point): (usize, Vec<f64>)| match *point {
        [x, y] => Ok([x, y, 0.0]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(Failure::Input(format!("point {}: it has {} coordinates: give X,Y or X,Y,Z", index + 1, point.len()))),
    };
    let points = points.into_iter().enumerate().map(spatial).collect::<Outcome<Vec<_>>>()?;
    let feed = crate::input::need(feed, "feed", "the feed of the polyline in mm/s")?;
    let timed = milling.polyline(&points, Feed::Speed(feed))?;
    for row in &timed.rows {
        sink(row)?;
    }
    let length = timed.rows.iter().map(|row| row.length).sum();
    let moves = timed.rows.len() as u64;
    Ok(Job { moves, time: timed.time, cutting_time: timed.time, cutting_length: length, ..Job::default() })
}

fn summary(job: &Job) -> Summary {
    let mut summary = Summary::new("milling");
    let share = if job.time > 0.0 { 1.0 - job.cutting_time / job.time } else { 0.0 };
    summary
        .number("duration", job.time, "s")
        .because(&clock(job.time))
        .number("cutting", job.cutting_time, "s")
        .number("rapid", job.rapid_time, "s")
        .number("dwell", job.dwell_time, "s")
        .number("overhead share", share, "%")
        .because("of the duration, all that does not cut")
        .number("cutting length", job.cutting_length / 1000.0, "m")
        .number("rapid length", job.rapid_length / 1000.0, "m")
        .count("moves", job.moves)
        .count("lines", job.lines)
        .count("lines passed over", job.notices);
    summary
}

/// Hours, minutes and seconds.
fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    format!("{} h {:02} min {:02} s", whole / 3600, whole / 60 % 60, whole % 60)
}
