//! The one check: a kernel against its oracle, in ulp against its bound.

use closedform::{Kernel, Mpfr};
use rug::Float;

use crate::failure::Failure;
use crate::inputs::{Points, Space};
use crate::reference::{Oracle, References};
use crate::ulp::{self, F64};

/// Bits of a `compensated!` slice.
const SLICE_BITS: u32 = 106;

/// Bounds hold as long as cancellation costs a slice fewer bits than this.
const CANCELLED_BITS: u32 = 40;

/// Bits in which cancellation is measured: no slice comes near losing that many.
const AMPLE_BITS: u32 = 2_048;

/// The largest share of points that may be beyond what bounds promise.
const SKIPPED_SHARE: f64 = 0.05;

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

/// What came out at one point.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// Every result is within its bound: the errors in ulp.
    Kept(Vec<f64>),
    /// An error beyond its bound where none is promised: the program cancels by more than 2^40.
    Cancelled,
    /// An error beyond its bound.
    Broken(Box<Failure>),
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
    /// How many more were beyond what bounds promise.
    pub skipped: usize,
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

    /// What comes out at a point inside the domain; `origin` says where the point is from.
    pub fn verdict(&self, inputs: &[f64], origin: &str) -> Verdict {
        let mut errors = Vec::new();
        for (result, actual) in self.actual(inputs).into_iter().enumerate() {
            let exact = self.exact(result, inputs);
            let ulp = ulp::distance(actual, &exact, F64);
            if ulp <= self.bound(result) {
                errors.push(ulp);
            } else if actual.is_finite() && self.cancels(result, inputs) {
                return Verdict::Cancelled;
            } else {
                return Verdict::Broken(Box::new(Failure::new(self, result, inputs, actual, &exact, origin)));
            }
        }
        Verdict::Kept(errors)
    }

    /// The results of the kernel's program in MPFR.
    pub fn program(&self, inputs: &[f64], precision: u32) -> Vec<Float> {
        let inputs: Vec<Mpfr> = inputs.iter().map(|value| Mpfr::new(precision, *value)).collect();
        let mut results = vec![Mpfr::new(precision, 0.0); self.kernel.info.results.len()];
        self.kernel.mpfr(&inputs, &mut results).expect("as many inputs and results as the kernel has");
        results.into_iter().map(|result| result.0).collect()
    }

    /// Whether the program of a result, run in the bits of a slice, loses more of them than bounds allow for.
    ///
    /// It is compared with itself in ample bits, not with the oracle: a wrong program finds no excuse here.
    pub fn cancels(&self, result: usize, inputs: &[f64]) -> bool {
        let ample = self.program(inputs, AMPLE_BITS).swap_remove(result);
        let lost = (self.program(inputs, SLICE_BITS).swap_remove(result) - &ample).abs();
        lost > ample.abs() >> (SLICE_BITS - CANCELLED_BITS)
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
/// More than a small share of the points is beyond what bounds promise, or a reference has no value inside the domain.
pub fn check(judge: &Judge, points: &Points) -> Result<Report, Box<Failure>> {
    let mut report = Report { worst: vec![Worst::default(); judge.kernel.info.results.len()], ..Report::default() };
    for inputs in &points.list {
        match judge.verdict(inputs, &points.origin) {
            Verdict::Kept(errors) => report.keep(&errors, inputs),
            Verdict::Cancelled => report.skipped += 1,
            Verdict::Broken(failure) => return Err(failure),
        }
    }
    report.demand_honesty(judge.kernel.info.name, &points.origin);
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
        self.skipped += other.skipped;
        self.worst.resize(other.worst.len(), Worst::default());
        for (worst, theirs) in self.worst.iter_mut().zip(other.worst) {
            if theirs.ulp >= worst.ulp {
                *worst = theirs;
            }
        }
    }

    fn demand_honesty(&self, kernel: &str, origin: &str) {
        demand_honesty(self.points, self.skipped, &format!("{kernel} ({origin})"));
    }
}

/// Demands that few points were skipped.
///
/// # Panics
///
/// They were more than a small share.
pub fn demand_honesty(judged: usize, skipped: usize, what: &str) {
    let all = judged + skipped;
    let allowed = SKIPPED_SHARE * all as f64;
    assert!(skipped as f64 <= allowed, "{what}: {skipped} of {all} points are beyond what bounds promise");
}
