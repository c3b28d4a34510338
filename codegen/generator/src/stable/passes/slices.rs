//! Products of polynomials: as a slice, whose factors have an order and whose size a limit, or in steps.

use crate::field::Sign;
use crate::program::{Graph, Node, Wide, is_exact};
use num_rational::BigRational;
use num_traits::{One, Signed};

/// The most terms of a slice, multiplied out, and the most factors of one.
const LARGEST: (usize, usize) = (2_000, 16);

/// A slice of a product without its sign, and the product: one literal and then the other factors in one order, so that
/// equal slices, and those of other signs, are one step. A product of two takes one rounding anyway.
pub fn in_order(graph: &mut Graph, wide: Wide, sign: Sign) -> (Node, Node) {
    let (mut negative, mut factors) = (false, Vec::new());
    split(wide, &mut negative, &mut factors);
    let literal = |factor: &Wide| if let Wide::Leaf(leaf) = factor { graph.literal(*leaf).cloned() } else { None };
    let (literals, mut rest): (Vec<Wide>, Vec<Wide>) =
        factors.into_iter().partition(|factor| literal(factor).is_some());
    let mut constants: Vec<BigRational> = literals.iter().filter_map(literal).collect();
    negative ^= constants.iter().filter(|constant| constant.is_negative()).count() % 2 == 1;
    constants.iter_mut().for_each(|constant| *constant = constant.abs());
    let folded: BigRational = constants.iter().product();
    if is_exact(&folded) {
        constants = if folded.is_one() && !rest.is_empty() { Vec::new() } else { vec![folded] };
    }
    rest.sort_by_key(|factor| if let Wide::Leaf(leaf) = factor { leaf.0 } else { usize::MAX });
    let leading: Vec<Wide> = constants.iter().map(|constant| Wide::Leaf(graph.constant(constant))).collect();
    let product = leading.into_iter().chain(rest).reduce(|a, b| Wide::Mul(a.into(), b.into()));
    let product = product.unwrap_or_else(|| Wide::Leaf(graph.constant(&BigRational::one())));
    let slice = match two_leaves(&product) {
        Some((a, b)) => graph.mul(a, b),
        None => graph.compensated(product, if negative { -sign } else { sign }),
    };
    (slice, if negative { graph.neg(slice) } else { slice })
}

/// The product in steps: each factor in steps of its own where they do not cancel, and as a slice where they may.
pub fn in_steps(graph: &mut Graph, wide: Wide) -> Node {
    let (mut negative, mut factors) = (false, Vec::new());
    split(wide, &mut negative, &mut factors);
    let factors: Vec<Node> = factors.into_iter().map(|factor| factor_in_steps(graph, factor)).collect();
    let product = factors.into_iter().reduce(|a, b| graph.mul(a, b));
    let product = product.unwrap_or_else(|| graph.constant(&BigRational::one()));
    if negative { graph.neg(product) } else { product }
}

fn factor_in_steps(graph: &mut Graph, factor: Wide) -> Node {
    let plain = steps(graph, &factor);
    if graph.error(plain).is_finite() { plain } else { graph.compensated(factor, Sign::ANY) }
}

fn steps(graph: &mut Graph, wide: &Wide) -> Node {
    let mut both = |a: &Wide, b: &Wide| (steps(graph, a), steps(graph, b));
    match wide {
        Wide::Leaf(node) => *node,
        Wide::Neg(a) => {
            let a = steps(graph, a);
            graph.neg(a)
        }
        Wide::Add(a, b) => {
            let (a, b) = both(a, b);
            graph.add(a, b)
        }
        Wide::Sub(a, b) => {
            let (a, b) = both(a, b);
            graph.sub(a, b)
        }
        Wide::Mul(a, b) => {
            let (a, b) = both(a, b);
            graph.mul(a, b)
        }
    }
}

fn two_leaves(wide: &Wide) -> Option<(Node, Node)> {
    let Wide::Mul(a, b) = wide else { return None };
    let (Wide::Leaf(a), Wide::Leaf(b)) = (&**a, &**b) else { return None };
    Some((*a, *b))
}

/// The factors of a product, without their signs.
fn split(wide: Wide, negative: &mut bool, factors: &mut Vec<Wide>) {
    match wide {
        Wide::Mul(a, b) => [a, b].into_iter().for_each(|factor| split(*factor, negative, factors)),
        Wide::Neg(a) => {
            *negative = !*negative;
            split(*a, negative, factors);
        }
        factor => factors.push(factor),
    }
}

/// Whether a slice may be so large.
pub fn fits(wide: &Wide) -> bool {
    let (terms, factors) = size(wide);
    terms <= LARGEST.0 && factors <= LARGEST.1
}

/// How many terms a slice has when it is multiplied out, and how many factors the longest of them.
fn size(wide: &Wide) -> (usize, usize) {
    match wide {
        Wide::Leaf(_) => (1, 1),
        Wide::Neg(a) => size(a),
        Wide::Add(a, b) | Wide::Sub(a, b) => {
            let (a, b) = (size(a), size(b));
            (a.0 + b.0, a.1.max(b.1))
        }
        Wide::Mul(a, b) => {
            let (a, b) = (size(a), size(b));
            (a.0.saturating_mul(b.0), a.1 + b.1)
        }
    }
}
