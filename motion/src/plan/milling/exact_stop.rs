//! The time of a cut from rest to rest, with constant acceleration up to the feed, and constant deceleration.

use closedform_kernels::milling_time;

use super::cut::Cut;

/// Time of the cut, and its largest speed.
pub(super) fn time(cut: &Cut) -> (f64, f64) {
    let Cut { length, acceleration, speed, .. } = *cut;
    let peak = milling_time::constant_acceleration(1.0, 0.0, acceleration, length / 2.0).speed;
    if peak <= speed {
        return (milling_time::cut_time(1.0, acceleration, length), peak);
    }
    // At the feed all the way, and once more the time to reach it: while speeding up, half of the way is missing.
    (length / speed + speed / acceleration, speed)
}
