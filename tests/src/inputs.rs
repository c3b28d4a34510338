//! Input makers: points inside, and outside, a domain, chosen where it hurts.

use closedform::{Info, Input};
use closedform_syntax::{BASES, Dimension};

use crate::domain::Domain;
use crate::random::Random;
use crate::reference::Oracle;
use crate::scaling::{dimensions, factor, whole};
use crate::zeros::{Zeros, subterms};

/// The exponents of the least number, of the least normal one, and of the largest power of two.
const LEAST: i32 = -1_074;
const NORMAL: i32 = -1_022;
const LARGEST: i32 = 1_023;

/// The exponents of `Maker::Wide`.
const WIDE: f64 = 100.0;

/// The exponents of `Maker::Octaves`.
const OCTAVES: f64 = 20.0;

/// Candidates that are tried before a maker gives up.
const TRIES: usize = 1_000_000;

/// A way to choose points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Maker {
    /// At an edge of the domain, or a nudge away from it.
    Edges,
    /// Where an input, a sum or a difference inside the reference vanishes, or a nudge away from there.
    Subterms,
    /// Two inputs of one unit equal up to sign and a small factor, or a nudge away from that.
    NearEqual,
    /// Uniform in the logarithms of the typical magnitudes.
    Logarithmic,
    /// Uniform over bit patterns of exponents around the typical ones.
    Bits,
    /// Uniform over bit patterns of exponents far beyond the typical ones.
    Wide,
    /// A sign times 2^U(-20, 20).
    Octaves,
    /// Uniform over reals.
    Reals,
    /// Of all exponents, where steps over- and underflow: uniform over bit patterns; products of a few inputs near the
    /// largest and the smallest numbers; some inputs subnormal, zero or huge; other points in very large or small units.
    Extreme,
}

impl Maker {
    /// Every maker.
    pub const ALL: [Maker; 9] = [
        Maker::Edges,
        Maker::Subterms,
        Maker::NearEqual,
        Maker::Logarithmic,
        Maker::Bits,
        Maker::Wide,
        Maker::Octaves,
        Maker::Reals,
        Maker::Extreme,
    ];

    /// Samplings that know nothing of the kernel but its domain: bit patterns, octaves, reals.
    pub const SAMPLINGS: [Maker; 3] = [Maker::Wide, Maker::Octaves, Maker::Reals];
}

/// Points of one kernel and where they come from.
#[derive(Clone, Debug)]
pub struct Points {
    /// The maker and the seed, for failures.
    pub origin: String,
    /// The inputs of each point, in order.
    pub list: Vec<Vec<f64>>,
}

/// The inputs of a kernel: its domain, and where expressions in them vanish.
#[derive(Clone, Debug)]
pub struct Space {
    info: &'static Info,
    domain: Domain,
    edges: Vec<Zeros>,
    subterms: Vec<Zeros>,
    /// The signs that each input may have.
    signs: Vec<Vec<f64>>,
    /// Pairs of inputs of one unit.
    pairs: Vec<(usize, usize)>,
    /// The units of the inputs.
    units: Vec<Dimension>,
}

