//! What is hunted: one kernel, its errors estimated fast and confirmed by its reference.

use closedform_syntax::{Kernel, evaluate, violated};

use super::accurate::{Accurate, distance};
use crate::measure::{Compiled, Measurement, Reference, ValueError, Worst, covers, measure};
use crate::worksheet::contract::Input;
use crate::worksheet::domain::Domain;

/// A kernel with all that it takes to hunt it.
pub struct Prey<'a> {
    /// The kernel.
    pub kernel: &'a Kernel,
    /// What it should return.
    pub reference: Reference,
    /// Where it should return it.
    pub domain: Domain,
    /// The inputs as samplers know them.
    pub inputs: Vec<Input>,
}

impl Prey<'_> {
    /// Whether the kernel takes the point: the domain, but for roundings of its conditions.
    pub(super) fn takes(&self, point: &[f64]) -> bool {
        violated(self.kernel, &Compiled(0.0), point).is_none()
    }

    /// An estimate of the error of one result in ulp; `None` where the kernel refuses the point or nothing is known.
    pub(super) fn estimate(&self, result: usize, point: &[f64]) -> Option<f64> {
        if !self.takes(point) {
            return None;
        }
        let wide: Vec<_> = point.iter().map(|value| (*value).into()).collect();
        let arithmetic = Accurate::default();
        let exact = *evaluate(self.kernel, &arithmetic, &wide).get(result)?;
        let known = !arithmetic.left() && exact.low().is_finite();
        let got = *evaluate(self.kernel, &Compiled(0.0), point).get(result)?;
        known.then(|| distance(got, exact))
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
