//! Curves over time as paths of SVG: a Bezier curve a piece, steps where they jump.

use super::drawing::coordinate;
use super::quantity::Piece;
use super::scale::Scale;

/// Pieces narrower than this many pixels are drawn together.
const NARROW: f64 = 0.5;

/// A path and where it has come to.
struct Pen {
    path: String,
    at: Option<(String, String)>,
}

impl Pen {
    fn go(&mut self, to: (f64, f64)) {
        let to = (coordinate(to.0), coordinate(to.1));
        if self.at.as_ref() == Some(&to) {
            return;
        }
        let command = if self.at.is_none() { 'M' } else { 'L' };
        self.path.push_str(&format!("{command}{} {}", to.0, to.1));
        self.at = Some(to);
    }

    fn bend(&mut self, controls: [(f64, f64); 2], to: (f64, f64)) {
        let controls = controls.map(|(x, y)| format!("{} {}", coordinate(x), coordinate(y)));
        let to = (coordinate(to.0), coordinate(to.1));
        self.path.push_str(&format!("C{} {} {} {}", controls[0], controls[1], to.0, to.1));
        self.at = Some(to);
    }
}

/// What happens in a column of pixels: the values of first, least, greatest and last time.
struct Column {
    start: f64,
    points: Vec<(f64, f64)>,
}

impl Column {
    fn draw(self, pen: &mut Pen) {
        let height = |index: &usize| self.points[*index].1;
        let least = (0..self.points.len()).min_by(|a, b| height(a).total_cmp(&height(b)));
        let greatest = (0..self.points.len()).max_by(|a, b| height(a).total_cmp(&height(b)));
        let mut kept: Vec<usize> =
            [Some(0), least, greatest, self.points.len().checked_sub(1)].into_iter().flatten().collect();
        kept.sort_unstable();
        kept.dedup();
        for index in kept {
            pen.go(self.points[index]);
        }
    }
}

/// The path of a curve.
pub(super) fn curve(pieces: &[Piece], x: &Scale, y: &Scale) -> String {
    let mut pen = Pen { path: String::new(), at: None };
    let mut column: Option<Column> = None;
    for piece in pieces {
        let (left, right) = (x.at(piece.from), x.at(piece.to));
        if column.as_ref().is_some_and(|column| right - column.start > NARROW)
            && let Some(full) = column.take()
        {
            full.draw(&mut pen);
        }
        if right - left > NARROW {
            stroke(piece, x, y, &mut pen);
        } else {
            let column = column.get_or_insert_with(|| Column { start: left, points: Vec::new() });
            let points = [0.0, 0.5, 1.0].map(|share| (left + share * (right - left), y.at(piece.at(share))));
            column.points.extend(points);
        }
    }
    if let Some(column) = column {
        column.draw(&mut pen);
    }
    pen.path
}

/// A cubic with slopes s at its ends is the Bezier curve whose control points lie a third of the time along them.
fn stroke(piece: &Piece, x: &Scale, y: &Scale, pen: &mut Pen) {
    let (start, end) = ((x.at(piece.from), y.at(piece.values.0)), (x.at(piece.to), y.at(piece.values.1)));
    pen.go(start);
    let third = (end.0 - start.0) / 3.0;
    let rise = (piece.to - piece.from) / 3.0 * y.slope();
    let controls = [(start.0 + third, start.1 + rise * piece.slopes.0), (end.0 - third, end.1 - rise * piece.slopes.1)];
    let straight = |control: (f64, f64), share: f64| (control.1 - (start.1 + share * (end.1 - start.1))).abs() < 0.005;
    if straight(controls[0], 1.0 / 3.0) && straight(controls[1], 2.0 / 3.0) {
        pen.go(end);
    } else {
        pen.bend(controls, end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten pixels a unit across, and one up.
    fn scales() -> (Scale, Scale) {
        (Scale::linear((0.0, 10.0), (0.0, 100.0)), Scale::linear((0.0, 100.0), (100.0, 0.0)))
    }

    #[test]
    fn a_cubic_is_one_bezier_curve() {
        // t^3 from 0 to 3: the control points of a cubic in t lie at thirds of its time, here on 0, 0 and 27 - 27 = 0.
        let (x, y) = scales();
        let piece = Piece { from: 0.0, to: 3.0, values: (0.0, 27.0), slopes: (0.0, 27.0) };
        assert_eq!(curve(&[piece], &x, &y), "M0 100C10 100 20 100 30 73");
        assert_eq!(piece.at(0.5), 3.375);
    }

    #[test]
    fn a_jump_is_a_step_and_a_line_a_line() {
        let (x, y) = scales();
        let flat = |from: f64, value: f64| Piece { from, to: from + 1.0, values: (value, value), slopes: (0.0, 0.0) };
        assert_eq!(curve(&[flat(0.0, 10.0), flat(1.0, 60.0)], &x, &y), "M0 90L10 90L10 40L20 40");
    }

    #[test]
    fn narrow_pieces_keep_their_extremes() {
        let (x, y) = scales();
        let spike = |index: u32| {
            let from = f64::from(index) * 0.001;
            let value = if index == 7 { 90.0 } else { 1.0 };
            Piece { from, to: from + 0.001, values: (value, value), slopes: (0.0, 0.0) }
        };
        let pieces: Vec<Piece> = (0..1000).map(spike).collect();
        let path = curve(&pieces, &x, &y);
        assert!(path.contains(" 10L") && path.len() < 1000, "{path}");
    }
}
