//! Points of a domain, chosen where arithmetic hurts: magnitudes of every size, edges, zeros, near-equal operands.

mod bisect;
mod edges;
mod random;

use std::collections::HashSet;

use miette::Diagnostic;
use thiserror::Error;

pub use bisect::{bisect, rank, unrank};
pub use random::Random;

use super::contract::Input;
use super::domain::Domain;
use edges::Edges;

/// How often a point is tried before the domain counts as exhausted.
const TRIES: usize = 1_000;

/// How often one input is drawn for the conditions that name it alone.
const DRAWS: usize = 64;

/// Relative distances from an edge, or between nearly equal inputs.
const DISTANCES: [f64; 7] = [
    power_of_half(1),
    power_of_half(4),
    power_of_half(10),
    power_of_half(20),
    power_of_half(30),
    power_of_half(40),
    power_of_half(50),
];

const fn power_of_half(exponent: u32) -> f64 {
    1.0 / (1_u64 << exponent) as f64
}

/// No point of a domain was found.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[error("no inputs were found on which all of these hold: {}", conditions.join(", "))]
#[diagnostic(help("correct the conditions, or the `typical` magnitudes of their inputs"))]
pub struct EmptyDomain {
    /// The conditions.
    pub conditions: Vec<String>,
}

/// Different points of a domain, the same for the same seed: every other one at random, the rest at the edges of the
/// domain, at zeros and at nearly equal inputs. Fewer than `count` where the domain has no more.
pub fn sample(domain: &Domain, inputs: &[&Input], count: usize, seed: u64) -> Result<Vec<Vec<f64>>, EmptyDomain> {
    let mut sampler = Sampler { domain, inputs, edges: Edges::new(domain), random: Random::new(seed), thin: false };
    let mut points = sampler.points(count);
    if points.is_empty() {
        // a domain without an inside is met only by moves onto its edges
        sampler.thin = true;
        points = sampler.points(count);
    }
    if points.is_empty() && count > 0 {
        let conditions = domain.texts().map(str::to_owned).collect();
        return Err(EmptyDomain { conditions });
    }
    Ok(points)
}

fn bits(point: &[f64]) -> Vec<u64> {
    point.iter().map(|value| value.to_bits()).collect()
}

struct Sampler<'a> {
    domain: &'a Domain,
    inputs: &'a [&'a Input],
    edges: Edges<'a>,
    random: Random,
    /// Whether the domain may be all edge, as that of `x >= 9` and `x <= 9` is.
    thin: bool,
}

