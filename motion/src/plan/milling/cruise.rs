//! Klipper's minimum cruise ratio: short moves between corners are cruised more slowly, so that a part of the way that a
//! move could speed up and brake on is driven at one speed.
//!
//! Besides the speeds that the acceleration allows, each junction has a smoothed one, as if the moves could only use the
//! rest of it. A move that speeds up in the smoothed plan has its peak there, and the moves that brake behind it keep
//! below that. All numbers are squares of speeds, as in Klipper's `toolhead.py`.

use super::cut::Cut;

/// What is known of a move when it is added.
#[derive(Debug, Clone, Copy)]
pub(super) struct Squares {
    /// The largest at its begin: by its corner and the moves before it.
    start: f64,
    /// The same in the smoothed plan.
    smoothed: f64,
    /// Of the cut itself.
    top: f64,
    /// By how much it grows along the cut.
    rise: f64,
    /// The same in the smoothed plan.
    smooth_rise: f64,
}

impl Squares {
    /// Of a cut behind another, with the largest speed of the corner between them; at rest, where there is none before.
    pub(super) fn of(cut: &Cut, ratio: f64, corner: f64, before: Option<&Self>) -> Self {
        let rise = 2.0 * cut.acceleration * cut.length;
        let from = |before: &Self| {
            let start = (corner * corner).min(before.start + before.rise);
            (start, start.min(before.smoothed + before.smooth_rise))
        };
        let (start, smoothed) = before.map_or((0.0, 0.0), from);
        Self { start, smoothed, top: cut.speed * cut.speed, rise, smooth_rise: rise * (1.0 - ratio) }
    }
}

/// How fast the first of the known moves may cruise, and the peak for moves that brake behind it. The moves come from the
/// last one on; `before` is the peak for the first one, should it brake.
pub(super) fn of_first<'a>(moves: impl Iterator<Item = &'a Squares>, before: f64) -> [f64; 2] {
    let (mut end, mut smooth_end, mut peak) = (0.0_f64, 0.0_f64, 0.0_f64);
    let (mut is_delayed, mut found) = (false, [0.0; 2]);
    for one in moves {
        let (reachable, smooth_reachable) = (end + one.rise, smooth_end + one.smooth_rise);
        let (start, smoothed) = (one.start.min(reachable), one.smoothed.min(smooth_reachable));
        if smoothed < smooth_reachable {
            // it brakes too, or those behind it only brake: the peak is here, otherwise in a later move
            if smoothed + one.smooth_rise > smooth_end || is_delayed {
                peak = one.top.min((smoothed + smooth_reachable) / 2.0);
                is_delayed = false;
            }
            found = [((start + reachable) / 2.0).min(one.top).min(peak), peak];
        } else {
            is_delayed = true;
            found = [before.min(start); 2];
        }
        (end, smooth_end) = (start, smoothed);
    }
    found
}
