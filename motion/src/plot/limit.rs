//! Limits: which of them a panel shows as dashed lines, and what it says of the others.

use super::drawing::{Anchor, Drawing, Font, Stroke, width};
use super::frame::{LEFT, NOTE, RIGHT};
use super::scale::Scale;
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

    /// The dashed lines, and above the upper one, or below the lower one where it is alone, the text, in so many pixels
    /// that end at `right`.
    fn draw(&self, drawing: &mut Drawing, view: (&Scale, &Unit), range: (f64, f64), (room, right): (f64, f64)) {
        let (y, unit) = view;
        let [below, above] = self.sides(range);
        let height = y.at(self.value / unit.size);
        let depth = y.at(-self.value / unit.size);
        let stroke = Stroke { colour: self.colour, width: 1.6, dashes: "7 5" };
        for at in [below.then_some(depth), above.then_some(height)].into_iter().flatten() {
            drawing.line((LEFT, at), (RIGHT, at), stroke);
        }
        let at = match (below, above) {
            (_, true) => height - 5.0,
            (true, false) => depth + NOTE + 2.0,
            (false, false) => return,
        };
        // The colour tells whose limit it is, where there is no room for the name.
        let fits = |text: &String| width(text, NOTE) <= room;
        let text = [self.text(unit), unit.say(self.value)].into_iter().find(fits).unwrap_or_default();
        drawing.text((right, at), Anchor::End, Font { size: NOTE, bold: false, colour: self.colour }, &text);
    }
}

/// Draws the limits that a panel shows, their texts side by side.
pub(super) fn draw(drawing: &mut Drawing, limits: &[Limit], view: (&Scale, &Unit), range: (f64, f64)) {
    let column = (RIGHT - LEFT) / limits.len().max(1) as f64;
    for (index, limit) in limits.iter().enumerate() {
        limit.draw(drawing, view, range, (column - 14.0, RIGHT - 6.0 - index as f64 * column));
    }
}

/// What a panel says of the limits it does not show, in so many pixels.
pub(super) fn note(limits: &[Limit], range: (f64, f64), unit: &Unit, room: f64) -> String {
    let hidden = limits.iter().filter(|limit| limit.sides(range) == [false, false]);
    let texts: Vec<String> = hidden.map(|limit| limit.text(unit)).collect();
    let full = format!("{}, not shown", texts.join(", "));
    match texts.len() {
        0 => String::new(),
        _ if width(&full, NOTE) <= room => full,
        1 => "limit not shown".to_owned(),
        _ => "limits not shown".to_owned(),
    }
}
