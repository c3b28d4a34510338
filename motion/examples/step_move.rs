//! A step that starts hard and settles gently, the case of section 4.1.2: position, velocity and acceleration.
//!
//! Run it with `cargo run -p closedform-motion --example step_move [PICTURE.svg]`.

use std::error::Error;
use std::path::PathBuf;

use closedform_motion::plan::step_move::{StepMove, StepShape};
use closedform_motion::plot::{Panel, Picture};

fn main() -> Result<(), Box<dyn Error>> {
    let plan = StepMove::new(1e-3, StepShape::Quarter { a3: -0.25, t1: 0.015 }).plan()?;
    println!("{:.2} ms; a0 = {:.5} m/s², before it {:.5} m/s²", 1e3 * plan.duration(), plan.a0, plan.a00);

    let path = picture("step_move.svg");
    let panels = [Panel::Position, Panel::Velocity, Panel::Acceleration];
    Picture::new(plan.motion()).title("Step move").panels(&panels).save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// What the argument says, or a file in the temporary folder.
fn picture(name: &str) -> PathBuf {
    std::env::args_os().nth(1).map_or_else(|| std::env::temp_dir().join(name), PathBuf::from)
}
