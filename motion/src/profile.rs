//! A profile: the motion of one axis, segment after segment.

use closedform_player::Player;

use crate::segment::{Sample, Segment, State};

/// Why segments do not make a profile.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// No segments.
    #[error("a profile needs a segment: add one")]
    Empty,
    /// A duration is negative or a number is not finite.
    #[error("segment {segment} is not a motion: its duration must not be negative, and all its numbers finite")]
    NotFinite {
        /// The index.
        segment: usize,
    },
    /// A segment starts elsewhere than the one before ends.
    #[error("segment {segment} starts at {start}, the one before ends at {end}: positions must meet")]
    Jump {
        /// The index of the later one.
        segment: usize,
        /// Where the one before ends.
        end: f64,
        /// Where this one starts.
        start: f64,
    },
}

/// The motion of one axis: segments whose positions meet exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    segments: Vec<Segment>,
    /// When each segment starts, and the last one ends.
    times: Vec<f64>,
}

impl Profile {
    /// Segments in order. The position of each end is exactly that of the next start.
    pub fn new(segments: Vec<Segment>) -> Result<Self, ProfileError> {
        if segments.is_empty() {
            return Err(ProfileError::Empty);
        }
        let bad = |segment: &Segment| segment.duration < 0.0 || numbers(segment).iter().any(|n| !n.is_finite());
        if let Some(segment) = segments.iter().position(bad) {
            return Err(ProfileError::NotFinite { segment });
        }
        for (index, pair) in segments.windows(2).enumerate() {
            let (end, start) = (pair[0].end.position, pair[1].start.position);
            if end != start {
                return Err(ProfileError::Jump { segment: index + 1, end, start });
            }
        }
        let times = times(&segments);
        Ok(Self { segments, times })
    }

    /// The segments.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// When each segment starts, and at last when the profile ends, in s.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// In s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// Where it starts.
    #[must_use]
    pub fn start(&self) -> State {
        self.segments[0].start
    }

    /// Where it ends.
    #[must_use]
    pub fn end(&self) -> State {
        self.segments[self.segments.len() - 1].end
    }

    /// At a time; before the start as at the start, after the end as at the end. Where two segments meet, the later
    /// one.
    #[must_use]
    pub fn at(&self, time: f64) -> Sample {
        self.in_segment(self.segment_at(time), time)
    }

    /// As a controller plays it: the same bits, without allocation.
    #[must_use]
    pub fn player(&self) -> Player<'_> {
        Player::new(&self.segments, &self.times).expect("one time more than segments")
    }

    /// The index of the segment at a time: of two that meet there the later one.
    pub(crate) fn segment_at(&self, time: f64) -> usize {
        self.player().segment_at(time)
    }

    /// At a time, by the segment it lies in.
    pub(crate) fn in_segment(&self, index: usize, time: f64) -> Sample {
        self.player().in_segment(index, time)
    }
}

/// When each segment starts and the last one ends, each sum rounded about once: what rounding leaves is carried along.
fn times(segments: &[Segment]) -> Vec<f64> {
    let mut times = vec![0.0];
    let (mut sum, mut carry) = (0.0, 0.0);
    for segment in segments {
        let next: f64 = sum + segment.duration;
        let part = next - sum;
        carry += (sum - (next - part)) + (segment.duration - part);
        sum = next;
        times.push((sum + carry).max(times[times.len() - 1]));
    }
    times
}

fn numbers(segment: &Segment) -> [f64; 9] {
    let Segment { duration, start, end, jerk, snap } = *segment;
    let (a, b) = (start, end);
    [duration, a.position, a.velocity, a.acceleration, b.position, b.velocity, b.acceleration, jerk, snap]
}
