//! Moves of a climb: on the bits of an input, by powers of two, towards zeros of subterms, and between local maxima.

use super::starts::Sampling;
use super::target::Target;
use super::zeros::Zeros;
use closedform_project::sample::Random;

/// Bits of a fraction.
const FRACTION: u64 = 52;

/// Moves points of one kernel.
pub(super) struct Mover<'a> {
    target: &'a Target<'a>,
    zeros: Zeros,
}

impl<'a> Mover<'a> {
    pub(super) fn new(target: &'a Target<'a>) -> Self {
        Mover { target, zeros: Zeros::of(target) }
    }

    /// The point with one input moved, or a few; `other` is a point to take coordinates from.
    pub(super) fn moved(&self, point: &[f64], other: Option<&[f64]>, random: &mut Random) -> Vec<f64> {
        let mut moved = point.to_vec();
        let count = 1 + random.below(3).saturating_sub(random.below(2));
        for _ in 0..count {
            let input = random.below(point.len() as u64) as usize;
            moved[input] = match random.below(24) {
                0..=1 => self.towards_zero(&moved, input, random),
                2 => other.map_or(moved[input], |other| other[input]),
                3 => Sampling::Octaves.draw(&self.target.inputs[input], random),
                4 => -moved[input],
                _ => stepped(moved[input], random),
            };
        }
        moved
    }

    /// The input at a zero of some subterm, or a power of two of it away.
    fn towards_zero(&self, point: &[f64], input: usize, random: &mut Random) -> f64 {
        let term = random.below(self.zeros.len() as u64) as usize;
        let zero = if term < self.zeros.len() { self.zeros.solve(term, input, point) } else { None };
        let Some(zero) = zero else { return stepped(point[input], random) };
        let distance = 1.0 / (1_u64 << random.below(FRACTION + 1)) as f64;
        match random.below(4) {
            0 => zero,
            1 => ranked(zero, random.below(9) as i64 - 4),
            2 => zero * (1.0 + distance),
            _ => zero * (1.0 - distance),
        }
    }
}

/// A move on the bits of one number.
fn stepped(value: f64, random: &mut Random) -> f64 {
    let low = (1_u64 << random.below(FRACTION + 1)) - 1;
    let flip = |mask: u64| f64::from_bits(value.to_bits() ^ mask);
    match random.below(12) {
        0 => value * 2.0,
        1 => value * 0.5,
        2 => value * f64::from_bits((1023 + random.below(17) - 8) << FRACTION),
        3 => ranked(value, 1 << random.below(FRACTION)),
        4 => ranked(value, -(1 << random.below(FRACTION))),
        5 => ranked(value, random.below(33) as i64 - 16),
        6..=7 => flip(random.bits() & low),
        8 => f64::from_bits(value.to_bits() & !low),
        9 => f64::from_bits(value.to_bits() | low),
        _ => flip(1 << random.below(FRACTION)),
    }
}

/// The number so many doubles farther from zero.
fn ranked(value: f64, by: i64) -> f64 {
    f64::from_bits(value.to_bits().wrapping_add_signed(by))
}
