//! Text: what is printed of a program reads back as the same steps.

use super::graphs::{INPUTS, graph, steps};
use super::values::cases;
use closedform_generator::field::Sign;
use closedform_generator::program::{CompensatedExpr, Condition, Graph, Node, Op, name_steps};
use closedform_generator::rust::{InputDoc, KernelText, ModuleText, RequireText, ResultText, print_module};
use closedform_syntax::{BinaryOp, Condition as SourceCondition, Expr, Kernel, Precision, Relation, parse_file};
use num_rational::BigRational;
use proptest::prelude::*;

/// The text of a kernel that computes one node.
fn text_of(graph: Graph, output: Node, conditions: Vec<Condition>) -> KernelText {
    let input = |index: usize| InputDoc {
        name: format!("x{index}"),
        maxima: format!("x{index}"),
        unit: "1".to_owned(),
        doc: String::new(),
        typical: [0.1, 10.0],
    };
    let inputs: Vec<InputDoc> = (0..INPUTS).map(input).collect();
    let taken: Vec<String> = inputs.iter().map(|input| input.name.clone()).collect();
    let program = name_steps(&graph, &[output], &taken);
    let result = ResultText { name: "f".to_owned(), worksheet: "f".to_owned(), unit: "1".to_owned(), bound: 1.0 };
    KernelText {
        name: "made".to_owned(),
        doc: "Random steps.".to_owned(),
        maxima: vec!["f(x0,x1,x2):=x0".to_owned()],
        latex: String::new(),
        source: String::new(),
        branch: None,
        edges: None,
        returns: None,
        inputs,
        requires: conditions.into_iter().map(|condition| RequireText::new(condition, "a condition")).collect(),
        results: vec![result],
        example: None,
        rules: Vec::new(),
        precision: Precision::Double,
        certified_because: None,
        graph,
        program,
    }
}

fn read_back(kernel: &KernelText) -> (String, Kernel) {
    let kernels = std::slice::from_ref(kernel);
    let text = print_module(&ModuleText { family: "made", title: "Made", source: "", made_from: "made.mac", kernels });
    let read = parse_file(&text).unwrap_or_else(|cause| panic!("{cause}\n{text}")).remove(0);
    (text, read)
}

/// The text beside the graph that it must be of.
struct Beside<'k> {
    graph: &'k Graph,
    kernel: &'k Kernel,
}

impl<'k> Beside<'k> {
    /// Whether an expression of the text, with its steps in place of their names, is a node.
    fn same(&self, node: Node, expr: &'k Expr) -> bool {
        if let Expr::Name(name) = expr {
            return match name.slot.checked_sub(INPUTS) {
                None => *self.graph.op(node) == Op::Input(name.slot),
                Some(step) => self.same(node, &self.kernel.lets[step].value),
            };
        }
        match (self.graph.op(node), expr) {
            (Op::Literal(value), expr) => number(expr).as_ref() == Some(value),
            (Op::Pi, Expr::Pi(_)) => true,
            (Op::Neg(a), Expr::Neg(inner)) => self.same(*a, inner),
            (Op::Call(f, a), Expr::Call(g, inner)) => f == g && self.same(*a, inner),
            (op, Expr::Binary { op: found, left, right }) => {
                operands(op, *found).is_some_and(|[a, b]| self.same(a, left) && self.same(b, right))
            }
            (Op::Max(nodes), Expr::Extreme { largest: true, items })
            | (Op::Min(nodes), Expr::Extreme { largest: false, items }) => {
                nodes.len() == items.len() && nodes.iter().zip(items).all(|(node, item)| self.same(*node, item))
            }
            (Op::Compensated(expression), Expr::Compensated(read)) => self.same_compensated(expression, &read.value),
            (Op::If(condition, a, b), Expr::If { condition: found, then, otherwise }) => {
                self.same_condition(condition, found) && self.same(*a, then) && self.same(*b, otherwise)
            }
            _ => false,
        }
    }

