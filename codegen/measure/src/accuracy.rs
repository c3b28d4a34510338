//! Measuring: how far the results of a kernel are from its reference, in ulp.

mod decided;
mod reference;
mod ulp;

use closedform_syntax::Kernel;
use rug::Float;

pub use decided::{covers, results};
pub use reference::{Reference, ReferenceError, ValueError};
pub use ulp::{ulp_error, ulp_text};

/// Bits of a reference that are right: enough for errors far below an ulp.
pub const REFERENCE_BITS: u32 = 53 + 64;

/// The point at which a result is farthest from its reference.
#[derive(Clone, Debug)]
pub struct Worst {
    /// The error.
    pub ulp: f64,
    /// The inputs, in order.
    pub inputs: Vec<f64>,
    /// What the kernel returns.
    pub got: f64,
    /// What the reference is worth.
    pub expected: Float,
}

/// What was measured of a kernel.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// The points that the promise of the bound covers, all of which were measured.
    pub covered: usize,
    /// The points at which results over- or underflow, or the formula has no value at all.
    pub beyond: usize,
    /// The worst point for each result, in order; `None` where no point is covered.
    pub worst: Vec<Option<Worst>>,
}

/// Measures the kernel at points of its domain; `tick` is called after each.
///
/// A kernel that refuses a point of its domain is infinitely wrong there.
///
/// # Errors
///
/// When the reference has no value at one of the points.
pub fn measure(
    kernel: &Kernel,
    reference: &Reference,
    points: &[Vec<f64>],
    mut tick: impl FnMut(),
) -> Result<Measurement, ValueError> {
    let mut measurement = Measurement { covered: 0, beyond: 0, worst: vec![None; kernel.meta.results.len()] };
    for point in points {
        if covers(kernel, point) {
            measurement.covered += 1;
            measurement.include(kernel, reference, point)?;
        } else {
            measurement.beyond += 1;
        }
        tick();
    }
    Ok(measurement)
}

/// Results of a kernel, and the values of its reference.
type Values = (Vec<f64>, Vec<Float>);

/// The results at a point, NaN where the kernel refuses it, and the values of the reference; `None` where neither has a value.
pub(crate) fn values(kernel: &Kernel, reference: &Reference, point: &[f64]) -> Result<Option<Values>, ValueError> {
    let got = results(kernel, point).unwrap_or_else(|_| vec![f64::NAN; kernel.meta.results.len()]);
    match reference.values(point, REFERENCE_BITS) {
        Err(_) if got.iter().all(|value| !value.is_finite()) => Ok(None),
        expected => Ok(Some((got, expected?))),
    }
}

impl Measurement {
    /// Takes a point in, unless neither the reference nor the kernel has a value there.
    fn include(&mut self, kernel: &Kernel, reference: &Reference, point: &[f64]) -> Result<(), ValueError> {
        let Some((got, expected)) = values(kernel, reference, point)? else { return Ok(()) };
        for ((worst, got), expected) in self.worst.iter_mut().zip(got).zip(expected) {
            let ulp = ulp_error(got, &expected);
            if worst.as_ref().is_none_or(|worst| ulp > worst.ulp) {
                *worst = Some(Worst { ulp, inputs: point.to_vec(), got, expected });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;

    fn measured(name: &str, points: &[Vec<f64>]) -> Measurement {
        let (_folder, catalogue) = fixture::catalogue();
        let kernel = &catalogue.find(name).unwrap().kernel;
        let reference = Reference::of(kernel).unwrap();
        measure(kernel, &reference, points, || ()).unwrap()
    }

    #[test]
    fn the_worst_point_is_kept() {
        let measurement = measured("line::slope", &[vec![1.0, 1.0], vec![2.0f64.powi(53), 1.0], vec![1.0, 2.0]]);
        assert_eq!((measurement.covered, measurement.beyond), (3, 0));
        let worst = measurement.worst[0].as_ref().unwrap();
        assert_eq!((&worst.inputs[..], worst.got, worst.expected.to_f64()), (&[2.0f64.powi(53), 1.0][..], 0.0, 1.0));
        assert_eq!(worst.ulp, 2.0f64.powi(52));
    }

    #[test]
    fn every_result_is_measured() {
        let measurement = measured("plane::slope", &[vec![1.0], vec![5.0]]);
        let ulps: Vec<f64> = measurement.worst.iter().map(|worst| worst.as_ref().unwrap().ulp).collect();
        assert_eq!(ulps[0], 0.0);
        assert!(ulps[1] > 0.3 && ulps[1] < 0.5, "{ulps:?}");
    }

    #[test]
    fn a_refused_point_is_infinitely_wrong() {
        let worst = measured("line::root", &[vec![-1.0, 4.0]]).worst.remove(0).unwrap();
        assert!(worst.got.is_nan() && worst.ulp.is_infinite());
    }

    #[test]
    fn underflow_is_beyond_the_promise() {
        let measurement = measured("line::root", &[vec![1e100, 1e-300], vec![1e-3, 1.0]]);
        assert_eq!((measurement.covered, measurement.beyond), (1, 1));
    }
}
