//! What is searched: one kernel, its errors estimated fast and confirmed by its reference.

use closedform_syntax::{Kernel, Precision};

use super::estimate::{distance, in_double_double, in_mpfr};
use crate::accuracy::{Measurement, REFERENCE_BITS, Reference, ValueError, Worst, covers, measure, results};
use closedform_project::contract::Input;
use closedform_project::domain::Domain;

/// A kernel with all that it takes to search it.
pub struct Target<'a> {
    /// The kernel.
    pub kernel: &'a Kernel,
    /// What it should return.
    pub reference: Reference,
    /// Where it should return it.
    pub domain: Domain,
    /// The inputs as samplers know them.
    pub inputs: Vec<Input>,
}

/// Bits in which a kernel that certifies itself is evaluated, more than it takes itself.
const CERTIFIED_BITS: u32 = 4_096 + REFERENCE_BITS;

impl Target<'_> {
    /// Whether the kernel takes the point: the domain, but for roundings of its conditions.
    pub(super) fn takes(&self, point: &[f64]) -> bool {
        results(self.kernel, point).is_ok()
    }

    /// An estimate of the error of one result in ulp; `None` where the kernel refuses the point or nothing is known.
    pub(super) fn estimate(&self, result: usize, point: &[f64]) -> Option<f64> {
        let got = *results(self.kernel, point).ok()?.get(result)?;
        let exact = match self.kernel.meta.precision {
            Precision::Double => in_double_double(self.kernel, result, point),
            Precision::DoubleDouble => in_mpfr(self.kernel, result, point, 2 * REFERENCE_BITS),
            Precision::Certified => in_mpfr(self.kernel, result, point, CERTIFIED_BITS),
        }?;
        exact.low().is_finite().then(|| distance(got, exact))
    }

    /// Whether the bound covers the point: it is inside the domain, exactly, and nothing over- or underflows.
    pub(super) fn counts(&self, point: &[f64]) -> bool {
        self.domain.holds(point) && covers(self.kernel, point)
    }

    /// The error of every result at the point, against the reference; `None` where the bound does not cover it.
    ///
    /// # Errors
    ///
    /// When the reference has no value there.
    pub fn confirm(&self, point: &[f64]) -> Result<Option<Vec<Worst>>, ValueError> {
        if point.len() != self.kernel.inputs.len() || !self.counts(point) {
            return Ok(None);
        }
        let Measurement { worst, .. } = measure(self.kernel, &self.reference, &[point.to_vec()], || ())?;
        Ok(worst.into_iter().collect())
    }
}
