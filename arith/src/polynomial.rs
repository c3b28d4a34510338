//! Polynomials of operands with 53 bits, to all digits: by enclosures of some hundred bits where they tell, else exactly.

use crate::ball;
use crate::exact;
use crate::operand::Operand;
use crate::soft_float::SoftFloat;
use crate::terms::Terms;

/// A sum of products of operands.
///
/// `None` unless all operands, as `read` reads them, are numbers, and where terms lie so far apart that their sum is
/// longer than any of `f64`.
#[cold]
#[inline(never)]
pub(crate) fn polynomial<T>(operands: &[&T], read: fn(&T) -> Option<Operand>, terms: Terms) -> Option<SoftFloat> {
    if operands.iter().any(|operand| read(operand).is_none()) {
        return None;
    }
    let operand = |position: u8| operands.get(usize::from(position)).and_then(|operand| read(operand));
    ball::polynomial(&operand, terms.factored()).or_else(|| exact::polynomial(&operand, terms))
}
