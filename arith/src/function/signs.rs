//! Signs that a function's value can have where its argument is below zero, zero or above.

use core::cmp::Ordering::{self, Equal, Greater, Less};

pub(super) const NO_VALUE: &[Ordering] = &[];
pub(super) const NEGATIVE: &[Ordering] = &[Less];
pub(super) const ZERO: &[Ordering] = &[Equal];
pub(super) const POSITIVE: &[Ordering] = &[Greater];
pub(super) const NOT_POSITIVE: &[Ordering] = &[Less, Equal];
pub(super) const NOT_NEGATIVE: &[Ordering] = &[Equal, Greater];
pub(super) const ANY: &[Ordering] = &[Less, Equal, Greater];
