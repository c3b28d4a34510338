//! What both axes do from one place of a line to the same place of the next: the pieces between all their knots.

use super::gap::Timed;
use crate::segment::{Segment, State};

/// What both axes do between two knots. The fly axis as on a first line, the step axis from the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// On the clock of the pattern.
    pub at: f64,
    /// In s.
    pub duration: f64,
    pub fly: [State; 2],
    pub step: [State; 2],
}

/// Pieces from the first start of the fly axis to its last end. The step axis rests where it has no segment: at `before`,
/// up to its first, and where the last one ended. Knots of both that differ by less than `same` are one.
pub(super) fn pieces(
    fly: &[Timed],
    step: &[Timed],
    before: f64,
    same: f64,
    seconds: impl Fn(f64) -> f64,
) -> Vec<Piece> {
    let knots: Vec<f64> = fly.iter().flat_map(|timed| [timed.start, timed.end]).collect();
    let snap = |at: f64| knots.iter().copied().find(|knot| (knot - at).abs() < same).unwrap_or(at);
    let step: Vec<Timed> =
        step.iter().map(|timed| Timed { start: snap(timed.start), end: snap(timed.end), ..*timed }).collect();
    let (begin, end) = (fly.first().map_or(0.0, |timed| timed.start), fly.last().map_or(0.0, |timed| timed.end));
    let mut times: Vec<f64> =
        knots.iter().copied().chain(step.iter().flat_map(|timed| [timed.start, timed.end])).collect();
    times.retain(|at| (begin..=end).contains(at));
    times.sort_by(f64::total_cmp);
    times.dedup();
    let piece = |pair: &[f64]| {
        let (at, end) = (pair[0], pair[1]);
        let states = |track: &[Timed], rest: f64| {
            let resting = track.iter().rfind(|timed| timed.end <= at).map_or(rest, |timed| timed.segment.end.position);
            match track.iter().find(|timed| timed.start <= at && at < timed.end) {
                Some(timed) => [at, end].map(|time| state(timed, time, &seconds)),
                None => [State::rest(resting); 2],
            }
        };
        let whole = fly.iter().chain(&step).find(|timed| timed.start == at && timed.end == end);
        // of a whole segment its own, without the rounding of what it is counted from
        let duration = whole.map_or_else(|| seconds(end - at), |timed| timed.segment.duration);
        Piece { at, duration, fly: states(fly, 0.0), step: states(&step, before) }
    };
    times.windows(2).map(piece).collect()
}

/// At a time of a segment: exactly as it says at its ends.
fn state(timed: &Timed, at: f64, seconds: &impl Fn(f64) -> f64) -> State {
    let Segment { start, end, .. } = timed.segment;
    match () {
        () if at == timed.start => start,
        () if at == timed.end => end,
        () => State::from(timed.segment.at(seconds(at - timed.start))),
    }
}
