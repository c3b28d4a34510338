//! Comparisons of steps with zero.

use crate::field::Sign;
use crate::program::{Condition, Graph, Node, Op};
use closedform_arith::Relation;
use num_rational::BigRational;
use num_traits::Zero;

/// The condition that a step has a sign relation to zero; constant factors of the step and functions that keep the sign do not matter.
pub fn compared_with_zero(graph: &mut Graph, node: Node, order: Relation) -> Condition {
    let (inner, mirrored) = match *graph.op(node) {
        Op::Neg(a) => (a, true),
        Op::Call(function, a) if function.keeps_sign() => (a, false),
        Op::Mul(a, b) if has_one_sign(graph, a) => (b, graph.sign(a).is(Sign::NEGATIVE)),
        Op::Mul(a, b) if has_one_sign(graph, b) => (a, graph.sign(b).is(Sign::NEGATIVE)),
        _ => {
            let zero = graph.constant(&BigRational::zero());
            return Condition::Compare(node, order, zero);
        }
    };
    graph.replace(node, inner);
    compared_with_zero(graph, inner, if mirrored { order.mirrored() } else { order })
}

fn has_one_sign(graph: &Graph, node: Node) -> bool {
    let sign = graph.sign(node);
    sign.is_definite() && sign.is(Sign::NONZERO)
}

/// The sign relation that says "not of the opposite sign".
#[must_use]
pub fn not_opposite(sign: Sign) -> Option<Relation> {
    if sign.is(Sign::NONNEGATIVE) {
        Some(Relation::GreaterOrEqual)
    } else if sign.is(Sign::NONPOSITIVE) {
        Some(Relation::LessOrEqual)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_arith::Function;

    #[test]
    fn constant_factors_do_not_matter_but_for_their_sign() {
        let mut graph = Graph::default();
        let (x, y) = (graph.input(0, Sign::ANY), graph.input(1, Sign::NEGATIVE));
        let zero = graph.constant(&BigRational::zero());
        let minus_two = graph.constant(&BigRational::from_integer((-2).into()));
        let doubled = graph.mul(minus_two, x);
        let turned = graph.mul(doubled, y);
        let mut compared = |node| compared_with_zero(&mut graph, node, Relation::Greater);
        assert_eq!(compared(x), Condition::Compare(x, Relation::Greater, zero));
        assert_eq!(compared(doubled), Condition::Compare(x, Relation::Less, zero));
        assert_eq!(compared(turned), Condition::Compare(x, Relation::Greater, zero));
    }

    #[test]
    fn factors_that_may_be_zero_or_of_either_sign_do_matter() {
        let mut graph = Graph::default();
        let open = graph.input(0, Sign::ANY);
        let zero = graph.constant(&BigRational::zero());
        for (index, sign) in [(1, Sign::ANY), (2, Sign::NONNEGATIVE), (3, Sign::NONZERO)] {
            let factor = graph.input(index, sign);
            let product = if index == 2 { graph.mul(factor, open) } else { graph.mul(open, factor) };
            let expected = Condition::Compare(product, Relation::Greater, zero);
            assert_eq!(compared_with_zero(&mut graph, product, Relation::Greater), expected, "{sign}");
        }
    }

    #[test]
    fn only_functions_that_keep_the_sign_do_not_matter() {
        let mut graph = Graph::default();
        let x = graph.input(0, Sign::ANY);
        let zero = graph.constant(&BigRational::zero());
        for (name, keeps) in [("cbrt", true), ("atan", true), ("sin", false), ("round", false), ("truncate", false)] {
            let call = graph.call(Function::named(name).unwrap(), x);
            let expected = Condition::Compare(if keeps { x } else { call }, Relation::Greater, zero);
            assert_eq!(compared_with_zero(&mut graph, call, Relation::Greater), expected, "{name}");
        }
    }
}
