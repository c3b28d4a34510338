//! Roundings counted at a point: a bound that promises less than they may add up to is wrong.

use std::cmp::Ordering;

use closedform::Real;
use closedform_syntax::{Arithmetic, Kernel, Slice, SliceArithmetic, evaluate};

/// What the last rounding of a result costs less in ulp than in units of 2^-53: half an ulp.
const LAST: f64 = 0.5;

/// Room for the roundings of the count itself.
const SLACK: f64 = 1e-9;

/// For each result the error in ulp that the roundings at a point may add up to. Slices count as one rounding each and
/// roots of polynomials as none, so that no bound is less for being derived otherwise.
pub fn roundings(kernel: &Kernel, point: &[f64]) -> Vec<f64> {
    let inputs: Vec<Counted> = point.iter().map(|value| Counted { value: *value, units: 0.0 }).collect();
    let results = evaluate(kernel, &Counting, &inputs);
    let ulps = results.iter().map(|result| if result.value.is_finite() { result.units - LAST - SLACK } else { 0.0 });
    ulps.collect()
}

/// A number, and what its relative error may be, in units of 2^-53.
#[derive(Clone, Copy)]
struct Counted {
    value: f64,
    units: f64,
}

/// The arithmetic of compiled kernels, which counts.
struct Counting;

fn exact(value: f64) -> Counted {
    Counted { value, units: 0.0 }
}

fn sum(value: f64, a: &Counted, b: &Counted) -> Counted {
    let carried = (a.value.abs() * a.units + b.value.abs() * b.units) / value.abs();
    Counted { value, units: if carried.is_nan() { 0.0 } else { carried + 1.0 } }
}

/// A product or quotient; it is not rounded if one is a power of two.
fn scaled(value: f64, a: &Counted, b: &Counted, unrounded: bool) -> Counted {
    Counted { value, units: a.units + b.units + if unrounded { 0.0 } else { 1.0 } }
}

fn is_power_of_two(x: &Counted) -> bool {
    x.units == 0.0 && x.value.to_bits() << 12 == 0
}

impl SliceArithmetic for Counting {
    type Value = Counted;
    type Wide = <f64 as Real>::Wide;

    fn neg(&self, a: &Counted) -> Counted {
        Counted { value: -a.value, units: a.units }
    }

    fn two_sum(&self, a: &Counted, b: &Counted) -> Self::Wide {
        a.value.two_sum(&b.value)
    }

    fn two_product(&self, a: &Counted, b: &Counted) -> Self::Wide {
        a.value.two_product(&b.value)
    }

    fn wide_neg(&self, a: &Self::Wide) -> Self::Wide {
        f64::wide_neg(a)
    }

    fn wide_add_exact(&self, a: &Self::Wide, b: &Counted) -> Self::Wide {
        f64::wide_add_exact(a, &b.value)
    }

    fn wide_add(&self, a: &Self::Wide, b: &Self::Wide) -> Self::Wide {
        f64::wide_add(a, b)
    }

    fn wide_mul_exact(&self, a: &Self::Wide, b: &Counted) -> Self::Wide {
        f64::wide_mul_exact(a, &b.value)
    }

    fn wide_mul(&self, a: &Self::Wide, b: &Self::Wide) -> Self::Wide {
        f64::wide_mul(a, b)
    }

    fn compensated(&self, a: &Self::Wide, slice: &Slice, operands: &[Counted]) -> Counted {
        let operands: Vec<&f64> = operands.iter().map(|operand| &operand.value).collect();
        Counted { value: f64::compensated(a, slice.threshold, &operands, &slice.terms), units: 1.0 }
    }

    fn residual(&self, a: &Self::Wide) -> Counted {
        exact(f64::residual(a))
    }
}

impl Arithmetic for Counting {
    fn literal(&self, value: f64) -> Counted {
        exact(value)
    }

    fn pi(&self) -> Counted {
        Counted { value: std::f64::consts::PI, units: 1.0 }
    }

    fn add(&self, a: &Counted, b: &Counted) -> Counted {
        sum(a.value + b.value, a, b)
    }

    fn sub(&self, a: &Counted, b: &Counted) -> Counted {
        sum(a.value - b.value, a, b)
    }

    fn mul(&self, a: &Counted, b: &Counted) -> Counted {
        scaled(a.value * b.value, a, b, is_power_of_two(a) || is_power_of_two(b))
    }

    fn div(&self, a: &Counted, b: &Counted) -> Counted {
        scaled(a.value / b.value, a, b, is_power_of_two(b))
    }

    fn sqrt(&self, a: &Counted) -> Counted {
        Counted { value: a.value.sqrt(), units: a.units / 2.0 + 1.0 }
    }

    fn abs(&self, a: &Counted) -> Counted {
        Counted { value: a.value.abs(), units: a.units }
    }

    fn compare(&self, a: &Counted, b: &Counted) -> Option<Ordering> {
        a.value.partial_cmp(&b.value)
    }

    fn is_finite(&self, a: &Counted) -> bool {
        a.value.is_finite()
    }

    fn positive_root(&self, coefficients: &[Counted]) -> Counted {
        let coefficients: Vec<f64> = coefficients.iter().map(|coefficient| coefficient.value).collect();
        exact(closedform::positive_root(&coefficients))
    }
}
