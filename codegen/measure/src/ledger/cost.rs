//! What the forms of a result cost, in additions: counted, so that a cost changes only with the form.
//!
//! Divisions and roots weigh what they take on current 64-bit processors beside an addition, when nothing waits for them;
//! an operation in double-double what its own operations do. Iterations weigh as their usual number of steps. What a
//! machine really takes is measured by `cargo bench -p closedform-tests --bench ratios`.

use closedform_arith::Function;
use closedform_arith::function::Cost;
use closedform_maxima::{Expr, double_operations};
use closedform_syntax::{Operations, Precision};

/// A division.
const DIVISION: u32 = Cost::DIVISION;

/// The operations of double-double: addition, multiplication, division.
const DOUBLE_DOUBLE: [u32; 3] = [20, 9, 16 + 2 * DIVISION];

/// An operation on pairs inside a compensated expression: the mean of its kinds, exact operands or not, with the size kept beside it.
const IN_COMPENSATED: u32 = 7;

/// The operations of balls of 256 bits, in the same order, and a root of a polynomial: about as many ns as a call takes for each.
const BALL: [u32; 3] = [100, 130, 700];
const ROOT_OF_BALLS: u32 = 8_000;

/// A falling iteration: about a dozen steps through a polynomial of degree four and its derivative, each with a division.
const ITERATION: u32 = 12 * (2 * 2 * 4 + DIVISION);

/// The default call of a kernel of this precision.
pub(super) fn default(count: &Operations, precision: Precision) -> u32 {
    match precision {
        Precision::Double => in_double(count),
        Precision::DoubleDouble => faithful(count),
        Precision::Certified => certified(count),
    }
}

fn in_double(count: &Operations) -> u32 {
    count.add + count.mul + DIVISION * count.div + calls(count, |cost| cost.double) + inner(count)
}

/// The faithful call, where nothing over- or underflows.
pub(super) fn faithful(count: &Operations) -> u32 {
    let [add, mul, div] = DOUBLE_DOUBLE;
    add * count.add + mul * count.mul + div * count.div + calls(count, |cost| cost.double_double) + inner(count)
}

/// The certified call, where 256 bits are enough.
fn certified(count: &Operations) -> u32 {
    let [add, mul, div] = BALL;
    add * (count.add + count.compensated)
        + mul * count.mul
        + div * count.div
        + calls(count, |cost| cost.ball)
        + ROOT_OF_BALLS * count.root
}

/// The formula as it is written; `None` where it has no such form.
pub(super) fn as_written(formula: &Expr) -> Option<u32> {
    let count = double_operations(formula)?;
    let root = |function: Function, calls: u32| calls * function.properties().cost.double;
    let roots = root(Function::Sqrt, count.sqrt) + root(Function::Cbrt, count.cbrt);
    Some(count.add + count.mul + DIVISION * count.div + roots)
}

/// The calls of functions, each at its cost.
fn calls(count: &Operations, cost: fn(Cost) -> u32) -> u32 {
    count.calls().map(|(function, calls)| calls * cost(function.properties().cost)).sum()
}

fn inner(count: &Operations) -> u32 {
    IN_COMPENSATED * count.compensated + ITERATION * count.root
}
