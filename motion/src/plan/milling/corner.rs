//! How fast a corner may be passed.

use closedform_kernels::look_ahead;

use super::cut::Cut;
use super::machine::Machine;
use super::rules::{Corner, Rules};

/// A shorter move may be a piece of a curve, in mm.
const PIECE: f64 = 1.0;

/// One that turns by less than this may be, in radians: an eighth of the circle.
const LITTLE: f64 = std::f64::consts::FRAC_PI_4;

/// The largest speed from one cut into the next.
pub(super) fn speed(rules: &Rules, machine: &Machine, before: &Cut, after: &Cut) -> f64 {
    let (Some([_, u]), Some([w, _])) = (before.direction, after.direction) else { return 0.0 };
    let feed = before.speed.min(after.speed);
    if let Corner::Jump(jumps) = rules.corner {
        return by_jump(jumps, u, w, feed);
    }
    let turn = look_ahead::half_turn(u[0], u[1], u[2], w[0], w[1], w[2]);
    if turn.sine == 0.0 {
        return feed;
    }
    let acceleration = across(machine, u, w, 2.0 * turn.sine).min(along(machine, after));
    let deviation = match rules.corner {
        Corner::Deviation(deviation) => deviation,
        Corner::Square(speed) => look_ahead::deviation(speed, acceleration),
        Corner::Jump(_) => 0.0,
    };
    let junction = look_ahead::junction_speed(turn.cosine, turn.sine, acceleration, deviation);
    let curve = if rules.follows_curves { on_curve(turn.sine, acceleration, after.length) } else { f64::INFINITY };
    feed.min(junction).min(curve)
}

/// The speed from rest, and to it: the jump that classic jerk allows.
pub(super) fn from_rest(rules: &Rules, cut: &Cut) -> f64 {
    match (rules.corner, cut.direction) {
        (Corner::Jump(jumps), Some([w, _])) => by_jump(jumps, [0.0; 3], w, cut.speed),
        _ => 0.0,
    }
}

/// What the controller limits along the path, where it does.
fn along(machine: &Machine, cut: &Cut) -> f64 {
    if machine.path_acceleration[0].is_finite() { cut.acceleration } else { f64::INFINITY }
}

/// What the axes allow across the corner, where the speed changes: the least limit by its share of the change.
fn across(machine: &Machine, u: [f64; 3], w: [f64; 3], change: f64) -> f64 {
    let of_axis = |axis: usize| machine.acceleration[axis] * change / (w[axis] - u[axis]).abs();
    (0..3).map(of_axis).fold(f64::INFINITY, |least, limit| if limit < least { limit } else { least })
}

/// The speed on a curve that turns by this angle along this length.
fn on_curve(sine: f64, acceleration: f64, length: f64) -> f64 {
    let turn = 2.0 * sine.min(1.0).asin();
    if length >= PIECE || turn >= LITTLE || turn == 0.0 {
        return f64::INFINITY;
    }
    look_ahead::centripetal_speed(acceleration, length / turn)
}

/// So fast that no axis jumps by more than it may. One that turns back counts by the larger of both speeds.
fn by_jump(jumps: [f64; 3], u: [f64; 3], w: [f64; 3], feed: f64) -> f64 {
    let jump = |axis: usize| match u[axis] * w[axis] < 0.0 {
        true => u[axis].abs().max(w[axis].abs()),
        false => (w[axis] - u[axis]).abs(),
    };
    let most = |axis: usize| if jump(axis) > 0.0 { jumps[axis] / jump(axis) } else { f64::INFINITY };
    (0..3).map(most).fold(feed, f64::min)
}
