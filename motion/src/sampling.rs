//! Sampling: a profile at a rate, or at given times into slices.

use crate::error::PlanError;
use crate::profile::Profile;
use crate::segment::Sample;

/// Slices that should be of one length and are not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{times} times cannot be sampled into {samples} places: give slices of one length")]
pub struct LengthMismatch {
    /// How many times are asked for.
    pub times: usize,
    /// How many places there are.
    pub samples: usize,
}

/// The samples of a profile at a rate, with their times; from [`Profile::samples`].
#[derive(Debug, Clone)]
pub struct Samples<'a> {
    profile: &'a Profile,
    rate: f64,
    next: u64,
    segment: usize,
    done: bool,
}

impl Iterator for Samples<'_> {
    type Item = (f64, Sample);

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let tick = self.next as f64 / self.rate;
        self.done = tick >= self.profile.duration();
        self.next += 1;
        let time = tick.min(self.profile.duration());
        self.segment = self.profile.segment_from(self.segment, time);
        Some((time, self.profile.in_segment(self.segment, time)))
    }
}

impl Profile {
    /// At the times 0, 1/rate, 2/rate, .. before the end, and at the end; the rate in 1/s, positive.
    pub fn samples(&self, rate: f64) -> Result<Samples<'_>, PlanError> {
        if !(rate > 0.0 && rate.is_finite()) {
            return Err(PlanError::Input {
                name: "rate",
                value: rate,
                remedy: "give a positive number of samples a second",
            });
        }
        Ok(Samples { profile: self, rate, next: 0, segment: 0, done: false })
    }

    /// At given times, as [`Profile::at`] each; fastest where the times rise.
    pub fn sample_into(&self, times: &[f64], samples: &mut [Sample]) -> Result<(), LengthMismatch> {
        if times.len() != samples.len() {
            return Err(LengthMismatch { times: times.len(), samples: samples.len() });
        }
        let (mut segment, mut before) = (0, f64::NEG_INFINITY);
        for (place, &time) in samples.iter_mut().zip(times) {
            segment = if time >= before { self.segment_from(segment, time) } else { self.segment_at(time) };
            *place = self.in_segment(segment, time);
            before = time;
        }
        Ok(())
    }

    /// The segment at a time that is not before the start of segment `index`.
    fn segment_from(&self, mut index: usize, time: f64) -> usize {
        while index + 1 < self.segments().len() && self.times()[index + 1] <= time {
            index += 1;
        }
        index
    }
}
