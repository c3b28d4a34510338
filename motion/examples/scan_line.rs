//! A raster scan with the fastest turn-arounds: its times, its triggers, and a picture.
//!
//! Run it with `cargo run -p closedform-motion --example scan_line [PICTURE.svg]`.

use std::error::Error;
use std::path::PathBuf;

use closedform_motion::Limits;
use closedform_motion::plan::raster_scan::RasterScan;
use closedform_motion::plot::Picture;

fn main() -> Result<(), Box<dyn Error>> {
    let limits = |acceleration, jerk| Limits { velocity: 0.5, acceleration, jerk };
    let scan = RasterScan {
        tick: Some(1e-4), // all times of the table are multiples of 0.1 ms
        run_up: 1e-3,     // at the velocity of the line, before it
        ..RasterScan::new(0.1, 5e-3, 2e-4, 4, limits(50.0, 2e4), limits(2.0, 1e3))
    };
    let plan = scan.plan()?;
    println!("a line every {:.2} ms, {:.1} % of it overhead", 1e3 * plan.period, 100.0 * plan.overhead_share());
    for trigger in plan.triggers(5).take(5) {
        println!("pixel {} begins after {:.3} ms", trigger.pixel, 1e3 * trigger.time);
    }

    let path = std::env::args_os().nth(1).map_or_else(|| std::env::temp_dir().join("scan_line.svg"), PathBuf::from);
    Picture::new(&plan.motion(4)?).title("Raster scan").save(&path)?;
    println!("{}", path.display());
    Ok(())
}
