//! Paths through four points in the plane, the problems (a) to (f) of the derivation, and the PVT table of one of them.
//!
//! Run it with `cargo run -p closedform-motion --example waypoints [PICTURE.svg] [LETTER]`.

use std::error::Error;
use std::path::PathBuf;

use closedform_motion::plan::waypoints::{Problem, Timing, Waypoints};
use closedform_motion::plot::{Mark, Picture};
use closedform_motion::table::{Heading, Timing as Column, knots, write_csv};

fn main() -> Result<(), Box<dyn Error>> {
    let letter = std::env::args().nth(2).and_then(|text| text.chars().next()).unwrap_or('b');
    let problem = Problem::of_letter(letter).ok_or("give a letter from a to f")?;
    let points = vec![vec![0.0, 0.0], vec![0.2, 0.4], vec![0.7, 0.5], vec![1.0, 0.1]];
    let plan = Waypoints::new(problem, points.clone(), Timing::Speed(1.0)).plan()?;
    let motion = plan.motion();

    // The velocity jumps in problem (a): that is no table for a controller.
    if problem != Problem::Linear {
        let heading = Heading { axes: vec!["x".to_owned(), "y".to_owned()], timing: Column::Absolute };
        write_csv(std::io::stdout(), &heading, knots(&motion, 1e-9)?)?;
    }

    let path = picture("waypoints.svg");
    let mark = |(index, point): (usize, &Vec<f64>)| Mark { x: point[0], y: point[1], name: (index + 1).to_string() };
    let marks = points.iter().enumerate().map(mark).collect();
    Picture::new(&motion).title(format!("Waypoints ({letter})")).marks(marks).save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// What the argument says, or a file in the temporary folder.
fn picture(name: &str) -> PathBuf {
    std::env::args_os().nth(1).map_or_else(|| std::env::temp_dir().join(name), PathBuf::from)
}
