//! From metres to the units of an axis on the controller: counts, their sign, and where they begin.

use super::error::ExportError;

/// How positions become those of the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    /// Units of the controller a metre; negative where its axis runs the other way.
    pub counts: f64,
    /// What the controller says at position 0, in its units.
    pub offset: f64,
}

impl Scaling {
    /// Metres, as they are.
    pub const METRES: Self = Self { counts: 1.0, offset: 0.0 };

    pub(super) fn position(self, metres: f64) -> f64 {
        metres * self.counts + self.offset
    }

    pub(super) fn velocity(self, metres: f64) -> f64 {
        metres * self.counts
    }
}

/// One an axis: that of all, or each its own; metres where none is given.
pub(super) fn of_axes(given: &[Scaling], axes: usize) -> Result<Vec<Scaling>, ExportError> {
    let fits = |scaling: &Scaling| scaling.counts != 0.0 && scaling.counts.is_finite() && scaling.offset.is_finite();
    match given {
        [] => Ok(vec![Scaling::METRES; axes]),
        [all] if fits(all) => Ok(vec![*all; axes]),
        _ if given.len() == axes && given.iter().all(fits) => Ok(given.to_vec()),
        _ => Err(ExportError::Scalings { found: given.len(), axes }),
    }
}
