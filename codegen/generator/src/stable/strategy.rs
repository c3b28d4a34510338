//! The strategy: every rule, and the order in which they are tried.
//!
//! 1. Elements become steps by forms, the first that applies. A later result may go through an earlier one.
//! 2. The root of an equation becomes steps by a solver: [`SOLVER`].
//! 3. The finished program goes through passes: polynomials of many roundings are fused, divisions are shared where the
//!    contract asks for that. If that leaves too many roundings, the program in double-double is made too and taken.
//!
//! Where no stable form is found or proved at all, the formula is certified as it is written.

use super::builder::{AllForms, Builder, Form, Forms};
use super::candidate::Candidate;
use super::forms::through_result::{Earlier, Later};
use super::forms::{
    certified, compensated, conjugate, cube_conjugate, cube_quotient, cubic, differences_first, divided, factored,
    known_sum, merge_cubes, merge_roots, plain, same_sign_radicand, sign_branch, sum, through_result,
};
use super::passes::double_double::{self, DoubleDouble};
use super::passes::fused::{self, Fused};
use super::passes::one_reciprocal::{self, OneReciprocal, Products};
use super::passes::{Pass, distributed};
use super::rule::Rule;
use super::solvers::{Solver, monotone_newton};
use crate::field::{Element, Tower, TowerError};
use crate::program::{Graph, Node};

/// Every rule, in alphabetical order.
pub const ALL: [&Rule; 18] = [
    &certified::RULE,
    &compensated::RULE,
    &conjugate::RULE,
    &cube_conjugate::RULE,
    &cube_quotient::RULE,
    &differences_first::RULE,
    &distributed::RULE,
    &double_double::RULE,
    &factored::RULE,
    &fused::RULE,
    &known_sum::RULE,
    &merge_cubes::RULE,
    &merge_roots::RULE,
    &monotone_newton::RULE,
    &one_reciprocal::RULE,
    &same_sign_radicand::RULE,
    &sign_branch::RULE,
    &through_result::RULE,
];

/// The forms, in the order in which they are tried.
const FORMS: &AllForms = &AllForms {
    polynomials: Forms { tried: &[plain::steps, differences_first::steps, known_sum::steps], last: compensated::steps },
    surds: Forms {
        tried: &[merge_cubes::steps, merge_roots::steps, same_sign_radicand::steps, sum::steps, conjugate::steps],
        last: sign_branch::steps,
    },
    cubics: Forms {
        tried: &[merge_cubes::steps, merge_roots::steps, cubic::steps, cube_conjugate::steps, cube_quotient::steps],
        last: sign_branch::of_cubes,
    },
    quotients: Forms { tried: &[factored::steps], last: divided::steps },
};

/// What is tried of a result before its own form.
const THROUGH_EARLIER: Form<Later> = through_result::steps;

/// Finds the roots of equations.
pub const SOLVER: Solver = monotone_newton::steps;

/// The rule by which a formula is taken as it is written.
pub const AS_WRITTEN: &Rule = &certified::RULE;

/// How polynomials of many roundings are fused.
const fn fused(always: bool) -> Fused {
    Fused { always, product: distributed::product }
}

/// The rules of some names, in alphabetical order.
pub fn rules_named<'n>(names: impl IntoIterator<Item = &'n str>) -> Vec<&'static Rule> {
    let names: Vec<&str> = names.into_iter().collect();
    ALL.into_iter().filter(|rule| names.contains(&rule.name)).collect()
}

/// A builder over a tower, with nothing built yet.
#[must_use]
pub fn builder(tower: Tower) -> Builder {
    Builder::new(tower, FORMS)
}

/// The steps of several results that share work, in order.
///
/// # Errors
/// When the tower has no room left.
pub fn results(builder: &mut Builder, elements: &[Element]) -> Result<Vec<Node>, TowerError> {
    let mut earlier: Vec<Earlier> = Vec::new();
    for element in elements {
        let later = Later { element: element.clone(), earlier };
        let node = result(builder, &later)?;
        earlier = later.earlier;
        earlier.push(Earlier { element: later.element, node });
    }
    Ok(earlier.into_iter().map(|result| result.node).collect())
}

/// The steps of a result: through an earlier one if that can be, unless it has more roundings than the direct form and too
/// many.
fn result(builder: &mut Builder, later: &Later) -> Result<Node, TowerError> {
    let Some(through) = THROUGH_EARLIER(builder, later)? else { return builder.element(&later.element) };
    if builder.graph.error(through) <= fused::ENOUGH {
        return Ok(through);
    }
    let direct = builder.element(&later.element)?;
    let [direct_error, through_error] = [direct, through].map(|node| error_once_fused(&builder.graph, node));
    Ok(if direct_error < through_error { direct } else { through })
}

fn error_once_fused(graph: &Graph, result: Node) -> f64 {
    let candidate = Candidate::new(graph.clone(), vec![result]);
    after(&fused(true), candidate).worst_error()
}

