//! Steps: what `f64` computes is within the stated bounds of the exact values, whose signs are the stated ones.

use super::values::{BITS, cases, float};
use closedform_generator::field::Sign;
use closedform_generator::program::{CompensatedExpr, Graph, Node, Op};
use closedform_syntax::Function;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use proptest::collection::vec;
use proptest::prelude::*;
use rug::Float;

pub const INPUTS: usize = 3;

/// A step: what it does, and with which of the steps before.
pub type Step = (u8, usize, usize);

pub fn steps() -> impl Strategy<Value = Vec<Step>> {
    vec((0_u8..10, any::<usize>(), any::<usize>()), 1..14)
}

/// The graph of some steps over inputs of these signs, and its nodes.
pub fn graph(signs: [Sign; INPUTS], steps: &[Step]) -> (Graph, Vec<Node>) {
    let mut graph = Graph::default();
    let mut nodes: Vec<Node> = signs.iter().enumerate().map(|(index, &sign)| graph.input(index, sign)).collect();
    for &(kind, a, b) in steps {
        let (first, second) = (nodes[a % nodes.len()], nodes[b % nodes.len()]);
        nodes.push(made(&mut graph, kind, first, second, b));
    }
    (graph, nodes)
}

fn made(graph: &mut Graph, kind: u8, a: Node, b: Node, number: usize) -> Node {
    let (sign_of_a, sign_of_b) = (graph.sign(a), graph.sign(b));
    match kind {
        0 => graph.add(a, b),
        1 => graph.sub(a, b),
        2 | 3 => graph.mul(a, b),
        4 if sign_of_b.is(Sign::NONZERO) => graph.div(a, b),
        5 if sign_of_a.is(Sign::NONNEGATIVE) => graph.call(Function::Sqrt, a),
        6 => graph.neg(a),
        7 => graph.call(Function::Abs, a),
        8 => graph.constant(&BigRational::new(((number % 41) as i64 - 20).into(), (number % 7 + 1).into())),
        9 => {
            let expression = CompensatedExpr::Sub(
                CompensatedExpr::Mul(CompensatedExpr::Leaf(a).into(), CompensatedExpr::Leaf(a).into()).into(),
                CompensatedExpr::Leaf(b).into(),
            );
            // what counts as exact must be so
            let exact = |node| matches!(graph.op(node), Op::Input(_) | Op::Literal(_));
            if exact(a) && exact(b) { graph.compensated(expression, Sign::ANY) } else { a }
        }
        _ => graph.extreme(true, vec![a, b]),
    }
}

/// A number, by its type: in doubles with one rounding a step, or in many bits.
trait Number: Clone {
    fn constant(value: &BigRational) -> Self;
    fn combine(op: &Op, operands: &[Self]) -> Self;
    fn compensated_expression(value: Float) -> Self;
    fn float(&self) -> Float;
}

impl Number for f64 {
    fn constant(value: &BigRational) -> Self {
        value.to_f64().unwrap()
    }

    fn combine(op: &Op, x: &[Self]) -> Self {
        match op {
            Op::Neg(_) => -x[0],
            Op::Add(..) => x[0] + x[1],
            Op::Sub(..) => x[0] - x[1],
            Op::Mul(..) => x[0] * x[1],
            Op::Div(..) => x[0] / x[1],
            Op::Call(Function::Sqrt, _) => x[0].sqrt(),
            Op::Call(Function::Abs, _) => x[0].abs(),
            Op::Max(_) => x.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            _ => panic!("{op:?}"),
        }
    }

    fn compensated_expression(value: Float) -> Self {
        value.to_f64()
    }

    fn float(&self) -> Float {
        Float::with_val(BITS, *self)
    }
}

impl Number for Float {
    fn constant(value: &BigRational) -> Self {
        float(value)
    }

    fn combine(op: &Op, x: &[Self]) -> Self {
        let of = |index: usize| x[index].clone();
        match op {
            Op::Neg(_) => -of(0),
            Op::Add(..) => of(0) + of(1),
            Op::Sub(..) => of(0) - of(1),
            Op::Mul(..) => of(0) * of(1),
            Op::Div(..) => of(0) / of(1),
            Op::Call(Function::Sqrt, _) => of(0).sqrt(),
            Op::Call(Function::Abs, _) => of(0).abs(),
            Op::Max(_) => x.iter().cloned().reduce(|a, b| a.max(&b)).unwrap(),
            _ => panic!("{op:?}"),
        }
    }

    fn compensated_expression(value: Float) -> Self {
        value
    }

