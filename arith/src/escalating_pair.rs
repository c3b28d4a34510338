//! `EscalatingPair`: a compensated expression in the arithmetics of calls, and the flag that it raises to escalate.

use core::cell::Cell;

use crate::bounded_pair::BoundedPair;

/// A pair, and the flag that it raises to escalate.
#[derive(Clone, Copy)]
pub struct EscalatingPair<'a, const WATCHED: bool, const FUSED: bool> {
    pub(crate) pair: BoundedPair<WATCHED, FUSED>,
    pub(crate) escalate: &'a Cell<bool>,
}

impl<'a, const WATCHED: bool, const FUSED: bool> EscalatingPair<'a, WATCHED, FUSED> {
    /// A pair, and the flag that it raises.
    #[inline(always)]
    pub(crate) fn new(pair: BoundedPair<WATCHED, FUSED>, escalate: &'a Cell<bool>) -> Self {
        EscalatingPair { pair, escalate }
    }

    /// Another pair with the same flag.
    #[inline(always)]
    pub(crate) fn with(&self, pair: BoundedPair<WATCHED, FUSED>) -> Self {
        EscalatingPair::new(pair, self.escalate)
    }
}
