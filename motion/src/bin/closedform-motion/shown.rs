//! A milling job as a motion to draw: each move with constant acceleration to its speed, and from it.

use closedform_motion::plan::milling::{Machine, Milling, Model, Move, Row};
use closedform_motion::plot::PlotError;
use closedform_motion::{Axis, Limits, Motion, PlanError, Profile, Segment, State};

use crate::error::Outcome;

/// How many moves are drawn: more would be a carpet, and all in memory.
pub const MOST: usize = 20_000;

/// In the unit of motions, m.
const MILLIMETRE: f64 = 1e-3;

/// The axes X, Y, Z of some moves, without dwells.
pub fn shown(milling: &Milling, moves: &[Move]) -> Outcome<Motion> {
    let mut timer = Milling::new(*milling.machine(), Model::ExactStop)?.timer();
    moves.iter().try_for_each(|cut| timer.add(cut))?;
    let rows: Vec<Row> = std::iter::from_fn(|| timer.next_row()).collect();
    if rows.iter().all(|row| row.time <= 0.0) {
        return Err(PlotError::Empty { what: "no move has a length" }.into());
    }
    let axis = |index: usize| {
        let segments = rows.iter().flat_map(|row| segments(row, index)).collect();
        let profile = Profile::new(segments).map_err(|_| PlanError::Range { what: "the picture of the path" })?;
        Ok(Axis { name: ["X", "Y", "Z"][index].to_owned(), profile, limits: limits(milling.machine(), index) })
    };
    Ok(Motion::new([0, 1, 2].into_iter().map(axis).collect::<Outcome<_>>()?))
}

fn limits(machine: &Machine, axis: usize) -> Limits {
    Limits {
        velocity: machine.speed[axis] * MILLIMETRE,
        acceleration: machine.acceleration[axis] * MILLIMETRE,
        jerk: f64::INFINITY,
    }
}

/// Speeding up, going on and braking of one axis. A move of the length L that reaches the speed p in the time T speeds up
/// for T - L/p.
fn segments(row: &Row, axis: usize) -> Vec<Segment> {
    let (from, to) = (row.cut.from[axis] * MILLIMETRE, row.cut.to[axis] * MILLIMETRE);
    if row.time <= 0.0 {
        return Vec::new();
    }
    let ramp = (row.time - row.length / row.peak).clamp(0.0, row.time / 2.0);
    let speed = (to - from) / (row.time - ramp);
    let (near, far) = (from + speed * ramp / 2.0, to - speed * ramp / 2.0);
    let (acceleration, fast) = (speed / ramp, |position| State::cruise(position, speed));
    let accelerated = |state: State, acceleration| State { acceleration, ..state };
    let still = row.time - 2.0 * ramp;
    vec![
        Segment::between(accelerated(State::rest(from), acceleration), accelerated(fast(near), acceleration), ramp),
        Segment::between(fast(near), fast(far), still),
        Segment::between(accelerated(fast(far), -acceleration), accelerated(State::rest(to), -acceleration), ramp),
    ]
}
