//! Polynomials of operands with 53 bits by enclosures of more and more words, which mostly tell what an exact sum would.

use super::enclosure::Enclosure;
use super::limbs::Limbs;
use super::radius::Radius;
use crate::factored::{Stack, Step};
use crate::limits::MAX_STACK;
use crate::operand::Operand;
use crate::soft_float::SoftFloat;

/// The value of a [factored form](Step): its first 128 bits, and whether there are more. `None` where enclosures do not tell.
///
/// What they tell is the value's own, so it is bit for bit what an exact sum gives.
pub(crate) fn polynomial(operand: &dyn Fn(u8) -> Option<Operand>, steps: &[u8]) -> Option<SoftFloat> {
    let told_by_four = told::<4>(operand, steps);
    #[cfg(feature = "large-balls")]
    return told_by_four
        .or_else(|| told::<8>(operand, steps))
        .or_else(|| told::<16>(operand, steps))
        .or_else(|| told::<32>(operand, steps));
    #[cfg(not(feature = "large-balls"))]
    told_by_four
}

#[inline(never)]
fn told<const L: usize>(operand: &dyn Fn(u8) -> Option<Operand>, steps: &[u8]) -> Option<SoftFloat> {
    let mut stack = Stack::<Enclosure<L>, MAX_STACK>::new();
    for &step in steps {
        let value = match Step::of(step) {
            Step::Operand(position) => exact(operand(position)?),
            Step::Negative => stack.pop()?.negated(),
            operation => {
                let (second, first) = (stack.pop()?, stack.pop()?);
                match operation {
                    Step::Sum => first.plus(second),
                    Step::Difference => first.plus(second.negated()),
                    Step::Reversed => second.plus(first.negated()),
                    _ => first.times(second),
                }
            }
        };
        stack.push(value)?;
    }
    stack.pop()?.to_soft()
}

fn exact<const L: usize>(operand: Operand) -> Enclosure<L> {
    let Operand { negative, significand, exponent } = operand;
    Enclosure { middle: Limbs::from_integer(negative, significand, exponent), radius: Radius::ZERO }
}
