//! `EscalatingPair`: a compensated expression in the arithmetics of calls, and the flag that it raises to escalate.

use core::cell::Cell;

use crate::bounded_pair::BoundedPair;

/// A pair, and the flag that it raises to escalate.
#[derive(Clone, Copy)]
pub struct EscalatingPair<'a, const WATCHED: bool> {
    pub(crate) pair: BoundedPair<WATCHED>,
    pub(crate) escalate: &'a Cell<bool>,
}

impl<'a, const WATCHED: bool> EscalatingPair<'a, WATCHED> {
    /// A pair, and the flag that it raises.
    #[inline(always)]
    pub(crate) fn new(pair: BoundedPair<WATCHED>, escalate: &'a Cell<bool>) -> Self {
        EscalatingPair { pair, escalate }
    }

    /// Another pair with the same flag.
    #[inline(always)]
    pub(crate) fn with(&self, pair: BoundedPair<WATCHED>) -> Self {
        EscalatingPair::new(pair, self.escalate)
    }
}
