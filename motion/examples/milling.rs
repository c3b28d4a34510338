//! How long a small milling job takes, move by move.
//!
//! Run it with `cargo run -p closedform-motion --example milling [PICTURE.svg]`.

use std::error::Error;
use std::path::PathBuf;

use closedform_motion::plan::milling::gcode::{Event, Reading};
use closedform_motion::plan::milling::{Machine, Milling, Model};
use closedform_motion::plot::{Chart, Series, Theme};

const PROGRAM: &str = "\
G21 G90            (mm, absolute)
G0 X10 Y10 Z2
G1 Z-1 F300        (mm/min)
G1 X60 F1200
G1 Y40
G2 X40 Y60 I-20 J0 (an arc)
G1 X10
G1 Y10
G0 Z5
M30
";

fn main() -> Result<(), Box<dyn Error>> {
    let machine = Machine { acceleration: [500.0, 500.0, 200.0], ..Machine::default() };
    let milling = Milling::new(machine, Model::default())?;
    let mut points = vec![(0.0, 0.0)];
    let job = milling.gcode(PROGRAM.as_bytes(), &Reading::default(), |event| {
        if let Event::Row(row) = event {
            println!(
                "line {:2}: {:6.2} mm in {:.3} s, {:.1} mm/s at most",
                row.cut.line, row.length, row.time, row.peak
            );
            points.push((row.total, points[points.len() - 1].1 + row.length));
        }
    })?;
    println!("{} moves in {:.2} s, {:.2} s of it cutting", job.moves, job.time, job.cutting_time);

    let path = picture("milling.svg");
    let chart = Chart {
        title: "A small milling job".to_owned(),
        note: format!("{} moves in {:.2} s", job.moves, job.time),
        x_title: "Time (s)".to_owned(),
        y_title: "Way at the end of each move (mm)".to_owned(),
        logarithmic: (false, false),
        series: vec![Series { name: "way".to_owned(), points }],
        theme: Theme::LIGHT,
    };
    chart.save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// What the argument says, or a file in the temporary folder.
fn picture(name: &str) -> PathBuf {
    std::env::args_os().nth(1).map_or_else(|| std::env::temp_dir().join(name), PathBuf::from)
}
