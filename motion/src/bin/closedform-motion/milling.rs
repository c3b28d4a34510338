//! `milling`: the time of a G-code file or of a polyline.

mod inputs;
mod told;

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

use closedform_motion::plan::milling::gcode::{Dialect, Event, Summary as Job};
use closedform_motion::plan::milling::{Feed, Milling};
use closedform_motion::plot::{ToolPath, with_unit};
use closedform_motion::table::{MoveWriter, TableError, save_moves};
use indicatif::{ProgressBar, ProgressStyle};

pub use inputs::Inputs;

use crate::error::{Failure, Outcome};
use crate::input::merged;
use crate::output::{Output, note};

/// Lines that were passed over are told one by one up to this many.
const TOLD: u64 = 10;

/// Read at once; from the first of it the dialect is guessed.
const HEAD: usize = 1 << 16;

/// What takes the moves as they are timed.
type Sink<'a> = &'a mut dyn FnMut(&Event) -> Result<(), TableError>;

/// Times, writes and prints.
pub fn run(inputs: &Inputs, output: &Output) -> Outcome<()> {
    let inputs = merged(inputs, output.file.as_deref())?;
    if let Some(path) = &output.export.export {
        let message = "milling has times and no motion of the axes: leave --export out, and send the program itself";
        return Err(Failure(message.to_owned()).at(path));
    }
    output.spares(inputs.points_file.as_deref())?;
    output.spares(inputs.gcode.as_deref())?;
    let mut path = ToolPath::new();
    let mut keep = |event: &Event| match event {
        Event::Row(row) if output.picture.is_some() => path.add(row),
        Event::Dwell(time) if output.picture.is_some() => path.dwell(*time),
        _ => {}
    };
    let ((job, milling), rows) = match &output.table {
        None => {
            let mut sink = |event: &Event| {
                keep(event);
                Ok(())
            };
            (time(&inputs, &mut sink)?, None)
        }
        Some(path) => save_moves(path, |writer: &mut MoveWriter| {
            let mut sink = |event: &Event| {
                keep(event);
                if let Event::Row(row) = event { writer.push(row) } else { Ok(()) }
            };
            let job = time(&inputs, &mut sink)?;
            Ok::<_, Failure>((job, Some(writer.rows())))
        })?,
    };
    let mut summary = told::summary(&job, &milling);
    if let Some(path) = &output.table {
        summary.file(path, rows);
    }
    draw(&inputs, output, &path, &job, &milling)?.iter().for_each(|path| summary.file(path, None));
    output.print(&summary)
}

/// The picture, if one is asked for, and where it is then.
fn draw(inputs: &Inputs, output: &Output, path: &ToolPath, job: &Job, milling: &Milling) -> Outcome<Option<PathBuf>> {
    let Some(file) = &output.picture else { return Ok(None) };
    let title =
        inputs.gcode.as_deref().and_then(Path::file_name).map_or("Milling".into(), |name| name.to_string_lossy());
    let least = if job.notices > 0 { "at least " } else { "" };
    let note = format!("{} moves in {least}{}, {}", job.moves, with_unit(job.time, "s"), milling.model().name());
    let is_page = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html"));
    let drawn = match is_page {
        true => path.page(&title, &note, output.theme()).and_then(|page| page.save(file)),
        false => path.draw(inputs.colouring(), &title, &note, output.theme()).and_then(|drawing| drawing.save(file)),
    };
    drawn.map_err(|error| Failure::from(error).at(file))?;
    Ok(Some(file.clone()))
}

fn time(inputs: &Inputs, sink: Sink) -> Outcome<(Job, Milling)> {
    match (&inputs.gcode, &inputs.points_file) {
        (Some(path), None) => program(path, inputs, sink).map_err(|failure| failure.at(path)),
        (None, Some(path)) => polyline(path, inputs, sink).map_err(|failure| failure.at(path)),
        _ => Err(Failure("what to mill is not clear: give gcode or points-file, one of them".to_owned())),
    }
}

fn program(path: &Path, inputs: &Inputs, sink: Sink) -> Outcome<(Job, Milling)> {
    let unreadable = |error| Failure(format!("{error}: give a file that can be read"));
    let file = File::open(path).map_err(unreadable)?;
    let size = file.metadata().map_or(0, |data| data.len());
    let mut input = BufReader::with_capacity(HEAD, file);
    let head = input.fill_buf().map_err(unreadable)?;
    let dialect = inputs.dialect().unwrap_or_else(|| Dialect::guess(&String::from_utf8_lossy(head)));
    let (milling, reading) = (inputs.milling(Some(dialect))?, inputs.reading(path, dialect)?);
    let bar = ProgressBar::new(size).with_style(style());
    let (mut told, mut wrong) = (0, None);
    let job = milling.gcode(input, &reading, |event| match event {
        Event::Row(_) | Event::Dwell(_) => wrong = wrong.take().or_else(|| sink(&event).err()),
        Event::Progress(progress) => bar.set_position(progress.bytes),
        Event::Notice(notice) => {
            told += 1;
            if told <= TOLD {
                bar.suspend(|| note(&format!("{}: passed over: {notice}", path.display())));
            }
        }
        Event::Dialect(_) => {}
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
        _ => Err(Failure(format!("point {}: it has {} coordinates: give X,Y or X,Y,Z", index + 1, point.len()))),
    };
    let points = points.into_iter().enumerate().map(spatial).collect::<Outcome<Vec<_>>>()?;
    let feed = crate::input::need(inputs.feed, "feed", "the feed of the polyline in mm/s")?;
    let timed = milling.polyline(&points, Feed::Speed(feed))?;
    for row in &timed.rows {
        sink(&Event::Row(row))?;
    }
    let length = timed.rows.iter().map(|row| row.length).sum();
    let moves = timed.rows.len() as u64;
    let job = Job { moves, time: timed.time, cutting_time: timed.time, cutting_length: length, ..Job::default() };
    Ok((job, milling))
}
