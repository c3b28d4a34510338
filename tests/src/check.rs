//! The one check: a kernel against its oracle, in ulp against its bound.

use closedform::{Kernel, Mpfr};
use rug::Float;

use crate::failure::Failure;
use crate::inputs::{Points, Space};
use crate::reference::{Oracle, References};
use crate::ulp::{self, F64};

/// A kernel with all that it takes to judge it.
#[derive(Clone, Debug)]
pub struct Judge {
    /// The kernel.
    pub kernel: &'static Kernel,
    /// What it should return.
    pub oracle: Oracle,
    /// Where it should return it.
    pub space: Space,
}

/// The worst error of one result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// In ulp.
    pub ulp: f64,
    /// The inputs.
    pub inputs: Vec<f64>,
}

/// What came out at many points.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// How many points were judged.
    pub points: usize,
    /// The worst error of each result.
    pub worst: Vec<Worst>,
}

impl Judge {
    /// The judge of `kernel`, or what the references lack.
    pub fn new(kernel: &'static Kernel, references: &References) -> Result<Self, String> {
        let oracle = Oracle::new(kernel.info, references)?;
        let space = Space::new(kernel.info, &oracle);
        Ok(Judge { kernel, oracle, space })
    }

    /// The results of the kernel.
    pub fn actual(&self, inputs: &[f64]) -> Vec<f64> {
        let mut results = vec![0.0; self.kernel.info.results.len()];
        self.kernel.eval(inputs, &mut results).expect("as many inputs and results as the kernel has");
        results
    }

    /// The error in ulp that a result never exceeds.
    pub fn bound(&self, result: usize) -> f64 {
        let info = &self.kernel.info.results[result];
        info.bound_ulp.unwrap_or_else(|| panic!("{}: no bound for `{}`", self.kernel.info.name, info.name))
    }

    /// The exact value of a result.
    ///
    /// # Panics
    ///
    /// It has none: the domain of the kernel is larger than that of its reference.
    pub fn exact(&self, result: usize, inputs: &[f64]) -> Float {
        self.oracle.value(result, inputs).unwrap_or_else(|error| {
            let results = self.kernel.info.results;
            panic!("{}: reference of `{}` at {inputs:?}: {error}", self.kernel.info.name, results[result].name)
        })
    }

    /// The errors of the results in ulp at a point inside the domain; `origin` says where the point is from.
    ///
    /// # Errors
    ///
    /// The first one that is beyond its bound.
    pub fn errors(&self, inputs: &[f64], origin: &str) -> Result<Vec<f64>, Box<Failure>> {
        let mut errors = Vec::new();
        for (result, actual) in self.actual(inputs).into_iter().enumerate() {
            let exact = self.exact(result, inputs);
            let ulp = ulp::distance(actual, &exact, F64);
            if ulp <= self.bound(result) {
                errors.push(ulp);
            } else {
                return Err(Box::new(Failure::new(self, result, inputs, actual, &exact, origin)));
            }
        }
        Ok(errors)
    }

    /// The results of the kernel's program in MPFR.
    pub fn program(&self, inputs: &[f64], precision: u32) -> Vec<Float> {
        let inputs: Vec<Mpfr> = inputs.iter().map(|value| Mpfr::new(precision, *value)).collect();
        let mut results = vec![Mpfr::new(precision, 0.0); self.kernel.info.results.len()];
        self.kernel.mpfr(&inputs, &mut results).expect("as many inputs and results as the kernel has");
        results.into_iter().map(|result| result.0).collect()
    }
}

/// Compares the kernel with its oracle at every point.
///
/// # Errors
///
/// The first point where a bound is broken.
///
/// # Panics
///
/// A reference has no value inside the domain.
pub fn check(judge: &Judge, points: &Points) -> Result<Report, Box<Failure>> {
    let mut report = Report { worst: vec![Worst::default(); judge.kernel.info.results.len()], ..Report::default() };
    for inputs in &points.list {
        report.keep(&judge.errors(inputs, &points.origin)?, inputs);
    }
    Ok(report)
}

impl Report {
    fn keep(&mut self, errors: &[f64], inputs: &[f64]) {
        self.points += 1;
        for (worst, ulp) in self.worst.iter_mut().zip(errors) {
            if *ulp >= worst.ulp {
                *worst = Worst { ulp: *ulp, inputs: inputs.to_vec() };
            }
        }
    }

    /// Adds what came out at other points of the same kernel.
    pub fn merge(&mut self, other: Report) {
        self.points += other.points;
        self.worst.resize(other.worst.len(), Worst::default());
        for (worst, theirs) in self.worst.iter_mut().zip(other.worst) {
            if theirs.ulp >= worst.ulp {
                *worst = theirs;
            }
        }
    }

    /// How many points there were and the worst error of each result, in a line.
    pub fn told(&self, judge: &Judge) -> String {
        let each = self.worst.iter().enumerate().map(|(result, worst)| {
            let (name, bound) = (judge.kernel.info.results[result].name, judge.bound(result));
            format!("{name} {:.3} of {bound} ulp", worst.ulp)
        });
        format!("{} points: {}", self.points, each.collect::<Vec<_>>().join(", "))
    }
}
