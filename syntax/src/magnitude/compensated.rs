//! Compensated expressions: the high parts of their pairs, and the sum of the magnitudes of their terms.

use closedform_arith::range;

use crate::kernel::{BinaryOp, CompensatedExpr, Expr};

use super::bounds::{Bounds, LEAST};
use super::signs::Signs;

/// Magnitudes between which a product of pairs is error-free, and that of a factor; a bit off the runtime's. Where terms do not
/// cancel, high parts are off by less than that from what pairs stand for; where they may, a high part is a multiple of what its
/// pair is a multiple of, and nothing more is used.
const PRODUCTS: (i64, i64) = (range::PRODUCT.0 + 1, range::PRODUCT.1 - 1);
const FACTOR: i64 = range::FACTOR - 1;

/// A part of a compensated expression.
#[derive(Clone, Copy)]
struct Part {
    /// Its value.
    value: Bounds,
    /// The sum of the magnitudes of its terms.
    size: Bounds,
    /// Whether it is a pair, not an operand.
    extended: bool,
}

/// The value of a compensated expression that passes its rounding test.
pub(super) fn compensated(
    expression: &CompensatedExpr,
    signs: &Signs,
    leaf: &impl Fn(&Expr) -> Option<Bounds>,
) -> Option<Bounds> {
    let Part { value, size, extended } = part(&expression.value, signs, leaf)?;
    if !extended {
        return Some(value);
    }
    if expression.threshold < 0.0 {
        return Some(value.rounded());
    }
    // One place less for the roundings of the size. Where all terms are zero, so is the value.
    let settled = Bounds::literal(expression.threshold).low + size.low - 1;
    let value = Bounds { zero: value.zero && size.zero, low: value.low.max(settled), ..value };
    Some(value.rounded())
}

/// The value of a residual, which may vanish.
pub(super) fn residual(expression: &Expr, signs: &Signs, leaf: &impl Fn(&Expr) -> Option<Bounds>) -> Option<Bounds> {
    Some(part(expression, signs, leaf)?.value.rounded())
}

fn part(expression: &Expr, signs: &Signs, leaf: &impl Fn(&Expr) -> Option<Bounds>) -> Option<Part> {
    match expression {
        Expr::Neg(inner) => Some(negated(part(inner, signs, leaf)?)),
        Expr::Binary { op, left, right } => {
            let (left, right) = (part(left, signs, leaf)?, part(right, signs, leaf)?);
            let part = match op {
                BinaryOp::Mul => product(left, right),
                BinaryOp::Sub => sum(left, negated(right)),
                BinaryOp::Add | BinaryOp::Div => sum(left, right),
            };
            part.map(|part| Part { value: signs.refine(expression, part.value), ..part })
        }
        operand => {
            let value = leaf(operand)?;
            Some(Part { value, size: value.magnitude(), extended: false })
        }
    }
}

fn negated(part: Part) -> Part {
    Part { value: part.value.negated(), ..part }
}

fn sum(left: Part, right: Part) -> Option<Part> {
    let value = on_grid(left.value.sum(right.value));
    Some(Part { value, size: left.size.sum(right.size).finite()?, extended: true })
}

fn product(left: Part, right: Part) -> Option<Part> {
    let value = on_grid(left.value.product(right.value));
    let error_free = value.low >= PRODUCTS.0 && value.high <= PRODUCTS.1;
    let split = left.value.high <= FACTOR && right.value.high <= FACTOR;
    let size = left.size.product(right.size).finite()?;
    (error_free && split).then_some(Part { value, size, extended: true })
}

/// Parts below the smallest number are lost, and so is what they were multiples of.
fn on_grid(value: Bounds) -> Bounds {
    let grid = value.grid.max(LEAST);
    Bounds { grid, low: value.low.max(grid), ..value }
}
