//! A raster scan: its turn-around, its times, and a picture of the first lines.
//!
//! Run it with `cargo run -p closedform-motion --example scan_line [PICTURE.svg]`.

use std::error::Error;
use std::path::PathBuf;

use closedform_motion::plan::derived_raster::DerivedRaster;
use closedform_motion::plot::Picture;

fn main() -> Result<(), Box<dyn Error>> {
    let scan = DerivedRaster {
        tick: Some(1e-4), // all times are multiples of 0.1 ms
        ..DerivedRaster::new(
            0.1,  // m/s on the line
            50.0, // m/s², fly axis
            2e-4, // m from line to line
            2.0,  // m/s², step axis
            5e-3, // m, a line
            3,    // lines
        )
    };
    let plan = scan.plan()?;
    println!("turn-around {:.3} ms, of a line {:.1} %", 1e3 * plan.turn.duration(), 100.0 * plan.overhead_share);

    let path = picture("scan_line.svg");
    Picture::new(&plan.motion()?).title("Raster scan").save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// What the argument says, or a file in the temporary folder.
fn picture(name: &str) -> PathBuf {
    std::env::args_os().nth(1).map_or_else(|| std::env::temp_dir().join(name), PathBuf::from)
}