/// What a contract wants of a program.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// As few roundings as there can be.
    pub few_roundings: bool,
    /// One division for all results.
    pub one_division: bool,
}

/// The best program for some results of a graph.
#[must_use]
pub fn finished(graph: Graph, outputs: Vec<Node>, wanted: Wanted) -> Candidate {
    let plain = Candidate::new(graph, outputs);
    let divided = |candidate, products| {
        if wanted.one_division { after(&OneReciprocal { products }, candidate) } else { candidate }
    };
    let doubles = divided(after(&fused(wanted.few_roundings), plain.clone()), Products::Compensated);
    if !double_double::is_worth_it(&doubles, wanted.few_roundings) {
        return doubles;
    }
    DoubleDouble.apply(&divided(plain, Products::Steps)).unwrap_or(doubles)
}

/// The candidate that a pass makes, or the same one where it does not apply.
fn after(pass: &impl Pass, candidate: Candidate) -> Candidate {
    pass.apply(&candidate).unwrap_or(candidate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Sign;
    use crate::program::{Op, reached};
    use closedform_syntax::{Function, Precision};

    /// A graph with so many positive inputs.
    fn inputs<const N: usize>() -> (Graph, [Node; N]) {
        let mut graph = Graph::default();
        let inputs = std::array::from_fn(|index| graph.input(index, Sign::POSITIVE));
        (graph, inputs)
    }

    fn product(graph: &mut Graph, factors: &[Node]) -> Node {
        factors[1..].iter().fold(factors[0], |product, &factor| graph.mul(product, factor))
    }

    const NOTHING: Wanted = Wanted { few_roundings: false, one_division: false };

    #[test]
    fn rules_are_listed_once_and_in_order() {
        assert!(ALL.windows(2).all(|pair| pair[0].name < pair[1].name));
        let named = rules_named(["fused", "by hand", "conjugate"]);
        assert_eq!(named, [&conjugate::RULE, &fused::RULE]);
    }

    #[test]
    fn what_a_rule_says_fits_a_line_of_a_generated_file() {
        for rule in ALL {
            let lines = [format!("// - {}: {}", rule.name, rule.statement), format!("//   when: {}", rule.condition)];
            assert!(lines.iter().all(|line| line.len() < 140 && !line.contains('\n')), "{lines:?}");
        }
    }

    #[test]
    fn a_program_of_few_roundings_stays_as_it_is() {
        let (mut graph, factors) = inputs::<5>();
        let product = product(&mut graph, &factors);
        let made = finished(graph, vec![product], NOTHING);
        assert_eq!((&made.outputs, made.precision), (&vec![product], Precision::Double));
        assert!(made.rules(&[]).is_empty());
    }

    #[test]
    fn a_polynomial_of_many_roundings_is_fused_into_one() {
        let (mut graph, factors) = inputs::<6>();
        let product = product(&mut graph, &factors);
        let made = finished(graph, vec![product], NOTHING);
        assert!(matches!(made.graph.op(made.outputs[0]), Op::Compensated(_)) && made.graph.is_fused(made.outputs[0]));
        assert!(made.worst_error() < 1.1);
        assert_eq!(Vec::from_iter(made.rules(&[])), ["fused"]);
    }

    #[test]
    fn few_roundings_are_made_where_they_are_asked_for() {
        let (mut graph, factors) = inputs::<3>();
        let product = product(&mut graph, &factors);
        let made = finished(graph, vec![product], Wanted { few_roundings: true, ..NOTHING });
        assert!(made.worst_error() < 1.1);
    }

    #[test]
    fn a_candidate_does_not_change_the_one_that_it_is_made_of() {
        let (mut graph, factors) = inputs::<6>();
        let product = product(&mut graph, &factors);
        let plain = Candidate::new(graph, vec![product]);
        let made = fused(true).apply(&plain).unwrap();
        assert_ne!(made.outputs, plain.outputs);
        assert_eq!((plain.worst_error(), plain.rules(&[]).len()), (5.0, 0));
    }

    #[test]
    fn a_factor_goes_into_a_sum_where_that_saves_roundings() {
        let (mut graph, [p, q, r, s]) = inputs::<4>();
        let root = graph.call(Function::Sqrt, r);
        let term = graph.mul(q, root);
        let sum = graph.add(term, s);
        let squares = product(&mut graph, &[p, p, p, p]);
        let outer = graph.mul(squares, sum);
        let made = finished(graph, vec![outer], NOTHING);
        assert_eq!(Vec::from_iter(made.rules(&[])), ["distributed", "fused"]);
        assert!(made.worst_error() < 5.0);
    }

    #[test]
    fn a_factor_goes_into_a_difference_in_its_order() {
        let (mut graph, [p, q, r]) = inputs::<3>();
        let negative = graph.input(3, Sign::NEGATIVE);
        let root = graph.call(Function::Sqrt, r);
        let term = graph.mul(q, root);
        let difference = graph.sub(term, negative);
        let squares = product(&mut graph, &[p, p, p, p]);
        let outer = graph.mul(squares, difference);
        let made = finished(graph, vec![outer], NOTHING);
        let Op::Sub(left, right) = *made.graph.op(made.outputs[0]) else { panic!("no difference") };
        assert!(matches!(made.graph.op(left), Op::Mul(_, factor) if *factor == root));
        assert!(matches!(made.graph.op(right), Op::Compensated(_)));
    }

    /// The rules of the product of a sum and a factor whose polynomial is long, and its error.
    fn with_a_long_factor(graph: &mut Graph, [p, q]: [Node; 2], sum: Node) -> (Vec<&'static str>, f64) {
        let binomial = graph.add(p, q);
        let factor = product(graph, &[binomial; 10]);
        let outer = graph.mul(factor, sum);
        let made = finished(graph.clone(), vec![outer], NOTHING);
        (Vec::from_iter(made.rules(&[])), made.worst_error())
    }

    #[test]
    fn no_factor_goes_into_a_sum_that_cancels() {
        let (mut graph, [p, q, r, s]) = inputs::<4>();
        let sum = graph.add(r, s);
        let (rules, error) = with_a_long_factor(&mut graph, [p, q], sum);
        assert!(rules == ["distributed", "fused"] && error < 2.5, "{rules:?}, {error}");
        let difference = graph.sub(r, s);
        let (rules, error) = with_a_long_factor(&mut graph, [p, q], difference);
        assert!(rules == ["fused"] && error < 3.5, "{rules:?}, {error}");
        let open = graph.input(4, Sign::ANY);
        let (rules, _) = with_a_long_factor(&mut graph, [open, q], sum);
        assert_eq!(rules, ["fused"], "a factor of either sign");
        let root = graph.call(Function::Sqrt, r);
        let cancelling = graph.sub(root, s);
        let (rules, error) = with_a_long_factor(&mut graph, [p, q], cancelling);
        assert!(rules == ["fused"] && error == f64::INFINITY, "{rules:?}, {error}");
    }

    #[test]
    fn quotients_share_a_division_where_that_is_asked_for() {
        let (mut graph, [x, y, z]) = inputs::<3>();
        let quotients = vec![graph.div(x, z), graph.div(y, z)];
        let divisions = |made: &Candidate| {
            let steps = reached(&made.graph, made.outputs.iter().copied());
            steps.into_iter().filter(|&step| matches!(made.graph.op(step), Op::Div(..))).count()
        };
        let apart = finished(graph.clone(), quotients.clone(), NOTHING);
        let shared = finished(graph, quotients, Wanted { one_division: true, ..NOTHING });
        assert_eq!((divisions(&apart), divisions(&shared)), (2, 1));
        assert_eq!(Vec::from_iter(shared.rules(&[])), ["one-reciprocal"]);
    }

    #[test]
    fn a_quotient_keeps_its_minus_through_a_reciprocal() {
        let (mut graph, [x, y, z]) = inputs::<3>();
        let quotient = graph.div(x, z);
        let quotients = vec![graph.neg(quotient), graph.div(y, z)];
        let made = finished(graph, quotients, Wanted { one_division: true, ..NOTHING });
        assert_eq!(
            made.outputs.iter().map(|&output| made.graph.sign(output)).collect::<Vec<_>>(),
            [Sign::NEGATIVE, Sign::POSITIVE]
        );
        assert!(matches!(made.graph.op(made.outputs[0]), Op::Neg(_)));
    }

    #[test]
    fn what_cannot_be_fused_is_taken_in_double_double() {
        let (mut graph, factors) = inputs::<4>();
        let roots = factors.map(|factor| graph.call(Function::Sqrt, factor));
        let product = product(&mut graph, &roots);
        let made = finished(graph, vec![product], NOTHING);
        assert_eq!((&made.outputs, made.precision), (&vec![product], Precision::DoubleDouble));
        assert!(made.worst_error() < 1.1);
        assert_eq!(Vec::from_iter(made.rules(&[])), ["double-double"]);
    }

    #[test]
    fn an_error_without_a_bound_is_none_in_double_double_either() {
        let (mut graph, [x, y]) = inputs::<2>();
        let difference = graph.sub(x, y);
        let root = graph.call(Function::Sqrt, difference);
        let iterated = graph.positive_root(vec![root], f64::INFINITY);
        let made = finished(graph, vec![iterated], NOTHING);
        assert_eq!((made.precision, made.worst_error()), (Precision::Double, f64::INFINITY));
    }

    #[test]
    fn rules_of_a_program_are_those_of_the_steps_that_it_reaches() {
        let (mut graph, [x, y]) = inputs::<2>();
        let (sum, product) = (graph.add(x, y), graph.mul(x, y));
        graph.mark(sum, "factored");
        graph.mark(product, "conjugate");
        let root = graph.call(Function::Sqrt, sum);
        let made = Candidate::new(graph, vec![root]);
        assert_eq!(Vec::from_iter(made.rules(&[])), ["factored"]);
        assert_eq!(Vec::from_iter(made.rules(&[product])), ["conjugate", "factored"]);
    }
}
