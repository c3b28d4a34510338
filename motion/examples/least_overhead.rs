//! The least overhead of the derivation: how it depends on the velocity that is lost in the line.
//!
//! Run it with `cargo run -p closedform-motion --example least_overhead [PICTURE.svg]`.

use std::error::Error;
use std::path::PathBuf;

use closedform_motion::PlanError;
use closedform_motion::plan::derived_raster::{Choice, DerivedRaster};
use closedform_motion::plot::{Chart, Series, Theme};

fn main() -> Result<(), Box<dyn Error>> {
    let scan = DerivedRaster::new(0.1, 50.0, 2e-4, 2.0, 5e-3, 2);
    let least = scan.plan()?;
    println!(
        "least overhead {:.4} ms, with v1_diff {:.3} mm/s",
        1e3 * least.overhead,
        1e3 * least.turn.leaving.v1_diff
    );

    // The same with given v1_diff, each with its best t_in: none has less.
    let overhead =
        |v1_diff: f64| Ok::<f64, PlanError>(DerivedRaster { choice: Choice::V1Diff(v1_diff), ..scan }.plan()?.overhead);
    let given: Vec<f64> = (1..=60).map(|percent| 1e-3 * f64::from(percent)).collect();
    let points =
        given.iter().map(|v| Ok((1e3 * v, 1e3 * overhead(*v)?))).collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    assert!(points.iter().all(|(_, time)| *time >= 1e3 * least.overhead * (1.0 - 1e-12)));

    let path = picture("least_overhead.svg");
    let chart = Chart {
        title: "Overhead of half a turn-around".to_owned(),
        note: format!("least: {:.3} ms", 1e3 * least.overhead),
        x_title: "Velocity lost in the line (mm/s)".to_owned(),
        y_title: "Overhead (ms)".to_owned(),
        logarithmic: (false, false),
        series: vec![Series { name: "best t_in".to_owned(), points }],
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