    fn same_compensated(&self, expression: &CompensatedExpr, expr: &'k Expr) -> bool {
        match (expression, expr) {
            (CompensatedExpr::Leaf(node), expr) => self.same(*node, expr),
            (CompensatedExpr::Neg(a), Expr::Neg(inner)) => self.same_compensated(a, inner),
            (CompensatedExpr::Add(a, b), Expr::Binary { op: BinaryOp::Add, left, right })
            | (CompensatedExpr::Sub(a, b), Expr::Binary { op: BinaryOp::Sub, left, right })
            | (CompensatedExpr::Mul(a, b), Expr::Binary { op: BinaryOp::Mul, left, right }) => {
                self.same_compensated(a, left) && self.same_compensated(b, right)
            }
            _ => false,
        }
    }

    fn same_condition(&self, condition: &Condition, found: &'k SourceCondition) -> bool {
        match (condition, found) {
            (Condition::Compare(a, order, b), SourceCondition::Compare { op, left, right }) => {
                order == op && self.same(*a, left) && self.same(*b, right)
            }
            (Condition::And(a, b), SourceCondition::And(left, right))
            | (Condition::Or(a, b), SourceCondition::Or(left, right)) => {
                self.same_condition(a, left) && self.same_condition(b, right)
            }
            (Condition::Not(a), SourceCondition::Not(inner)) => self.same_condition(a, inner),
            _ => false,
        }
    }
}

fn number(expr: &Expr) -> Option<BigRational> {
    match expr {
        Expr::Literal { value, .. } => BigRational::from_float(*value),
        Expr::Neg(inner) => number(inner).map(|value| -value),
        _ => None,
    }
}

fn operands(op: &Op, found: BinaryOp) -> Option<[Node; 2]> {
    match (op, found) {
        (Op::Add(a, b), BinaryOp::Add)
        | (Op::Sub(a, b), BinaryOp::Sub)
        | (Op::Mul(a, b), BinaryOp::Mul)
        | (Op::Div(a, b), BinaryOp::Div) => Some([*a, *b]),
        _ => None,
    }
}

fn conditions(nodes: &[Node], choices: &[(usize, usize)]) -> Condition {
    let compare = |&(a, b): &(usize, usize)| {
        Condition::Compare(nodes[a % nodes.len()], Relation::ALL[(a ^ b) % 6], nodes[b % nodes.len()])
    };
    let joined = |one: Condition, (at, other): (usize, Condition)| match at % 3 {
        0 => Condition::And(one.into(), other.into()),
        1 => Condition::Or(other.into(), one.into()),
        _ => Condition::Not(Box::new(Condition::And(one.into(), other.into()))),
    };
    let mut parts = choices.iter().map(compare);
    let first = parts.next().unwrap();
    parts.enumerate().fold(first, joined)
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn text_reads_back(
        steps in steps(), choices in proptest::collection::vec((any::<usize>(), any::<usize>()), 1..5)
    ) {
        let (mut graph, nodes) = graph([Sign::POSITIVE, Sign::ANY, Sign::NONNEGATIVE], &steps);
        let condition = conditions(&nodes, &choices);
        let last = nodes[nodes.len() - 1];
        let output = graph.select(condition.clone(), last, nodes[nodes.len() / 2]);
        let made = text_of(graph, output, vec![condition.clone()]);
        let (text, kernel) = read_back(&made);
        let comparison = Beside { graph: &made.graph, kernel: &kernel };
        prop_assert!(comparison.same_condition(&condition, &kernel.requires[0].condition), "{text}");
        prop_assert!(comparison.same(output, kernel.output.values().next().unwrap()), "{text}");
    }
}

#[test]
fn a_doctored_text_is_another_one() {
    let mut graph = Graph::default();
    let [x, y] = [0, 1].map(|index| graph.input(index, Sign::POSITIVE));
    let sum = graph.add(x, y);
    let output = graph.mul(sum, x);
    let made = text_of(graph, output, Vec::new());
    let (text, _) = read_back(&made);
    for (right, wrong) in [("x0 + x1", "x0 - x1"), ("x0 + x1", "x1 + x0"), ("* x0", "* x1"), (") * x0", ") / x0")] {
        assert!(text.contains(right), "{text}");
        let kernel = parse_file(&text.replace(right, wrong)).unwrap().remove(0);
        let comparison = Beside { graph: &made.graph, kernel: &kernel };
        assert!(!comparison.same(output, kernel.output.values().next().unwrap()), "{wrong}");
    }
}