impl Space {
    /// The inputs of the kernel that `info` describes.
    pub fn new(info: &'static Info, oracle: &Oracle) -> Self {
        let domain = Domain::new(info);
        let zeros = |expressions: Vec<_>| {
            expressions.into_iter().filter_map(|expression| Zeros::new(expression, oracle.names())).collect()
        };
        let mut inside = Vec::new();
        oracle.bodies().iter().for_each(|body| subterms(body, &mut inside));
        let (edges, subterms) = (zeros(domain.edges()), zeros(inside));
        let signs = info.inputs.iter().enumerate().map(|(position, input)| signs(&domain, position, input)).collect();
        let units = dimensions(info, info.inputs.iter().map(|input| input.unit));
        let units = units.unwrap_or_else(|error| panic!("{error}"));
        Space { info, domain, edges, subterms, signs, pairs: pairs(info.inputs), units }
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// Whether the kernel has points of this kind.
    pub fn has(&self, maker: Maker) -> bool {
        match maker {
            Maker::Edges => !self.edges.is_empty(),
            Maker::Subterms => !self.subterms.is_empty(),
            Maker::NearEqual => !self.pairs.is_empty(),
            _ => true,
        }
    }

    /// Whether a point is one to judge: inside the domain.
    pub fn admits(&self, point: &[f64]) -> bool {
        self.domain.contains(point)
    }

    /// `count` points inside the domain, of extreme ones a quarter, since their oracle takes long; none where the kernel has
    /// none of this kind.
    pub fn inside(&self, maker: Maker, seed: u64, count: usize) -> Points {
        let mut random = Random::new(seed, &format!("{} {maker:?}", self.info.name));
        let count = if maker == Maker::Extreme { count.div_ceil(4) } else { count };
        let count = if self.has(maker) { count } else { 0 };
        let point = |_| self.first(|| self.candidate(maker, &mut random), |point| self.admits(point));
        Points { origin: format!("{maker:?}, seed {seed}"), list: (0..count).map(point).collect() }
    }

    /// `count` points outside the domain, at its edges, of wrong signs and at zeros; none where the kernel takes everything.
    pub fn outside(&self, seed: u64, count: usize) -> Points {
        let mut random = Random::new(seed, &format!("{} outside", self.info.name));
        let count = if self.has(Maker::Edges) { count } else { 0 };
        let candidate = |random: &mut Random| {
            let maker = *random.pick(&[Maker::Edges, Maker::Logarithmic, Maker::Extreme]);
            let mut point = self.candidate(maker, random)?;
            if maker == Maker::Logarithmic {
                point.iter_mut().for_each(|value| *value *= *random.pick(&[1.0, -1.0, 0.0]));
            }
            Some(point)
        };
        let refused = |point: &[f64]| !self.domain.contains(point);
        let list = (0..count).map(|_| self.first(|| candidate(&mut random), refused)).collect();
        Points { origin: format!("outside, seed {seed}"), list }
    }

    /// The first candidate that is wanted.
    fn first(&self, mut candidate: impl FnMut() -> Option<Vec<f64>>, wanted: impl Fn(&[f64]) -> bool) -> Vec<f64> {
        let mut candidates = (0..TRIES).filter_map(|_| candidate());
        let found = candidates.find(|point| wanted(point));
        found.unwrap_or_else(|| panic!("{}: no point in {TRIES} tries", self.info.name))
    }

    fn candidate(&self, maker: Maker, random: &mut Random) -> Option<Vec<f64>> {
        match maker {
            Maker::Edges => self.nudged_zero(&self.edges, typical_or_wide(random), random),
            Maker::Subterms => self.nudged_zero(&self.subterms, typical_or_wide(random), random),
            Maker::NearEqual => self.near_equal(random),
            Maker::Logarithmic => Some(self.each(random, logarithmic)),
            Maker::Bits => Some(self.each(random, |input, random| {
                let (low, high) = exponents(input);
                with_bits(random.between(low - 10.0, high + 10.0), random)
            })),
            Maker::Wide => Some(self.each(random, |_, random| with_bits(random.between(-WIDE, WIDE), random))),
            Maker::Octaves => Some(self.each(random, |_, random| random.between(-OCTAVES, OCTAVES).exp2())),
            Maker::Reals => Some(self.each(random, |input, random| random.between(input.typical.0, input.typical.1))),
            Maker::Extreme => self.extreme(random).filter(|point| point.iter().all(|input| input.is_finite())),
        }
    }

    fn extreme(&self, random: &mut Random) -> Option<Vec<f64>> {
        match random.below(5) {
            0 => Some(
                self.each(random, |_, random| scaled(1.0, random.between(LEAST.into(), LARGEST.into()) as i32, random)),
            ),
            1 => {
                let limit = *random.pick(&[LEAST, NORMAL, LARGEST]) / (1 + random.below(6) as i32);
                Some(self.each(random, |_, random| scaled(1.0, limit + random.below(5) as i32 - 2, random)))
            }
            2 => {
                let mut point = self.candidate(Maker::Logarithmic, random)?;
                let input = random.below(point.len());
                let exponent = *random.pick(&[LEAST, LEAST + 1, NORMAL - 1, NORMAL, LARGEST / 2, LARGEST]);
                point[input] = if random.one_in(6) { 0.0 } else { scaled(point[input].signum(), exponent, random) };
                Some(point)
            }
            3 => self.nudged_zero(&self.edges, Maker::Extreme, random),
            _ => self.in_other_units(random),
        }
    }

    /// A point of another maker in units so large or small that steps over- and underflow.
    fn in_other_units(&self, random: &mut Random) -> Option<Vec<f64>> {
        let maker = *random.pick(&[Maker::Edges, Maker::Wide, Maker::Logarithmic]);
        let mut point = self.candidate(if self.has(maker) { maker } else { Maker::Wide }, random)?;
        // a half power of an odd scale would be none of two
        let halving = whole([1; BASES], &self.units)[0];
        let mut scale = [0; BASES].map(|_: i32| random.below(800) as i32 - 400);
        [scale[0], scale[2]] = [random.below(1_600) as i32 - 800, random.below(800) as i32 - 400];
        let scale = whole(scale.map(|power| power / halving), &self.units);
        point.iter_mut().zip(&self.units).for_each(|(value, unit)| *value *= factor(unit, &scale));
        Some(point)
    }

    /// A magnitude for each input, with one of its signs.
    fn each(&self, random: &mut Random, magnitude: impl Fn(&Input, &mut Random) -> f64) -> Vec<f64> {
        let inputs = self.info.inputs.iter().zip(&self.signs);
        inputs.map(|(input, signs)| *random.pick(signs) * magnitude(input, random)).collect()
    }

    /// A point of the maker `base` where one of the expressions vanishes, its solved input nudged.
    fn nudged_zero(&self, zeros: &[Zeros], base: Maker, random: &mut Random) -> Option<Vec<f64>> {
        if zeros.is_empty() {
            return None;
        }
        let mut point = self.candidate(base, random)?;
        if random.one_in(3) {
            // Of round numbers the zero is often a double itself.
            point.iter_mut().for_each(|value| *value = shortened(*value, random.below(4) as u32));
        }
        let zeros = random.pick(zeros);
        let input = *random.pick(&zeros.inputs);
        let zero = zeros.solve(&self.domain, &point, input)?;
        let scale = if zero == 0.0 { point[input] } else { zero };
        point[input] = nudged(zero, scale, random);
        Some(point)
    }

    /// A point where two inputs of one unit are nearly equal.
    fn near_equal(&self, random: &mut Random) -> Option<Vec<f64>> {
        let mut point = self.candidate(Maker::Logarithmic, random)?;
        let (from, to) = *random.pick(&self.pairs);
        let factor = *random.pick(&[1.0, 1.0, 1.0, 2.0, 0.5, 3.0, 1.0 / 3.0, 4.0, 1.5]);
        let equal = point[from] * factor * *random.pick(&[1.0, -1.0]);
        point[to] = nudged(equal, equal, random);
        Some(point)
    }
}

fn typical_or_wide(random: &mut Random) -> Maker {
    if random.one_in(4) { Maker::Wide } else { Maker::Logarithmic }
}

/// The signs that the conditions on the input alone leave open.
fn signs(domain: &Domain, position: usize, input: &Input) -> Vec<f64> {
    let (low, high) = input.typical;
    let allowed = |sign: &f64| domain.allows(position, sign * low) || domain.allows(position, sign * high);
    let signs: Vec<f64> = [1.0, -1.0].into_iter().filter(allowed).collect();
    if signs.is_empty() { vec![1.0] } else { signs }
}

fn pairs(inputs: &[Input]) -> Vec<(usize, usize)> {
    let all = (0..inputs.len()).flat_map(|from| (0..inputs.len()).map(move |to| (from, to)));
    all.filter(|&(from, to)| from != to && inputs[from].unit == inputs[to].unit).collect()
}

/// The binary exponents of the typical magnitudes.
fn exponents(input: &Input) -> (f64, f64) {
    (input.typical.0.log2(), input.typical.1.log2())
}

fn logarithmic(input: &Input, random: &mut Random) -> f64 {
    let (low, high) = exponents(input);
    random.between(low, high).exp2()
}

/// The bits of a fraction.
const FRACTION: u64 = (1 << 52) - 1;

/// A number of this exponent; its fraction of all bits, of few, or of nearly all ones.
fn with_bits(exponent: f64, random: &mut Random) -> f64 {
    let bits = random.bits() & FRACTION;
    let fraction = match random.below(4) {
        0 => bits & !(FRACTION >> random.below(53)),
        1 => FRACTION ^ (bits >> random.below(53)),
        _ => bits,
    };
    f64::from_bits(1.0_f64.to_bits() | fraction) * exponent.floor().exp2()
}

/// A number of this sign and exponent, subnormal ones included.
fn scaled(sign: f64, exponent: i32, random: &mut Random) -> f64 {
    let (first, second) = (exponent / 2, exponent - exponent / 2);
    sign * with_bits(0.0, random) * 2.0_f64.powi(first) * 2.0_f64.powi(second)
}

/// A number of the same sign and exponent as this one, which is not zero.
pub fn other_fraction(value: f64, random: &mut Random) -> f64 {
    let fraction = with_bits(0.0, random).to_bits() & FRACTION;
    f64::from_bits(value.to_bits() & !FRACTION | fraction)
}

/// The number with no more than `bits` bits after its leading one.
pub fn shortened(value: f64, bits: u32) -> f64 {
    f64::from_bits(value.to_bits() >> (52 - bits) << (52 - bits))
}

/// `value`, or a few units in its last place beside it, or 2^-k of `scale` beside it.
fn nudged(value: f64, scale: f64, random: &mut Random) -> f64 {
    let sign = *random.pick(&[1.0, -1.0]);
    match random.below(10) {
        0 => value,
        1..=3 => value + sign * (1 + random.below(3)) as f64 * (value.abs().next_up() - value.abs()),
        _ => value + sign * scale * random.unit().exp2() * 0.5_f64.powi(1 + random.below(44) as i32),
    }
}
