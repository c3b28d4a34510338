//! The keys of `#[kernel(..)]` that state proved bounds: `bound` and `certificate`.

use closedform_syntax::{Kernel, Output, certificate};
use std::fmt;

/// Both keys as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Keys {
    /// `bound = 2.0`, or `bound(t1 = 4.0, a1 = 1.5)`.
    pub bound: String,
    /// `certificate = ".."`
    pub certificate: String,
}

impl Keys {
    /// Those of a kernel and its proved bounds, in ulp, one a result.
    #[must_use]
    pub fn of(kernel: &Kernel, bounds: &[f64]) -> Self {
        let mut proved = kernel.clone();
        for (result, bound) in proved.meta.results.iter_mut().zip(bounds) {
            result.bound = Some(*bound);
        }
        let results = kernel.meta.results.iter().zip(bounds);
        let fields: Vec<String> = results.map(|(result, bound)| format!("{} = {bound:?}", result.name)).collect();
        let bound = match (&kernel.output, bounds) {
            (Output::Value(_), [bound]) => format!("bound = {bound:?}"),
            _ => format!("bound({})", fields.join(", ")),
        };
        Self { bound, certificate: format!("certificate = {:?}", certificate(&proved)) }
    }
}

impl fmt::Display for Keys {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.bound, self.certificate)
    }
}
