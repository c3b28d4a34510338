//! The rows of a motion: where its segments meet, and as many between as cubic interpolation needs.

use super::TableError;
use crate::motion::{Axis, Knot, Motion};
use crate::segment::{Segment, State};

/// No segment needs more rows in earnest.
const MOST: f64 = (1 << 20) as f64;

/// The rows of a motion, in order; made by [`knots`].
#[derive(Debug, Clone)]
pub struct Knots<'a> {
    motion: &'a Motion,
    /// Sums of durations that differ by less are one time, rounded differently.
    gap: f64,
    times: std::vec::IntoIter<f64>,
}

/// The states of all axes wherever a segment of one begins or ends, and between, so that the cubics through them (cubic
/// Hermite interpolation) stay within `tolerance`, in m, of every axis.
///
/// A segment of constant jerk is such a cubic. One of the duration T with a snap s is off by no more than |s|*(T/n)^4/384
/// when it is divided into n.
///
/// # Errors
///
/// The tolerance is not positive or asks for more than 2^20 rows a segment; or a velocity jumps by so much that no cubic
/// stays within it: beside a jump J, in a row's time h, the cubic is off by up to 4*J*h/27.
pub fn knots(motion: &Motion, tolerance: f64) -> Result<Knots<'_>, TableError> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(TableError::Tolerance { tolerance });
    }
    let duration = motion.duration();
    let segments = motion.axes().iter().map(|axis| axis.profile.segments().len()).max().unwrap_or(0);
    let gap = segments as f64 * f64::EPSILON * duration;
    let mut times = vec![duration];
    for axis in motion.axes() {
        check_jumps(axis, duration, gap, tolerance)?;
        let starts = axis.profile.times();
        for (segment, start) in axis.profile.segments().iter().zip(starts) {
            let count = pieces(segment, tolerance)?;
            times.extend((0..count).map(|index| start + segment.duration * (f64::from(index) / f64::from(count))));
        }
        times.push(axis.profile.duration());
    }
    Ok(Knots { motion, gap, times: distinct(times, gap).into_iter() })
}

/// How many cubics a segment takes.
fn pieces(segment: &Segment, tolerance: f64) -> Result<u32, TableError> {
    let count = segment.duration * (segment.snap.abs() / tolerance / 384.0).sqrt().sqrt();
    if count <= MOST { Ok((count.ceil() as u32).max(1)) } else { Err(TableError::Tolerance { tolerance }) }
}

/// In order, and of those that lie closer than `gap` only one: the first, or the last of all.
fn distinct(mut times: Vec<f64>, gap: f64) -> Vec<f64> {
    times.sort_by(f64::total_cmp);
    let end = times.last().copied();
    times.dedup_by(|later, earlier| *later - *earlier <= gap);
    if let (Some(last), Some(end), true) = (times.last_mut(), end, end.is_some_and(|end| end > 0.0)) {
        *last = end;
    }
    times
}

/// Whether velocities jump, at the ends of segments and of the profile, by more than the table can hide.
fn check_jumps(axis: &Axis, duration: f64, gap: f64, tolerance: f64) -> Result<(), TableError> {
    let profile = &axis.profile;
    let check = |time: f64, jump: f64, beside: f64| {
        let distance = 4.0 / 27.0 * jump.abs() * beside;
        let error = TableError::Jump { axis: axis.name.clone(), time, jump, distance, tolerance };
        if distance <= tolerance { Ok(()) } else { Err(error) }
    };
    for (pair, time) in profile.segments().windows(2).zip(&profile.times()[1..]) {
        check(*time, pair[1].start.velocity - pair[0].end.velocity, pair[0].duration)?;
    }
    let left = duration - profile.duration();
    if left > gap { check(profile.duration(), profile.end().velocity, left) } else { Ok(()) }
}

impl Knots<'_> {
    fn state(&self, axis: &Axis, time: f64) -> State {
        if time - axis.profile.duration() > self.gap {
            return State::rest(axis.profile.end().position);
        }
        let sample = axis.profile.at(time);
        State { position: sample.position, velocity: sample.velocity, acceleration: sample.acceleration }
    }
}

impl Iterator for Knots<'_> {
    type Item = Knot;

    fn next(&mut self) -> Option<Knot> {
        let time = self.times.next()?;
        Some(Knot { time, states: self.motion.axes().iter().map(|axis| self.state(axis, time)).collect() })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.times.size_hint()
    }
}

impl ExactSizeIterator for Knots<'_> {}