    fn float(&self) -> Float {
        self.clone()
    }
}

fn value<N: Number>(graph: &Graph, node: Node, point: &[f64]) -> N {
    match graph.op(node) {
        Op::Input(index) => N::constant(&BigRational::from_float(point[*index]).unwrap()),
        Op::Literal(number) => N::constant(number),
        Op::Compensated(expression) => N::compensated_expression(compensated_value::<N>(graph, expression, point)),
        op => {
            N::combine(op, &graph.operands(node).into_iter().map(|node| value(graph, node, point)).collect::<Vec<N>>())
        }
    }
}

/// A compensated expression, exactly: many bits hold it.
fn compensated_value<N: Number>(graph: &Graph, expression: &CompensatedExpr, point: &[f64]) -> Float {
    let of = |expression: &CompensatedExpr| compensated_value::<N>(graph, expression, point);
    match expression {
        CompensatedExpr::Leaf(node) => value::<N>(graph, *node, point).float(),
        CompensatedExpr::Neg(a) => -of(a),
        CompensatedExpr::Add(a, b) => of(a) + of(b),
        CompensatedExpr::Sub(a, b) => of(a) - of(b),
        CompensatedExpr::Mul(a, b) => of(a) * of(b),
    }
}

/// Inputs with all their bits, of the signs that the graph is told.
fn inputs() -> impl Strategy<Value = (Vec<f64>, [Sign; INPUTS])> {
    vec((0.5_f64..4.0, any::<bool>(), any::<bool>()), INPUTS).prop_map(|inputs| {
        let point: Vec<f64> =
            inputs.iter().map(|(value, negative, _)| if *negative { -value } else { *value }).collect();
        let sign = |index: usize| match inputs[index] {
            (.., false) => Sign::ANY,
            (_, negative, _) => {
                if negative {
                    Sign::NEGATIVE
                } else {
                    Sign::POSITIVE
                }
            }
        };
        (point, [0, 1, 2].map(sign))
    })
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn bounds_and_signs_hold((point, signs) in inputs(), steps in steps()) {
        let (graph, nodes) = graph(signs, &steps);
        for node in nodes {
            let (exact, rounded): (Float, f64) = (value(&graph, node, &point), value(&graph, node, &point));
            if exact.is_nan() || !rounded.is_finite() || exact.clone().abs() > 1e200 || exact.clone().abs() < 1e-200 {
                continue; // bounds are for values that do not over- or underflow
            }
            let sign = if exact.is_sign_negative() { Sign::NEGATIVE } else { Sign::POSITIVE };
            prop_assert!(sign.is(graph.sign(node)), "{exact} is not {}", graph.sign(node));
            let error = graph.error(node);
            if error.is_finite() {
                let off = (Float::with_val(BITS, &exact - rounded).abs() / exact.abs()).to_f64() * 2.0_f64.powi(53);
                // terms of higher order: the bound is one of the first
                let limit = error + error * error * 2.0_f64.powi(-53);
                prop_assert!(off <= limit, "{off} units for {error}: {:?}", graph.op(node));
            }
        }
    }

    #[test]
    fn equal_steps_are_one((_, signs) in inputs(), steps in steps()) {
        let (mut graph, nodes) = graph(signs, &steps);
        // a minus goes into the sum, and takes another step there by the side on which it stands
        let minus = |node: &Node| matches!(graph.op(*node), Op::Literal(_) | Op::Neg(_));
        let values: Vec<Node> = nodes.into_iter().filter(|node| !minus(node)).collect();
        for &a in &values {
            for &b in &values {
                prop_assert_eq!(graph.add(a, b), graph.add(b, a));
                prop_assert_eq!(graph.mul(a, b), graph.mul(b, a));
                let difference = graph.sub(a, b);
                prop_assert!(graph.operands(difference).iter().all(|operand| *operand < difference));
            }
        }
    }
}

#[test]
fn what_may_cancel_has_no_bound() {
    let mut graph = Graph::default();
    let [x, y] = [0, 1].map(|index| graph.input(index, Sign::POSITIVE));
    let difference = graph.sub(x, y);
    assert_eq!(graph.error(difference), 1.0, "one rounding of exact operands");
    let third = graph.constant(&BigRational::new(1.into(), 3.into()));
    let rounded = graph.mul(third, y);
    let cancelling = graph.sub(x, rounded);
    assert!(graph.error(rounded) == 2.0 && graph.error(cancelling).is_infinite());
    let sum = graph.add(x, rounded);
    assert_eq!(graph.error(sum), 3.0);
}
