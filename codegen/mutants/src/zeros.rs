//! Where a sum, a compensated expression or a difference of compared sides vanishes: found by the kernel's own arithmetic.

use std::collections::HashSet;

use closedform_syntax::{BinaryOp, Condition, Expr, Kernel, Output, expression_text};

use super::place::Part;
use closedform_measure::accuracy::results;
use closedform_project::sample::{bisect, rank, unrank};

/// The farthest that two inputs are moved in ulp to find a deep cancellation.
const REACH: i64 = 12;

/// A part of a kernel that may vanish.
#[derive(Clone, Debug)]
pub struct Probe {
    /// A kernel without conditions that returns it.
    kernel: Kernel,
}

impl Probe {
    /// Every sum, compensated expression and comparison of a kernel, each once.
    pub fn all(kernel: &Kernel) -> Vec<Probe> {
        let mut seen = HashSet::new();
        let mut probes = Vec::new();
        for part in Part::all(kernel) {
            let mut found = Vec::new();
            match part {
                Part::Require(at) => of_condition(&kernel.requires[at].condition, &mut found),
                Part::Let(at) => of_expression(&kernel.lets[at].value, &mut found),
                Part::Result(at) => kernel.output.values().skip(at).take(1).for_each(|e| of_expression(e, &mut found)),
            }
            let steps = match part {
                Part::Require(_) => 0,
                Part::Let(at) => at,
                Part::Result(_) => kernel.lets.len(),
            };
            found.retain(|value| seen.insert(expression_text(value)));
            probes.extend(found.into_iter().map(|value| Probe::of(kernel, steps, value)));
        }
        probes
    }

    /// How many of all, the first ones, are of `require!`.
    pub fn of_conditions(kernel: &Kernel) -> usize {
        let mut conditions = kernel.clone();
        conditions.lets.clear();
        conditions.output = Output::Value(Expr::Pi(kernel.name.span()));
        Probe::all(&conditions).len()
    }

    fn of(kernel: &Kernel, steps: usize, value: Expr) -> Probe {
        let mut kernel = kernel.clone();
        kernel.attributes.clear();
        kernel.requires.clear();
        kernel.lets.truncate(steps);
        kernel.output = Output::Value(value);
        Probe { kernel }
    }

    /// The value at a point.
    pub fn value(&self, point: &[f64]) -> f64 {
        results(&self.kernel, point).ok().and_then(|values| values.first().copied()).unwrap_or(f64::NAN)
    }

    /// The value at the point with another value of one input.
    pub fn moved(&self, point: &[f64], input: usize, value: f64) -> f64 {
        let mut moved = point.to_vec();
        moved[input] = value;
        self.value(&moved)
    }

    /// Two neighbouring values of an input, from its own to `other`, between which the sign changes.
    pub fn bisect(&self, point: &[f64], input: usize, other: f64) -> Option<[f64; 2]> {
        let positive = |value: f64| Some(self.moved(point, input, value)).filter(|v| !v.is_nan()).map(|v| v > 0.0);
        bisect(point[input], other, positive)
    }

    /// The value of an input at which it vanishes, if it is linear in it and nothing was rounded.
    pub fn solve(&self, point: &[f64], input: usize) -> Option<f64> {
        let at = |value: f64| self.moved(point, input, value);
        let (zero, one, two) = (at(0.0), at(1.0), at(2.0));
        let slope = one - zero;
        let root = -zero / slope;
        (two - one == slope && root.is_finite() && at(root) == 0.0).then_some(root)
    }

    /// Points a few ulp beside a zero, two inputs moved, where it is as small as can be without vanishing.
    pub fn deepest(&self, zero: &[f64], one: usize, other: usize) -> Option<Vec<f64>> {
        let mut deepest: Option<(f64, Vec<f64>)> = None;
        for (first, second) in (-REACH..=REACH).flat_map(|first| (-REACH..=REACH).map(move |second| (first, second))) {
            let mut point = zero.to_vec();
            point[one] = unrank(rank(zero[one]) + first);
            point[other] = unrank(rank(zero[other]) + second);
            let size = self.value(&point).abs();
            if size > 0.0 && deepest.as_ref().is_none_or(|(least, _)| size < *least) {
                deepest = Some((size, point));
            }
        }
        deepest.map(|(_, point)| point)
    }
}

/// Of every comparison inside, the difference of its sides; of every sum and compensated expression the value; of every
/// extreme the differences of neighbours.
fn of_condition(condition: &Condition, found: &mut Vec<Expr>) {
    for comparison in condition.comparisons() {
        if let [left, right] = comparison.sides()[..] {
            found.push(difference(left, right));
            of_expression(left, found);
            of_expression(right, found);
        }
    }
}

fn difference(left: &Expr, right: &Expr) -> Expr {
    Expr::Binary { op: BinaryOp::Sub, left: left.clone().into(), right: right.clone().into() }
}

fn of_expression(expr: &Expr, found: &mut Vec<Expr>) {
    match expr {
        Expr::Compensated(_) | Expr::Residual(_) => return found.push(expr.clone()),
        Expr::Binary { op: BinaryOp::Add | BinaryOp::Sub, .. } => found.push(expr.clone()),
        Expr::If { condition, then, otherwise } => {
            of_condition(condition, found);
            [then, otherwise].into_iter().for_each(|side| of_expression(side, found));
            return;
        }
        Expr::Extreme { items, .. } => {
            found.extend(items.windows(2).filter_map(|pair| Some(difference(pair.first()?, pair.last()?))));
        }
        _ => {}
    }
    expr.children().into_iter().for_each(|child| of_expression(child, found));
}
