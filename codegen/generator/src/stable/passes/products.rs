//! Products of polynomials: as a compensated expression of limited size, its factors in order, or in steps.

use crate::field::Sign;
use crate::program::{CompensatedExpr, Graph, Node, is_exact};
use num_rational::BigRational;
use num_traits::{One, Signed};

/// The largest compensated expression: how many terms it may have when it is multiplied out, and how many factors a term.
const LARGEST: (usize, usize) = (2_000, 16);

/// A product as a compensated expression without its sign, and the product itself. The factors are put into one order, the
/// literal first: so products of the same factors share a step, whatever their signs. A product of two factors is not
/// compensated, since it is rounded once anyway.
pub fn in_order(graph: &mut Graph, expression: CompensatedExpr, sign: Sign) -> (Node, Node) {
    let (mut negative, mut factors) = (false, Vec::new());
    split(expression, &mut negative, &mut factors);
    let literal = |factor: &CompensatedExpr| {
        if let CompensatedExpr::Leaf(leaf) = factor { graph.literal(*leaf).cloned() } else { None }
    };
    let (literals, mut rest): (Vec<CompensatedExpr>, Vec<CompensatedExpr>) =
        factors.into_iter().partition(|factor| literal(factor).is_some());
    let mut constants: Vec<BigRational> = literals.iter().filter_map(literal).collect();
    negative ^= constants.iter().filter(|constant| constant.is_negative()).count() % 2 == 1;
    constants.iter_mut().for_each(|constant| *constant = constant.abs());
    let folded: BigRational = constants.iter().product();
    if is_exact(&folded) {
        constants = if folded.is_one() && !rest.is_empty() { Vec::new() } else { vec![folded] };
    }
    rest.sort_by_key(|factor| if let CompensatedExpr::Leaf(leaf) = factor { leaf.0 } else { usize::MAX });
    let leading: Vec<CompensatedExpr> =
        constants.iter().map(|constant| CompensatedExpr::Leaf(graph.constant(constant))).collect();
    let product = leading.into_iter().chain(rest).reduce(|a, b| CompensatedExpr::Mul(a.into(), b.into()));
    let product = product.unwrap_or_else(|| CompensatedExpr::Leaf(graph.constant(&BigRational::one())));
    let expression = match two_leaves(&product) {
        Some((a, b)) => graph.mul(a, b),
        None => graph.compensated(product, if negative { -sign } else { sign }),
    };
    (expression, if negative { graph.neg(expression) } else { expression })
}

/// The product in steps: each factor in steps of its own where they do not cancel, and as a compensated expression where
/// they may.
pub fn in_steps(graph: &mut Graph, expression: CompensatedExpr) -> Node {
    let (mut negative, mut factors) = (false, Vec::new());
    split(expression, &mut negative, &mut factors);
    let factors: Vec<Node> = factors.into_iter().map(|factor| factor_in_steps(graph, factor)).collect();
    let product = factors.into_iter().reduce(|a, b| graph.mul(a, b));
    let product = product.unwrap_or_else(|| graph.constant(&BigRational::one()));
    if negative { graph.neg(product) } else { product }
}

fn factor_in_steps(graph: &mut Graph, factor: CompensatedExpr) -> Node {
    let plain = steps(graph, &factor);
    if graph.error(plain).is_finite() { plain } else { graph.compensated(factor, Sign::ANY) }
}

fn steps(graph: &mut Graph, expression: &CompensatedExpr) -> Node {
    let mut both = |a: &CompensatedExpr, b: &CompensatedExpr| (steps(graph, a), steps(graph, b));
    match expression {
        CompensatedExpr::Leaf(node) => *node,
        CompensatedExpr::Neg(a) => {
            let a = steps(graph, a);
            graph.neg(a)
        }
        CompensatedExpr::Add(a, b) => {
            let (a, b) = both(a, b);
            graph.add(a, b)
        }
        CompensatedExpr::Sub(a, b) => {
            let (a, b) = both(a, b);
            graph.sub(a, b)
        }
        CompensatedExpr::Mul(a, b) => {
            let (a, b) = both(a, b);
            graph.mul(a, b)
        }
    }
}

fn two_leaves(expression: &CompensatedExpr) -> Option<(Node, Node)> {
    let CompensatedExpr::Mul(a, b) = expression else { return None };
    let (CompensatedExpr::Leaf(a), CompensatedExpr::Leaf(b)) = (&**a, &**b) else { return None };
    Some((*a, *b))
}

/// The factors of a product, without their signs.
fn split(expression: CompensatedExpr, negative: &mut bool, factors: &mut Vec<CompensatedExpr>) {
    match expression {
        CompensatedExpr::Mul(a, b) => [a, b].into_iter().for_each(|factor| split(*factor, negative, factors)),
        CompensatedExpr::Neg(a) => {
            *negative = !*negative;
            split(*a, negative, factors);
        }
        factor => factors.push(factor),
    }
}

/// Whether a compensated expression may be so large.
pub fn fits(expression: &CompensatedExpr) -> bool {
    let (terms, factors) = size(expression);
    terms <= LARGEST.0 && factors <= LARGEST.1
}

/// How many terms a compensated expression has when it is multiplied out, and how many factors the longest of them.
fn size(expression: &CompensatedExpr) -> (usize, usize) {
    match expression {
        CompensatedExpr::Leaf(_) => (1, 1),
        CompensatedExpr::Neg(a) => size(a),
        CompensatedExpr::Add(a, b) | CompensatedExpr::Sub(a, b) => {
            let (a, b) = (size(a), size(b));
            (a.0 + b.0, a.1.max(b.1))
        }
        CompensatedExpr::Mul(a, b) => {
            let (a, b) = (size(a), size(b));
            (a.0.saturating_mul(b.0), a.1 + b.1)
        }
    }
}
