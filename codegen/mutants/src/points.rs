//! Points where it hurts: inside and outside the domain, at its edges, and where a part of the kernel vanishes.

use std::collections::HashSet;

use super::zeros::Probe;
use closedform_measure::catalogue::Entry;
use closedform_project::contract::Input;
use closedform_project::domain::Domain;
use closedform_project::sample::{EmptyDomain, Random, bisect, sample};

/// Inputs other than zero stay within 2^-LIMIT to 2^LIMIT, lest a product over- or underflows.
const LIMIT: i32 = 128;

/// How many octaves beyond the typical magnitudes wide points reach.
const WIDE: i32 = 40;

/// Zeros that are looked for with each part and input, from each kind of point.
const ZEROS: usize = 4;

/// Points with several inputs zero or of another sign.
const CORNERS: usize = 256;

/// Points of few bits that are tried with each part and input.
const ROUND: usize = 48;

/// How often two parts are solved in turn until both vanish.
const TURNS: usize = 12;

/// Small numbers with small factors, and so with products that are squares.
const SMALL: [f64; 10] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 9.0, 12.0, 27.0];

/// Points of a kernel, inside and outside its domain, in an order that mixes all kinds.
pub struct Points {
    /// The inputs of each.
    pub list: Vec<Vec<f64>>,
}

/// Makes points of one kernel.
pub struct Maker {
    probes: Vec<Probe>,
    /// How many of them, the first ones, are of conditions.
    edges: usize,
    /// Points inside, of typical and of all other magnitudes.
    bases: Vec<Vec<f64>>,
    random: Random,
}

impl Maker {
    /// The maker of a kernel's points, from `count` typical points of its domain, and as many others.
    ///
    /// # Errors
    ///
    /// When the domain has no points.
    pub fn new(entry: &Entry, domain: &Domain, count: usize, seed: u64) -> Result<Self, EmptyDomain> {
        let typical = entry.inputs();
        let wide: Vec<Input> = typical.iter().map(widened).collect();
        let mut bases = sample(domain, &typical.iter().collect::<Vec<_>>(), count, seed)?;
        bases.extend(sample(domain, &wide.iter().collect::<Vec<_>>(), count, seed)?);
        bases.retain(|point| moderate(point));
        let (probes, edges) = (Probe::all(&entry.kernel), Probe::of_conditions(&entry.kernel));
        Ok(Maker { probes, edges, bases, random: Random::new(seed) })
    }

    /// All kinds of points, each once.
    pub fn points(&mut self) -> Points {
        let mut list = self.bases.clone();
        list.extend(self.outside());
        list.extend((0..CORNERS).map(|_| self.corner()));
        list.extend((0..CORNERS).filter_map(|_| self.double_zero()));
        for at in 0..self.probes.len() {
            let probe = self.probes[at].clone();
            list.extend(self.zeros(&probe));
            list.extend(self.exact_zeros(&probe));
        }
        let mut seen = HashSet::new();
        list.retain(|point| moderate(point) && seen.insert(point.iter().map(|x| x.to_bits()).collect::<Vec<_>>()));
        for at in (1..list.len()).rev() {
            let other = self.random.below(at as u64 + 1) as usize;
            list.swap(at, other);
        }
        Points { list }
    }

    fn base(&mut self) -> Vec<f64> {
        let bases = &self.bases;
        if bases.is_empty() { Vec::new() } else { self.random.pick(bases).clone() }
    }

    /// Points with one input of another size or sign, or zero.
    fn outside(&mut self) -> Vec<Vec<f64>> {
        let mut points = Vec::new();
        let inputs = self.bases.first().map_or(0, Vec::len);
        for input in (0..inputs).flat_map(|input| [input; 4 * ZEROS]) {
            let mut point = self.base();
            point[input] = self.other(point[input]);
            points.push(point);
        }
        points
    }

    /// A point with some inputs zero or of another sign.
    fn corner(&mut self) -> Vec<f64> {
        let base = if self.random.below(2) == 0 { self.base() } else { self.round() };
        let turned = |value: f64| match self.random.below(4) {
            0 => value,
            1 => -value,
            _ => 0.0,
        };
        base.into_iter().map(turned).collect()
    }

    /// Another value for an input.
    fn other(&mut self, value: f64) -> f64 {
        let scale = exp2(self.random.below(2 * WIDE as u64 + 1) as i32 - WIDE);
        match self.random.below(8) {
            0 => 0.0,
            1 => -value,
            2 => -value * scale,
            _ => value * scale,
        }
    }

    /// Points beside a zero of a part: neighbours, a few ulp away, and at all relative distances.
    fn zeros(&mut self, probe: &Probe) -> Vec<Vec<f64>> {
        let inputs = self.bases.first().map_or(0, Vec::len);
        let mut points = Vec::new();
        for input in (0..inputs).flat_map(|input| [input; ZEROS]) {
            let base = self.base();
            let Some([near, far]) = self.change_of_sign(probe, &base, input) else { continue };
            let distance = near * exp2(-(1 + self.random.below(50) as i32));
            for value in [near, far, near + distance, near - distance] {
                let mut point = base.clone();
                point[input] = value;
                points.push(point);
            }
        }
        points
    }

    fn change_of_sign(&mut self, probe: &Probe, base: &[f64], input: usize) -> Option<[f64; 2]> {
        (0..2 * ZEROS).find_map(|_| {
            let other = self.other(base[input]);
            probe.bisect(base, input, other)
        })
    }

