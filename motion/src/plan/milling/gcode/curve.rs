//! Curves: G5 and G5.1 by their control points, and NURBS (G5.2, G6.2), each as chords.

use super::action::Action;
use super::block::Block;
use super::error::Problem;
use super::motion::{feed, straight, target};
use super::state::State;

/// Chords are no farther from the curve than this, in mm, where that takes no more than the most of them.
const NEAR: f64 = 0.001;
/// Of a curve, or of a span of a NURBS.
const MOST_CHORDS: f64 = 1000.0;
/// Chords of a span of a NURBS, whatever its shape.
const OF_SPAN: usize = 32;
/// Control points of one curve.
const MOST_POINTS: usize = 100_000;

/// A NURBS whose control points are coming.
#[derive(Debug, Default)]
pub(super) struct Curve {
    /// X, Y and Z of the machine, and the weight.
    points: Vec<[f64; 4]>,
    knots: Vec<f64>,
    order: usize,
    /// The second offset of the last G5, with which the next one goes on.
    last: [f64; 2],
}

impl Curve {
    /// G5: both offsets, I J from the begin and P Q from the end; G5.1: one, I J from the begin.
    pub(super) fn spline(
        &mut self,
        state: &mut State,
        is_cubic: bool,
        block: &Block,
        actions: &mut Vec<Action>,
    ) -> Result<(), Problem> {
        let unit = state.modes.unit;
        let word = |letter| block.word(letter).map(|value| value * unit);
        let (from, to) = (state.position, target(state, false, block)?);
        let start = match (word('I'), word('J')) {
            (None, None) if is_cubic => [-self.last[0], -self.last[1]],
            (i, j) => [i.unwrap_or(0.0), j.unwrap_or(0.0)],
        };
        let end = [word('P').unwrap_or(0.0), word('Q').unwrap_or(0.0)];
        let (begin, goal) = ([from[0], from[1]], [to[0], to[1]]);
        let plus = |point: [f64; 2], offset: [f64; 2]| [point[0] + offset[0], point[1] + offset[1]];
        let between = |one: [f64; 2], other: [f64; 2], share: f64| {
            [one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])]
        };
        let (near, far) = match is_cubic {
            true => (plus(begin, start), plus(goal, end)),
            // A parabola is a cubic whose control points are two thirds of the way to its own.
            false => {
                let middle = plus(begin, start);
                (between(begin, middle, 2.0 / 3.0), between(goal, middle, 2.0 / 3.0))
            }
        };
        self.last = if is_cubic { end } else { [0.0; 2] };
        let chords = chords(&[begin, near, far, goal]);
        let feed = feed(state, &from, &to, actions)?;
        let mut here = from;
        for index in 1..=chords {
            let share = f64::from(index) / f64::from(chords);
            let [ab, bc, cd] = [between(begin, near, share), between(near, far, share), between(far, goal, share)];
            let point = between(between(ab, bc, share), between(bc, cd, share), share);
            let mut next = to;
            for axis in 2..next.len() {
                next[axis] = from[axis] + share * (to[axis] - from[axis]);
            }
            (next[0], next[1]) = if index == chords { (goal[0], goal[1]) } else { (point[0], point[1]) };
            actions.push(straight(state, &here, &next, feed));
            here = next;
        }
        state.position = to;
        Ok(())
    }

    /// A control point of a NURBS: G5.2 with its weight P, and L for the order; G6.2 with weight R, knot K, order P.
    pub(super) fn nurbs(&mut self, state: &mut State, is_new: bool, block: &Block) -> Result<(), Problem> {
        let has_knots = block.word('K').is_some() || !self.knots.is_empty();
        if is_new {
            let order = if has_knots { block.word('P') } else { block.word('L') };
            *self = Self { order: order.unwrap_or(3.0).clamp(2.0, 32.0) as usize, ..Self::default() };
        }
        if let Some(knot) = block.word('K') {
            self.knots.push(knot);
        }
        let weight = if has_knots { block.word('R') } else { block.word('P') }.unwrap_or(1.0);
        let has_point = block.any("XYZ").is_some();
        // The point where the tool is comes first, unless the curve names it.
        if is_new && !(has_knots && has_point) {
            self.points.push([state.position[0], state.position[1], state.position[2], weight]);
        }
        if has_point {
            let to = target(state, false, block)?;
            self.points.push([to[0], to[1], to[2], weight]);
        }
        if self.points.len() > MOST_POINTS {
            let remedy = "end the curve with G5.3";
            return Err(Problem::Limit { what: "points of a curve", most: MOST_POINTS as u64, remedy });
        }
        if weight > 0.0 { Ok(()) } else { Err(wrong("has a weight that is not positive: correct it")) }
    }

    /// G5.3, G6.3: the curve is complete.
    pub(super) fn finish(&mut self, state: &mut State, actions: &mut Vec<Action>) -> Result<(), Problem> {
        let Self { points, knots, order, .. } = std::mem::take(self);
        state.modes.motion = None;
        if points.len() < order.max(2) {
            return Err(wrong("has fewer control points than its order: give more"));
        }
        let is_valid = knots.len() == points.len() + order
            && knots.windows(2).all(|pair| pair[0] <= pair[1])
            && knots[points.len()] > knots[order - 1];
        let knots = if is_valid { knots } else { clamped(points.len(), order) };
        let last = points[points.len() - 1];
        let mut goal = state.position;
        (goal[0], goal[1], goal[2]) = (last[0], last[1], last[2]);
        let feed = feed(state, &state.position, &goal, actions)?;
        for span in order - 1..points.len() {
            let (begin, end) = (knots[span], knots[span + 1]);
            if begin >= end {
                continue;
            }
            for index in 1..=OF_SPAN {
                let at = begin + (end - begin) * (index as f64 / OF_SPAN as f64);
                let point = value(&points, &knots, order, span, at);
                let mut next = state.position;
                next[..3].copy_from_slice(&point);
                actions.push(straight(state, &state.position, &next, feed));
                state.position = next;
            }
        }
        Ok(())
    }
}