impl Sampler<'_> {
    /// As many different points as are wanted, or as are found.
    fn points(&mut self, count: usize) -> Vec<Vec<f64>> {
        let mut points = Vec::new();
        let mut seen = HashSet::new();
        let mut failed = 0;
        for turn in 0.. {
            if points.len() == count || failed == TRIES {
                break;
            }
            let point = if turn % 2 == 0 { self.anywhere() } else { self.special() };
            let new = point.filter(|point| seen.insert(bits(point)));
            failed = if new.is_some() { 0 } else { failed + 1 };
            points.extend(new);
        }
        points
    }

    /// A point somewhere in the domain: drawn, then moved across the edges it is on the wrong side of.
    fn anywhere(&mut self) -> Option<Vec<f64>> {
        let point = (0..self.inputs.len()).map(|input| self.draw(input)).collect();
        if self.thin { self.on_edges(point) } else { self.inside(point) }
    }

    fn inside(&mut self, mut point: Vec<f64>) -> Option<Vec<f64>> {
        for _ in 0..=self.edges.len() {
            match self.edges.violated(&point) {
                _ if self.domain.holds(&point) => return Some(point),
                Some(edge) => self.cross(&mut point, edge),
                None => return None,
            }
        }
        None
    }

    /// The point moved onto one edge after another, whichever, until it is in the domain.
    fn on_edges(&mut self, mut point: Vec<f64>) -> Option<Vec<f64>> {
        for _ in 0..=2 * self.edges.len() {
            if self.domain.holds(&point) {
                return Some(point);
            }
            let edge = self.random.below(self.edges.len() as u64) as usize;
            self.onto(&mut point, edge);
        }
        None
    }

    /// Moves one input of a comparison to where the comparison changes.
    fn onto(&mut self, point: &mut [f64], edge: usize) {
        let movable = if edge < self.edges.len() { self.edges.inputs(edge) } else { &[] };
        if movable.is_empty() {
            return;
        }
        let input = *self.random.pick(movable);
        let at = match self.edges.solve(edge, input, point) {
            Some(at) => Some(at),
            None => {
                let other = self.draw(input);
                self.edges.bisect(edge, input, point, other)
            }
        };
        point[input] = at.unwrap_or(point[input]);
    }

    /// A value for one input, its sign random where the conditions on this input alone leave it open.
    fn draw(&mut self, input: usize) -> f64 {
        let mut value = 0.0;
        for _ in 0..DRAWS {
            let magnitude = self.random.magnitude(self.inputs[input].typical);
            value = if self.random.below(2) == 0 { magnitude } else { -magnitude };
            if self.edges.allowed_alone(input, value) {
                break;
            }
        }
        value
    }

    /// Moves one input of a violated condition beyond the value at which the condition changes.
    fn cross(&mut self, point: &mut [f64], edge: usize) {
        let movable = self.edges.inputs(edge);
        if movable.is_empty() {
            return;
        }
        let input = *self.random.pick(movable);
        if let Some(at) = self.edges.solve(edge, input, point) {
            let step = self.random.magnitude(self.inputs[input].typical);
            let stretch = at * self.random.magnitude([f64::EPSILON, 8.0]);
            let choices = [at + step, at - step, at + stretch, at - stretch];
            point[input] = *self.random.pick(&choices);
        }
    }

    /// A point of the domain where something is special.
    fn special(&mut self) -> Option<Vec<f64>> {
        let base = self.anywhere()?;
        let point = match self.random.below(8) {
            0 => self.with_zero(base),
            1 => self.with_near_equals(base),
            _ => self.at_edge(base),
        }?;
        let usable = point.iter().all(|value| value.is_finite()) && self.domain.holds(&point);
        usable.then_some(point)
    }

    fn with_zero(&mut self, mut point: Vec<f64>) -> Option<Vec<f64>> {
        let input = self.random.below(point.len() as u64) as usize;
        point[input] = 0.0;
        Some(point)
    }

    fn with_near_equals(&mut self, mut point: Vec<f64>) -> Option<Vec<f64>> {
        let pairs = self.pairs();
        let (one, other) = *pairs.get(self.random.below(pairs.len() as u64) as usize)?;
        let some = *self.random.pick(&DISTANCES);
        let distance = *self.random.pick(&[0.0, f64::EPSILON, some]);
        let sign = if self.random.below(2) == 0 { 1.0 } else { -1.0 };
        point[other] = point[one] * (1.0 + sign * distance);
        Some(point)
    }

    /// Inputs that can be nearly equal because they have the same unit.
    fn pairs(&self) -> Vec<(usize, usize)> {
        let all = (0..self.inputs.len()).flat_map(|one| (0..self.inputs.len()).map(move |other| (one, other)));
        all.filter(|(one, other)| one != other && self.inputs[*one].unit == self.inputs[*other].unit).collect()
    }

    fn at_edge(&mut self, mut point: Vec<f64>) -> Option<Vec<f64>> {
        let edge = self.random.below(self.edges.len() as u64) as usize;
        let movable = if edge < self.edges.len() { self.edges.inputs(edge) } else { &[] };
        let input = *movable.get(self.random.below(movable.len() as u64) as usize)?;
        let at = match self.edges.solve(edge, input, &point) {
            Some(at) => at,
            None => {
                let other = self.draw(input);
                self.edges.bisect(edge, input, &point, other)?
            }
        };
        point[input] = if at == 0.0 { self.beside_zero(input) } else { self.beside(at) };
        Some(point)
    }

    /// Zero, or a value a known factor below what is typical: zero's neighbours are subnormal, where no digit is kept.
    fn beside_zero(&mut self, input: usize) -> f64 {
        let distance = *self.random.pick(&DISTANCES) * self.inputs[input].typical[0];
        *self.random.pick(&[0.0, distance, -distance])
    }

    /// The edge, a neighbour of it, or a value a known relative distance away.
    fn beside(&mut self, at: f64) -> f64 {
        let up = self.random.below(2) == 0;
        match self.random.below(12) {
            0 => at,
            ulps @ 1..=4 => (0..ulps).fold(at, |value, _| if up { value.next_up() } else { value.next_down() }),
            _ => {
                let distance = *self.random.pick(&DISTANCES);
                at * if up { 1.0 + distance } else { 1.0 - distance }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::contract::{self, Contract};
    use super::*;

    /// A contract of one kernel of x, y and z with these conditions.
    fn contract(domain: &str) -> Contract {
        let text = format!(
            "[family]\ntitle = \"t\"\n[inputs]\n\
             x = {{ name = \"x\", unit = \"m\", typical = [1e-2, 1e2] }}\n\
             y = {{ name = \"y\", unit = \"m\" }}\nz = {{ name = \"z\", unit = \"s\" }}\n\
             [[kernel]]\nname = \"k\"\ndoc = \"\"\ninputs = [\"x\", \"y\", \"z\"]\ndomain = {domain}\n\
             [[kernel.result]]\nname = \"k\"\nworksheet = \"k\"\nunit = \"1\"\n"
        );
        contract::parse(std::path::Path::new("family.toml"), &text).unwrap()
    }

    fn points(domain: &str, count: usize, seed: u64) -> Result<Vec<Vec<f64>>, EmptyDomain> {
        let contract = contract(domain);
        let kernel = &contract.kernels[0];
        let points = sample(&kernel.domain, &contract.inputs_of(kernel), count, seed)?;
        assert!(points.iter().all(|point| kernel.domain.holds(point)));
        Ok(points)
    }

    #[test]
    fn a_seed_fixes_the_points() {
        let domain = r#"["x > 0", "y > 0", "6*z > x*y"]"#;
        assert_eq!(points(domain, 100, 7), points(domain, 100, 7));
        assert_ne!(points(domain, 100, 7), points(domain, 100, 8));
        assert_eq!(points(domain, 100, 7).unwrap().len(), 100);
    }

    #[test]
    fn edges_zeros_and_neighbours_are_met() {
        let points = points(r#"["x >= 0", "y > 2*x"]"#, 400, 1).unwrap();
        let met = |what: &dyn Fn(&[f64]) -> bool| points.iter().any(|point| what(point));
        assert!(met(&|p| p[0] == 0.0), "x is zero");
        assert!(met(&|p| p[1] == (2.0 * p[0]).next_up() && p[0] != 0.0), "y is just above its edge");
        assert!(met(&|p| p[2] < 0.0) && met(&|p| p[2] > 0.0), "z has both signs");
        assert!(met(&|p| p[2] == 0.0), "z is zero");
    }

    #[test]
    fn nearly_equal_inputs_are_met() {
        let points = points("[]", 400, 1).unwrap();
        let near = |p: &Vec<f64>| p[0] != p[1] && (p[0] - p[1]).abs() <= 1e-12 * p[0].abs();
        assert!(points.iter().any(near));
        assert!(points.iter().any(|p| p[0] == p[1]));
    }

    #[test]
    fn edges_that_are_not_linear_are_met() {
        let points = points(r#"["x > 0", "x^2*(1+x^2) < 100"]"#, 400, 1).unwrap();
        let largest = points.iter().map(|point| point[0]).fold(0.0, f64::max);
        assert!(largest > 3.08 && largest < 3.09, "{largest}");
    }

    #[test]
    fn thin_and_distant_domains_are_found() {
        for domain in
            [r#"["y > x", "y < x+x/1000000"]"#, r#"["x > 1000000*y", "z > 1000*x"]"#, r#"["x <= -2", "y*z > 5"]"#]
        {
            assert_eq!(points(domain, 50, 3).map(|points| points.len()), Ok(50), "{domain}");
        }
    }

    #[test]
    fn no_more_points_than_there_are() {
        let points = points(r#"["x >= 0", "x <= 0", "y >= 0", "y <= 0", "z >= 0", "z <= 0"]"#, 50, 3).unwrap();
        assert_eq!(points, [[0.0; 3]]);
    }

    #[test]
    fn domains_without_an_inside_are_found() {
        for (domain, inside) in [
            (r#"["x >= 9", "x <= 9"]"#, [9.0, 0.0, 0.0]),
            (r#"["x = 9", "y > 3*x"]"#, [9.0, 28.0, 0.0]),
            (r#"["x = 2*y", "y >= 4", "y < 5", "z = -1/4"]"#, [9.0, 4.5, -0.25]),
            (r#"["not (x # y or y # z)", "x > 1"]"#, [3.0, 3.0, 3.0]),
            (r#"["x^2 <= 4", "x^2 >= 4", "x > 0"]"#, [2.0, 0.0, 0.0]),
        ] {
            assert!(contract(domain).kernels[0].domain.holds(&inside), "{domain}");
            assert!(points(domain, 20, 3).is_ok(), "{domain}");
        }
        let single = r#"["x >= 9", "x <= 9", "y = x/3", "z = 7", "z > 0"]"#;
        assert_eq!(points(single, 50, 3).unwrap(), [[9.0, 3.0, 7.0]]);
        for empty in [r#"["x >= 9", "x <= 9", "x # 9"]"#, r#"["3*x = 1"]"#, r#"["1/(x-x) > 0"]"#] {
            assert!(points(empty, 20, 3).is_err(), "{empty}");
        }
    }

    #[test]
    fn an_empty_domain_is_an_error() {
        let error = points(r#"["x > 0", "x < 0"]"#, 50, 3).unwrap_err();
        assert_eq!(error.conditions, ["x > 0", "x < 0"]);
    }
}
