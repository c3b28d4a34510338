//! A player of segments: any time by a search, or rising times each in a step or two.

use crate::segment::{Sample, Segment};

/// The segments of one axis, and when each starts and the last one ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Player<'a> {
    segments: &'a [Segment],
    times: &'a [f64],
}

impl<'a> Player<'a> {
    /// Segments in order, and one time more than there are; none where there are no segments or other times.
    #[must_use]
    pub const fn new(segments: &'a [Segment], times: &'a [f64]) -> Option<Self> {
        if segments.is_empty() || times.len() != segments.len() + 1 {
            return None;
        }
        Some(Self { segments, times })
    }

    /// When the last segment ends, in s.
    #[must_use]
    pub const fn duration(&self) -> f64 {
        self.times[self.segments.len()]
    }

    /// At a time; before the start as at the start, after the end as at the end. Where two segments meet, the later one.
    #[must_use]
    pub fn at(&self, time: f64) -> Sample {
        self.in_segment(self.segment_at(time), time)
    }

    /// A cursor at the start.
    #[must_use]
    pub const fn cursor(self) -> Cursor<'a> {
        Cursor { player: self, segment: 0 }
    }

    /// The index of the segment at a time: of two that meet there the later one.
    #[must_use]
    pub fn segment_at(&self, time: f64) -> usize {
        let later = self.times.partition_point(|start| *start <= time);
        later.saturating_sub(1).min(self.segments.len() - 1)
    }

    /// At a time, by the segment of an index.
    ///
    /// # Panics
    ///
    /// There is no such segment.
    #[must_use]
    pub fn in_segment(&self, index: usize, time: f64) -> Sample {
        let segment = &self.segments[index];
        segment.at((time - self.times[index]).clamp(0.0, segment.duration))
    }
}

/// A player whose times mostly rise, as those of a control loop do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cursor<'a> {
    player: Player<'a>,
    segment: usize,
}

impl Cursor<'_> {
    /// As [`Player::at`], fastest where times rise.
    pub fn at(&mut self, time: f64) -> Sample {
        let Player { segments, times } = self.player;
        if time < times[self.segment] {
            self.segment = self.player.segment_at(time);
        }
        while self.segment + 1 < segments.len() && times[self.segment + 1] <= time {
            self.segment += 1;
        }
        self.player.in_segment(self.segment, time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segment::State;

    #[test]
    fn a_cursor_has_the_same_bits_in_any_order() {
        let mut state = State::rest(0.0);
        let segments: [Segment; 5] = core::array::from_fn(|index| {
            let segment = Segment::with_jerk(state, 0.1 + 0.3 * index as f64, index as f64 - 2.0);
            state = segment.end;
            segment
        });
        let mut times = [0.0; 6];
        for (index, segment) in segments.iter().enumerate() {
            times[index + 1] = times[index] + segment.duration;
        }
        let player = Player::new(&segments, &times).expect("a player");
        let mut cursor = player.cursor();
        for time in [-1.0, 0.0, 0.05, 0.1, 0.5, 2.0, 0.3, 9.0, 0.0].into_iter().chain(times) {
            assert_eq!(cursor.at(time), player.at(time), "{time}");
        }
        assert!(Player::new(&segments, &times[1..]).is_none() && Player::new(&[], &[0.0]).is_none());
    }
}