    /// Points of few bits at which a part vanishes exactly, and points beside them where it nearly does.
    fn exact_zeros(&mut self, probe: &Probe) -> Vec<Vec<f64>> {
        let inputs = self.bases.first().map_or(0, Vec::len);
        let mut points = Vec::new();
        for input in (0..inputs).flat_map(|input| [input; ROUND]) {
            let mut point = self.round();
            let Some(zero) = self.exact_zero(probe, &point, input) else { continue };
            point[input] = zero;
            let other = self.random.below(inputs as u64) as usize;
            points.extend((other != input).then(|| probe.deepest(&point, input, other)).flatten());
            points.extend([zero.next_up(), zero.next_down(), zero].map(|value| {
                let mut point = point.clone();
                point[input] = value;
                point
            }));
        }
        points
    }

    fn exact_zero(&mut self, probe: &Probe, point: &[f64], input: usize) -> Option<f64> {
        let found = probe.solve(point, input).or_else(|| {
            let other = self.other(point[input]);
            let ends = probe.bisect(point, input, other)?;
            ends.into_iter().find(|end| probe.moved(point, input, *end) == 0.0)
        });
        found.filter(|zero| *zero != 0.0)
    }

    /// A point of few bits: near one of the domain, or of small numbers with its signs.
    fn round(&mut self) -> Vec<f64> {
        let (base, near) = (self.base(), self.random.below(2) == 0);
        let rounded = |value: f64| {
            if near || value == 0.0 {
                return shortened(value, self.random.below(4) as u32);
            }
            let scale = exp2(self.random.below(7) as i32 - 4);
            self.random.pick(&SMALL).copysign(value) * scale
        };
        base.into_iter().map(rounded).collect()
    }

    /// A point near which two parts vanish, where edges of the domain meet or digits are lost twice: each in turn is
    /// solved for an input of its own, once or until both stay.
    pub fn double_zero(&mut self) -> Option<Vec<f64>> {
        let mut point = self.base();
        let turns = if self.random.below(8) == 0 { TURNS } else { 1 };
        let distance = exp2(-(4 + self.random.below(46) as i32));
        let distances = *self.random.pick(&[[0.0, 0.0], [distance, 0.0], [-distance, 0.0], [0.0, distance]]);
        let parts = [self.part(point.len())?, self.part(point.len())?];
        for (turn, (probe, input)) in parts.iter().cycle().take(2 * turns).enumerate() {
            let close = exp2(self.random.below(3) as i32 - 1);
            let ends = probe.bisect(&point, *input, point[*input] * close);
            let ends = ends.or_else(|| self.change_of_sign(probe, &point, *input))?;
            point[*input] = self.random.pick(&ends) * (1.0 + distances[turn % 2]);
        }
        moderate(&point).then_some(point)
    }

    /// A part, one of a condition as often as any, and an input.
    fn part(&mut self, inputs: usize) -> Option<(Probe, usize)> {
        let among = if self.edges > 0 && self.random.below(2) == 0 { self.edges } else { self.probes.len() };
        let probe = self.probes.get(self.random.below(among as u64) as usize)?.clone();
        Some((probe, self.random.below(inputs as u64) as usize))
    }

    /// The point with an input moved, and another one so that a part vanishes there.
    pub fn slide(&mut self, point: &[f64]) -> Option<Vec<f64>> {
        let mut moved = self.step(point);
        let (probe, input) = self.part(point.len())?;
        let factor = exp2(self.random.below(9) as i32 - 4);
        let close = probe.bisect(&moved, input, moved[input] * factor);
        let [near, far] = close.or_else(|| self.change_of_sign(&probe, &moved, input))?;
        moved[input] = if self.random.below(2) == 0 { near } else { far };
        moderate(&moved).then_some(moved)
    }

    /// Neighbours on both sides of an edge, one of which `decides` holds of and the other not, if one is found.
    pub fn edge(&mut self, decides: impl Fn(&[f64]) -> bool) -> Option<[Vec<f64>; 2]> {
        let (base, input) = (self.base(), self.random.below(self.bases.first()?.len() as u64) as usize);
        let other = self.other(base[input]);
        let at = |value: f64| {
            let mut point = base.clone();
            point[input] = value;
            point
        };
        bisect(base[input], other, |value| Some(decides(&at(value)))).map(|ends| ends.map(at))
    }

    /// The point with one input, or two, moved by their bits or to another size.
    pub fn step(&mut self, point: &[f64]) -> Vec<f64> {
        let mut moved = point.to_vec();
        for _ in 0..=self.random.below(2) {
            let input = self.random.below(point.len() as u64) as usize;
            moved[input] = self.stepped(moved[input]);
        }
        moved
    }

    fn stepped(&mut self, value: f64) -> f64 {
        let bit = 1_u64 << self.random.below(52);
        match self.random.below(8) {
            0 => value * 2.0,
            1 => value / 2.0,
            2 => value.next_up(),
            3 => value.next_down(),
            4 => f64::from_bits(value.to_bits().wrapping_add(bit)),
            5 => f64::from_bits(value.to_bits().wrapping_sub(bit)),
            6 => value * exp2(self.random.below(41) as i32 - 20),
            _ => f64::from_bits(value.to_bits() ^ bit),
        }
    }
}

fn widened(input: &Input) -> Input {
    let [low, high] = input.typical;
    Input { typical: [low * exp2(-WIDE), high * exp2(WIDE)], ..input.clone() }
}

fn exp2(exponent: i32) -> f64 {
    f64::from(exponent).exp2()
}

/// Whether no product of a few of these inputs over- or underflows.
pub fn moderate(point: &[f64]) -> bool {
    let range = exp2(-LIMIT)..=exp2(LIMIT);
    point.iter().all(|input| *input == 0.0 || range.contains(&input.abs()))
}

/// The number with no more than `bits` bits after its leading one.
fn shortened(value: f64, bits: u32) -> f64 {
    f64::from_bits(value.to_bits() >> (52 - bits) << (52 - bits))
}
