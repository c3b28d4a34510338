//! Limits: which of them a panel shows as dashed lines, and what it says of the others.

use plotters::style::text_anchor::HPos;

use super::canvas::Font;
use super::error::PlotError;
use super::frame::{Frame, INSIDE, Label, Line, NOTE};
use super::theme::Theme;
use super::unit::Unit;
use crate::extremes::Quantity;
use crate::motion::Axis;

/// A limit more than so many times the largest value would leave a flat curve: it is told, not drawn.
const FAR: f64 = 3.0;

/// A limit that one or more axes share.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Limit {
    pub value: f64,
    colour: &'static str,
    /// Of the axes, where it is not that of all.
    names: String,
}

/// The different limits of some axes, which are given with their indices.
pub(super) fn limits(quantity: Quantity, axes: &[(usize, &Axis)], theme: &Theme) -> Vec<Limit> {
    let mut limits: Vec<Limit> = Vec::new();
    for (index, axis) in axes {
        let Some(value) = quantity.limit(axis.limits) else { continue };
        match limits.iter_mut().find(|limit| limit.value == value) {
            Some(limit) => {
                limit.colour = theme.muted;
                limit.names = format!("{}, {}", limit.names, axis.name);
            }
            None => limits.push(Limit { value, colour: theme.curve(*index), names: axis.name.clone() }),
        }
    }
    let limited = |(_, axis): &&(usize, &Axis)| quantity.limit(axis.limits).is_some();
    if let [limit] = limits.as_mut_slice()
        && axes.iter().filter(limited).count() == axes.len()
    {
        limit.names.clear();
    }
    limits
}

impl Limit {
    /// Of the axis that has it, or muted.
    pub(super) fn colour(&self) -> &'static str {
        self.colour
    }

    /// On which sides it is drawn, for values in a range.
    pub(super) fn sides(&self, (low, high): (f64, f64)) -> [bool; 2] {
        let largest = high.max(-low);
        if self.value > FAR * largest {
            return [false, false];
        }
        [-low * 2.0 * FAR >= self.value, high * 2.0 * FAR >= self.value]
    }

    fn text(&self, unit: &Unit) -> String {
        let name = if self.names.is_empty() { "limit".to_owned() } else { format!("limit of {}", self.names) };
        format!("{name} {}", unit.say(self.value))
    }

    fn font(&self) -> Font {
        Font { size: NOTE, bold: false, colour: self.colour }
    }

    /// The dashed lines, over times from 0 to `end`, in the unit of the panel.
    fn lines(&self, unit: &Unit, range: (f64, f64), end: f64) -> impl Iterator<Item = Line> {
        let (value, [below, above]) = (self.value / unit.size, self.sides(range));
        let shown = [below.then_some(-value), above.then_some(value)].into_iter().flatten();
        let colour = self.colour;
        shown.map(move |at| Line { points: vec![(0.0, at), (end, at)], colour, width: 1.6, is_dashed: true })
    }

    /// The text above the upper line, or below the lower one where that is alone, in so many pixels that end so many
    /// before the end.
    fn label(&self, unit: &Unit, range: (f64, f64), end: f64, room: (f64, f64)) -> Result<Option<Label>, PlotError> {
        let value = self.value / unit.size;
        let (at, down) = match self.sides(range) {
            [_, true] => (value, -5.0),
            [true, false] => (-value, NOTE + 2.0),
            [false, false] => return Ok(None),
        };
        // The colour tells whose limit it is, where there is no room for the name.
        let (long, short) = (self.text(unit), unit.say(self.value));
        let fits = |text: &String| Ok::<bool, PlotError>(self.font().width(text)? <= room.0);
        let text = match (fits(&long)?, fits(&short)?) {
            (true, _) => long,
            (_, true) => short,
            _ => return Ok(None),
        };
        let label = Label { at: (end, at), offset: (-room.1, down), side: HPos::Right, font: self.font(), text };
        Ok(Some(label))
    }
}

/// Draws the limits that a panel shows, under its curves, their texts side by side.
pub(super) fn draw(
    frame: &mut Frame,
    limits: &[Limit],
    unit: &Unit,
    range: (f64, f64),
    end: f64,
) -> Result<(), PlotError> {
    let column = INSIDE / limits.len().max(1) as f64;
    for (index, limit) in limits.iter().enumerate() {
        frame.lines.extend(limit.lines(unit, range, end));
        frame.labels.extend(limit.label(unit, range, end, (column - 14.0, 6.0 + index as f64 * column))?);
    }
    Ok(())
}

/// What a panel says of the limits it does not show, in so many pixels.
pub(super) fn note(
    limits: &[Limit],
    range: (f64, f64),
    unit: &Unit,
    (font, room): (Font, f64),
) -> Result<String, PlotError> {
    let hidden = limits.iter().filter(|limit| limit.sides(range) == [false, false]);
    let texts: Vec<String> = hidden.map(|limit| limit.text(unit)).collect();
    let full = format!("{}, not shown", texts.join(", "));
    Ok(match texts.len() {
        0 => String::new(),
        _ if font.width(&full)? <= room => full,
        1 => "limit not shown".to_owned(),
        _ => "limits not shown".to_owned(),
    })
}
