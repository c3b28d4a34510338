//! The pictures of the README, light and dark.

mod accuracy;
mod motions;

use std::path::Path;

use closedform_motion::plot::{Chart, Mark, Panel, Picture, Theme};

use crate::error::Outcome;

/// The themes and what the names of their files end with.
const THEMES: [(Theme, &str); 2] = [(Theme::LIGHT, "light"), (Theme::DARK, "dark")];

/// Draws them all into a folder.
pub fn run(folder: &Path) -> Outcome<()> {
    std::fs::create_dir_all(folder)?;
    for (theme, ending) in THEMES {
        let path = |name: &str| folder.join(format!("{name}-{ending}.svg"));
        for letter in ['a', 'b'] {
            waypoints(letter, theme, &path(&format!("waypoints-{letter}")))?;
        }
        step(theme, &path("step-move"))?;
        scan(theme, &path("scan-line"))?;
        accuracy(theme, &path("accuracy"))?;
    }
    Ok(())
}

fn waypoints(letter: char, theme: Theme, path: &Path) -> Outcome<()> {
    let (motion, points) = motions::waypoints(letter)?;
    let mark = |(index, point): (usize, &Vec<f64>)| Mark { x: point[0], y: point[1], name: (index + 1).to_string() };
    let (kind, panels): (&str, &[Panel]) = match letter {
        'a' => ("linear segments", &[Panel::Path, Panel::Position, Panel::Velocity]),
        _ => ("quadratic, linear, quadratic", &[Panel::Path, Panel::Position, Panel::Velocity, Panel::Acceleration]),
    };
    let picture = Picture::new(&motion)
        .title(format!("Waypoints ({letter}): {kind}"))
        .marks(points.iter().enumerate().map(mark).collect())
        .panels(panels)
        .theme(theme);
    Ok(picture.save(path)?)
}

fn step(theme: Theme, path: &Path) -> Outcome<()> {
    let motion = motions::step()?;
    let picture = Picture::new(&motion)
        .title("Step move: hard start, gentle settling")
        .note("1 mm, x0 and x3 at the quarters, t1 = 15 ms, a3 = −0.25 m/s² (4.1.2)")
        .panels(&[Panel::Position, Panel::Velocity, Panel::Acceleration])
        .theme(theme);
    Ok(picture.save(path)?)
}

fn scan(theme: Theme, path: &Path) -> Outcome<()> {
    let motion = motions::scan()?;
    let picture = Picture::new(&motion)
        .title("Two scan lines and the turn-around")
        .note("0.1 m/s on lines of 5 mm, steps of 0.2 mm; jerks limited too")
        .panels(&[Panel::Path, Panel::Velocity, Panel::Acceleration])
        .theme(theme);
    Ok(picture.save(path)?)
}

fn accuracy(theme: Theme, path: &Path) -> Outcome<()> {
    let chart = Chart {
        title: "turnaround::t_in before and after".to_owned(),
        note: format!("the worst of {} turn-arounds at each place", accuracy::SAMPLES),
        x_title: "Step / travel of the ramps out − 1".to_owned(),
        y_title: "Error (ulp)".to_owned(),
        logarithmic: (true, true),
        series: accuracy::series(),
        theme,
    };
    Ok(chart.save(path)?)
}
