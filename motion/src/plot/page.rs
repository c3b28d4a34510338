//! The page of a motion: the panels of its picture, as fine as they may be looked at.

use super::curve::thinned;
use super::error::PlotError;
use super::html::{Page, PageCurve, PageLimit, PageMark, PagePanel, colour_index};
use super::path;
use super::picture::{Curves, Picture, View, rest};
use super::theme::Theme;
use super::unit::{Unit, axis_unit};
use crate::extremes::Quantity;

/// Of the height of a panel, by how much a curve may be off: it may be looked at closely.
const FINE: f64 = 1e-5;

/// Of the duration, within which nothing is told apart.
const COLUMN: f64 = 2e-5;

impl Picture<'_> {
    /// The same panels as a page that can be zoomed and read.
    ///
    /// # Errors
    ///
    /// As of [`Picture::draw`].
    pub fn page(&self) -> Result<Page, PlotError> {
        self.check()?;
        let time = axis_unit("s", self.motion.duration());
        let mut panels: Vec<PagePanel> = Vec::new();
        if self.has_path() {
            panels.push(self.path_panel());
        }
        panels.extend(self.over_time().iter().map(|curves| self.panel(curves, &time)));
        Ok(Page {
            title: if self.title.is_empty() { "Motion".to_owned() } else { self.title.clone() },
            note: self.note.clone(),
            names: self.names(),
            end: self.motion.duration() / time.size,
            unit: time.name,
            panels,
            is_dark: self.theme == Theme::DARK,
        })
    }

    fn panel(&self, curves: &Curves, time: &Unit) -> PagePanel {
        let view = View::new(self, curves);
        let shown = |limit: &&super::limit::Limit| limit.sides(view.range) != [false, false];
        let limit = |limit: &super::limit::Limit| {
            let colour = colour_index(&self.theme, limit.colour());
            let (value, [below, above]) = (limit.value / view.unit.size, limit.sides(view.range));
            let sides = [below.then_some(-value), above.then_some(value)];
            sides.into_iter().flatten().map(move |value| PageLimit { value, colour })
        };
        PagePanel {
            title: self.name(curves, &view.unit),
            x_title: format!("Time ({})", time.name),
            x_name: "time".to_owned(),
            x_unit: time.name.clone(),
            y_unit: view.unit.name.clone(),
            linked: true,
            curves: curves.axes.iter().map(|axis| self.page_curve(*axis, curves.quantity, &view, time)).collect(),
            limits: view.limits.iter().filter(shown).flat_map(limit).collect(),
            ..PagePanel::default()
        }
    }

    fn page_curve(&self, index: usize, quantity: Quantity, view: &View, time: &Unit) -> PageCurve {
        let (axis, end) = (&self.motion.axes()[index], self.motion.duration());
        let mut points = quantity.points(&axis.profile, FINE * (view.shown.1 - view.shown.0) * view.unit.size);
        points.extend(rest(axis, quantity, end).into_iter().flatten());
        let (x, y) = thinned(points, COLUMN * end)
            .into_iter()
            .map(|(at, value)| (short(at / time.size), short(value / view.unit.size)))
            .unzip();
        PageCurve {
            name: format!("{} of {}", quantity.title().to_lowercase(), axis.name),
            colour: self.colour(index),
            x,
            y,
            ..PageCurve::default()
        }
    }

    fn path_panel(&self) -> PagePanel {
        let path = path::scaled(self);
        let (x, y) = path.points.iter().map(|(x, y)| (short(*x), short(*y))).unzip();
        let mark = |mark: &super::Mark| PageMark {
            x: mark.x / path.units[0].size,
            y: mark.y / path.units[1].size,
            name: mark.name.clone(),
        };
        PagePanel {
            title: path.title,
            x_title: path.below,
            x_name: path.names[0].clone(),
            x_unit: path.units[0].name.clone(),
            y_unit: path.units[1].name.clone(),
            equal: !path.is_stretched,
            note: if path.is_stretched { "not to one scale".to_owned() } else { String::new() },
            arrows: true,
            curves: vec![PageCurve { name: path.names[1].clone(), colour: -1, x, y, ..PageCurve::default() }],
            marks: self.marks.iter().map(mark).collect(),
            ..PagePanel::default()
        }
    }
}

/// With nine digits, so that pages stay small.
fn short(number: f64) -> f64 {
    format!("{number:.8e}").parse().unwrap_or(number)
}
