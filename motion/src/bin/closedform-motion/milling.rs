//! `milling`: the time of a G-code file or of a polyline.

mod inputs;
mod told;

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use closedform_motion::plan::milling::gcode::{Dialect, Event, Summary as Job};
use closedform_motion::plan::milling::{Feed, Milling, Path as Way, Row};
use closedform_motion::plot::{Panel, Picture};
use closedform_motion::table::{TableError, save_moves};
use indicatif::{ProgressBar, ProgressStyle};

pub use inputs::Inputs;

use crate::error::{Failure, Outcome};
use crate::input::merged;
use crate::output::{Output, note};
use crate::shown::{MOST, shown};

/// Lines that were passed over are told one by one up to this many.
const TOLD: u64 = 10;

/// Read at once; from the first of it the dialect is guessed.
const HEAD: usize = 1 << 16;

/// What takes the moves as they are timed.
type Sink<'a> = &'a mut dyn FnMut(&Row) -> Result<(), TableError>;

/// Times, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(inputs, output.file.as_deref())?;
    output.spares(inputs.points_file.as_deref())?;
    output.spares(inputs.gcode.as_deref())?;
    let mut kept = Vec::new();
    let mut keep = |row: &Row| {
        if output.picture.is_some() && kept.len() < MOST {
            kept.push(row.cut);
        }
    };
    let ((job, milling), rows) = match &output.table {
        None => (
            time(&inputs, &mut |row| {
                keep(row);
                Ok(())
            })?,
            None,
        ),
        Some(path) => {
            let run = |writer: &mut closedform_motion::table::MoveWriter| {
                let job = time(&inputs, &mut |row| {
                    keep(row);
                    writer.push(row)
                })?;
                Ok::<_, Failure>((job, Some(writer.rows())))
            };
            save_moves(path, run)?
        }
    };
    let mut summary = told::summary(&job, &milling);
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

fn time(inputs: &Inputs, sink: Sink) -> Outcome<(Job, Milling)> {
    match (&inputs.gcode, &inputs.points_file) {
        (Some(path), None) => program(path, inputs, sink).map_err(|failure| failure.at(path)),
        (None, Some(path)) => polyline(path, inputs, sink).map_err(|failure| failure.at(path)),
        _ => Err(Failure::Input("what to mill is not clear: give gcode or points-file, one of them".to_owned())),
    }
}

fn program(path: &Path, inputs: &Inputs, sink: Sink) -> Outcome<(Job, Milling)> {
    let unreadable = |error| Failure::Input(format!("{error}: give a file that can be read"));
    let file = File::open(path).map_err(unreadable)?;
    let size = file.metadata().map_or(0, |data| data.len());
    let mut input = BufReader::with_capacity(HEAD, file);
    let head = input.fill_buf().map_err(unreadable)?;
    let dialect = inputs.dialect().unwrap_or_else(|| Dialect::guess(&String::from_utf8_lossy(head)));
    let (milling, reading) = (inputs.milling(Some(dialect))?, inputs.reading(path, dialect)?);
    let bar = ProgressBar::new(size).with_style(style());
    let (mut told, mut wrong) = (0, None);
    let job = milling.gcode(input, &reading, |event| match event {
        Event::Row(row) => wrong = wrong.take().or_else(|| sink(row).err()),
        Event::Progress(progress) => bar.set_position(progress.bytes),
        Event::Notice(notice) => {
            told += 1;
            if told <= TOLD {
                bar.suspend(|| note(&format!("{}: passed over: {notice}", path.display())));
            }
        }
        Event::Dialect(_) | Event::Dwell(_) => {}
    });
    bar.finish_and_clear();
    if told > TOLD {
        note(&format!("{}: {} more lines passed over", path.display(), told - TOLD));
    }
    match wrong {
        Some(error) => Err(error.into()),
        None => Ok((job?, milling)),
    }
}

fn style() -> ProgressStyle {
    let template = "{bar:40} {percent} % of {total_bytes}, {eta} left";
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

fn polyline(path: &Path, inputs: &Inputs, sink: Sink) -> Outcome<(Job, Milling)> {
    let milling = inputs.milling(inputs.dialect())?;
    let points = crate::points::read(path)?;
    let spatial = |(index, point): (usize, Vec<f64>)| match *point {
        [x, y] => Ok([x, y, 0.0]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(Failure::Input(format!("point {}: it has {} coordinates: give X,Y or X,Y,Z", index + 1, point.len()))),
    };
    let points = points.into_iter().enumerate().map(spatial).collect::<Outcome<Vec<_>>>()?;
    let feed = crate::input::need(inputs.feed, "feed", "the feed of the polyline in mm/s")?;
    let timed = milling.polyline(&points, Feed::Speed(feed))?;
    for row in &timed.rows {
        sink(row)?;
    }
    let length = timed.rows.iter().map(|row| row.length).sum();
    let moves = timed.rows.len() as u64;
    let job = Job { moves, time: timed.time, cutting_time: timed.time, cutting_length: length, ..Job::default() };
    Ok((job, milling))
}
