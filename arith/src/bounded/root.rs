//! The one positive root of a polynomial whose coefficients have errors: an iterate, and two signs that enclose the root.

use super::{Bounded, Signs};
use crate::error_model::bounded::{ROOT, ROOT_SHARE};
use crate::limits::MAX_DEGREE;
use crate::root;

/// The root, with a count of [`ROOT`]; it escalates where the signs of coefficients, or of the polynomial on both sides, are not certain.
pub(super) fn positive_root<'a, const WATCHED: bool>(
    context: &Bounded<'a, WATCHED>,
    coefficients: &[Bounded<'a, WATCHED>],
) -> Bounded<'a, WATCHED> {
    let root = root::root_of(coefficients, |coefficient| coefficient.value);
    let zero = context.exactly(0.0, Signs::of(0.0));
    coefficients.iter().for_each(|coefficient| coefficient.compare(&zero));
    let at = |place| horner(coefficients, &context.exactly(place, Signs::POSITIVE), zero);
    let (below, above) = (at(root * (1.0 - ROOT_SHARE)), at(root * (1.0 + ROOT_SHARE)));
    let encloses = (below < zero) & (above > zero);
    context.raise(!(encloses & root.is_normal()));
    Bounded { count: ROOT, ..context.exactly(root, Signs::POSITIVE) }
}

fn horner<'a, const WATCHED: bool>(
    coefficients: &[Bounded<'a, WATCHED>],
    x: &Bounded<'a, WATCHED>,
    zero: Bounded<'a, WATCHED>,
) -> Bounded<'a, WATCHED> {
    coefficients.iter().take(MAX_DEGREE + 1).rev().fold(zero, |value, coefficient| value.product(x).sum(coefficient))
}