/// How many chords are as near as asked: an eighth of the second difference, over the square of their number.
fn chords(points: &[[f64; 2]; 4]) -> u32 {
    let bend = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (a[0] - 2.0 * b[0] + c[0]).hypot(a[1] - 2.0 * b[1] + c[1]);
    let most = bend(points[0], points[1], points[2]).max(bend(points[1], points[2], points[3]));
    (6.0 * most / (8.0 * NEAR)).sqrt().ceil().clamp(1.0, MOST_CHORDS) as u32
}

/// Knots with which the curve begins and ends in its first and last point.
fn clamped(points: usize, order: usize) -> Vec<f64> {
    let inner = (points - order + 1) as f64;
    (0..points + order).map(|index| (index as f64 - order as f64 + 1.0).clamp(0.0, inner)).collect()
}

/// The point of the curve, by de Boor's algorithm, in homogeneous coordinates.
fn value(points: &[[f64; 4]], knots: &[f64], order: usize, span: usize, at: f64) -> [f64; 3] {
    let first = span + 1 - order;
    let mut near: Vec<[f64; 4]> =
        points[first..=span].iter().map(|[x, y, z, weight]| [x * weight, y * weight, z * weight, *weight]).collect();
    for level in 1..order {
        for index in (level..order).rev() {
            let (low, high) = (knots[first + index], knots[first + index + order - level]);
            let share = if high > low { (at - low) / (high - low) } else { 0.0 };
            let (left, right) = (near[index - 1], near[index]);
            near[index] = std::array::from_fn(|axis| left[axis] + share * (right[axis] - left[axis]));
        }
    }
    let [x, y, z, weight] = near[order - 1];
    [x / weight, y / weight, z / weight]
}

fn wrong(why: &'static str) -> Problem {
    Problem::Cycle { code: "the curve".to_owned(), why }
}
