//! The axes and the speed over time; with many moves as what is between the least and the largest value.

use super::gather::Gathered;
use super::series::Series;
use crate::plot::curve::thinned;
use crate::plot::frame::{Frame, INSIDE, Line};
use crate::plot::html::{PageCurve, PagePanel};
use crate::plot::scale::{Scale, widened};
use crate::plot::theme::Theme;
use crate::plot::unit::{Unit, axis_unit};

/// How high a panel is, in pixels.
const HEIGHT: f64 = 92.0;
/// In what is so many pixels wide nothing is told apart.
const COLUMN: f64 = 0.5;
/// Of a page, shares of the whole time.
const FINE: f64 = 5e-5;

/// Of the time axis.
pub(super) fn unit(gathered: &Gathered) -> Unit {
    axis_unit("s", gathered.time)
}

/// Names, values, and indices of colours: axes that never move have no panel.
fn curves(gathered: &Gathered) -> Vec<(String, &Series, usize)> {
    let moves = |series: &Series| {
        let (low, high) = series.range();
        high > low
    };
    let axes = gathered.axes.iter().zip(["X", "Y", "Z"]).enumerate();
    let axes = axes.filter(|(_, (series, _))| moves(series));
    let axes = axes.map(|(index, (series, name))| (format!("{name} (mm)"), series, index));
    axes.chain([("Speed (mm/s)".to_owned(), &gathered.speed, 3)]).collect()
}

/// A panel each.
pub(super) fn frames(gathered: &Gathered, theme: &Theme) -> Vec<Frame> {
    let (time, curves) = (unit(gathered), curves(gathered));
    let last = curves.len();
    let width = if gathered.moves > 500 { 0.9 } else { 2.0 };
    let frame = |(index, (title, series, colour)): (usize, (String, &Series, usize))| {
        let points = thinned(series.points().to_vec(), COLUMN * gathered.time / INSIDE);
        let points = points.into_iter().map(|(at, value)| (at / time.size, value)).collect();
        Frame {
            title,
            note: String::new(),
            height: HEIGHT,
            x: Scale::linear((0.0, gathered.time / time.size), 7),
            y: Scale::linear(widened(series.range(), 0.08, 0.08), 4),
            below: (index + 1 == last).then(|| format!("Time ({})", time.name)),
            meetings: Vec::new(),
            lines: vec![Line { points, colour: theme.curve(colour), width, is_dashed: false }],
            dots: Vec::new(),
            arrows: Vec::new(),
            labels: Vec::new(),
        }
    };
    curves.into_iter().enumerate().map(frame).collect()
}

/// The same of a page.
pub(super) fn panels(gathered: &Gathered) -> Vec<PagePanel> {
    let time = unit(gathered);
    let panel = |(title, series, _): (String, &Series, usize)| {
        let points = thinned(series.points().to_vec(), FINE * gathered.time);
        let (x, y) = points.into_iter().map(|(at, value)| (at / time.size, value)).unzip();
        let (name, unit) = title.split_once(" (").unwrap_or((&title, ""));
        PagePanel {
            x_title: format!("Time ({})", time.name),
            x_name: "time".to_owned(),
            x_unit: time.name.clone(),
            y_unit: unit.trim_end_matches(')').to_owned(),
            linked: true,
            // colours of a page say what cuts
            curves: vec![PageCurve { name: name.to_owned(), colour: -1, x, y, ..PageCurve::default() }],
            title: title.clone(),
            ..PagePanel::default()
        }
    };
    curves(gathered).into_iter().map(panel).collect()
}
