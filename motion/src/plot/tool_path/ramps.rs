//! Where a move is at a time: a ramp up, the way at the largest speed, and a ramp down.

use crate::plan::milling::Row;

/// Of one move.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ramps {
    entry: f64,
    peak: f64,
    exit: f64,
    up: f64,
    down: f64,
    time: f64,
    length: f64,
}

impl Ramps {
    /// What speeds, length and time of a move say of its ramps: with one acceleration for both,
    /// T = L/p + ((p-v0)^2 + (p-v1)^2)/(2*a*p).
    pub(super) fn of(row: &Row) -> Self {
        let Row { entry, peak, exit, time, length, .. } = *row;
        let (grow, fall) = (peak - entry, peak - exit);
        let missing = 2.0 * peak * (time - length / peak);
        let per_speed = if missing > 0.0 { missing / (grow * grow + fall * fall) } else { 0.0 };
        let per_speed = if per_speed.is_finite() { per_speed } else { 0.0 };
        let (up, down) = (grow * per_speed, fall * per_speed);
        // Arcs of many chords have more ramps than two: what does not fit is shortened.
        let fit = if up + down > time { time / (up + down) } else { 1.0 };
        Self { entry, peak, exit, up: up * fit, down: down * fit, time, length }
    }

    /// Times at which the motion changes, and some between them.
    pub(super) fn times(&self, between: u32) -> impl Iterator<Item = f64> {
        let Self { up, down, time, .. } = *self;
        let mut times: Vec<f64> = (0..=between).map(|index| time * f64::from(index) / f64::from(between)).collect();
        times.extend([up, time - down]);
        times.sort_by(f64::total_cmp);
        times.into_iter()
    }

    /// Speed at a time.
    pub(super) fn speed(&self, at: f64) -> f64 {
        let Self { entry, peak, exit, up, down, time, .. } = *self;
        if at < up {
            return entry + (peak - entry) * at / up;
        }
        if at > time - down { peak + (exit - peak) * (at - (time - down)) / down } else { peak }
    }

    /// Share of the way at a time, from 0 to 1.
    pub(super) fn share(&self, at: f64) -> f64 {
        let Self { entry, peak, exit, up, down, time, length } = *self;
        let way = if at < up {
            (entry + self.speed(at)) / 2.0 * at
        } else if at > time - down {
            let rest = time - at;
            length - (exit + self.speed(at)) / 2.0 * rest
        } else {
            (entry + peak) / 2.0 * up + peak * (at - up)
        };
        if length > 0.0 { (way / length).clamp(0.0, 1.0) } else { 1.0 }
    }
}
