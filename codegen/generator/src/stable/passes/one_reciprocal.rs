//! Rule `one-reciprocal`: quotients whose denominators have factors in common share one division.

use super::Pass;
use super::products::{fits, in_order, in_steps};
use crate::field::Sign;
use crate::program::{CompensatedExpr, Graph, Node, Op};
use crate::stable::candidate::Candidate;
use crate::stable::rule::Rule;
use num_rational::BigRational;
use num_traits::One;

/// The rule. The powers of a common denominator are halved because the least common multiple itself soon overflows: of
/// times of 2^86 s, where the coefficients of a quartic are far from it.
pub const RULE: Rule = Rule {
    name: "one-reciprocal",
    statement: "a/p, b/q = (a*(d/p))*r, (b*(d*f/q))*r*s with r = 1/d, d of half the powers in p and q, s = 1/f = (d/f)*r",
    condition: "the contract asks for one division; a, b, p, q are polynomials of the inputs, and f is what q has more of",
};

/// A quotient of polynomials: the numerator, and the factors of the denominator with their powers.
struct Quotient {
    numerator: CompensatedExpr,
    denominator: Factors,
    sign: Sign,
}

/// Factors in the order in which they are met, and their powers.
#[derive(Clone, Default)]
struct Factors(Vec<(CompensatedExpr, usize)>);

/// How a product is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Products {
    /// As a compensated expression, which takes one rounding.
    Compensated,
    /// In steps, for a program in double-double, whose roundings do not count.
    Steps,
}

impl Products {
    fn make(self, graph: &mut Graph, product: CompensatedExpr) -> Node {
        match self {
            Self::Compensated => in_order(graph, product, Sign::ANY).1,
            Self::Steps => in_steps(graph, product),
        }
    }
}

/// Takes results that are quotients through one reciprocal.
pub struct OneReciprocal {
    /// How products are evaluated.
    pub products: Products,
}

impl Pass for OneReciprocal {
    fn apply(&self, candidate: &Candidate) -> Option<Candidate> {
        let mut made = candidate.clone();
        made.outputs = through_one_reciprocal(&mut made.graph, &candidate.outputs, self.products)?;
        Some(made)
    }
}

fn through_one_reciprocal(graph: &mut Graph, results: &[Node], products: Products) -> Option<Vec<Node>> {
    let quotients: Vec<Option<Quotient>> = results.iter().map(|&result| quotient(graph, result)).collect();
    let mut shared = Factors::default();
    quotients.iter().flatten().for_each(|quotient| shared.take_largest(&quotient.denominator));
    shared.0.iter_mut().for_each(|(_, power)| *power = power.div_ceil(2));
    let whole = shared.product().filter(fits)?;
    if quotients.iter().flatten().count() < 2 {
        return None;
    }
    let one = graph.constant(&BigRational::one());
    let whole = products.make(graph, whole);
    let reciprocal = graph.div(one, whole);
    graph.mark(reciprocal, RULE.name);
    let through = |(&result, quotient): (&Node, &Option<Quotient>)| {
        let value = quotient.as_ref().and_then(|quotient| quotient.through(graph, &shared, reciprocal, products));
        value.inspect(|&value| graph.replace(result, value)).unwrap_or(result)
    };
    Some(results.iter().zip(&quotients).map(through).collect())
}

impl Quotient {
    /// The quotient as products with the reciprocal of what is shared; `None` where a numerator grows too long.
    fn through(&self, graph: &mut Graph, shared: &Factors, reciprocal: Node, products: Products) -> Option<Node> {
        let mut rest = Factors::default();
        let mut inverses = Vec::new();
        for (factor, power) in &shared.0 {
            let needed = self.denominator.power(factor);
            if needed > *power {
                inverses.push(shared.without(factor).product());
            }
            rest.0.push((factor.clone(), if needed > *power { 2 * power } else { *power } - needed));
        }
        let scaled =
            rest.product().into_iter().fold(self.numerator.clone(), |a, b| CompensatedExpr::Mul(a.into(), b.into()));
        if !std::iter::once(&scaled).chain(inverses.iter().flatten()).all(fits) {
            return None;
        }
        let scaled = products.make(graph, scaled);
        let mut value = graph.mul(scaled, reciprocal);
        for others in inverses {
            let inverse = match others {
                Some(others) => {
                    let others = products.make(graph, others);
                    graph.mul(others, reciprocal)
                }
                None => reciprocal,
            };
            value = graph.mul(value, inverse);
        }
        graph.learn(value, self.sign);
        Some(value)
    }
}

fn quotient(graph: &Graph, node: Node) -> Option<Quotient> {
    match *graph.op(node) {
        Op::Div(numerator, denominator) => {
            let mut factors = Factors::default();
            factors.insert(graph.polynomial(denominator)?);
            Some(Quotient { numerator: graph.polynomial(numerator)?, denominator: factors, sign: graph.sign(node) })
        }
        Op::Neg(inner) => {
            let quotient = quotient(graph, inner)?;
            Some(Quotient {
                numerator: CompensatedExpr::Neg(quotient.numerator.into()),
                sign: graph.sign(node),
                ..quotient
            })
        }
        _ => None,
    }
}

impl Factors {
    fn insert(&mut self, expression: CompensatedExpr) {
        match expression {
            CompensatedExpr::Mul(a, b) => [a, b].into_iter().for_each(|factor| self.insert(*factor)),
            factor => match self.0.iter_mut().find(|(known, _)| *known == factor) {
                Some((_, power)) => *power += 1,
                None => self.0.push((factor, 1)),
            },
        }
    }

    fn power(&self, factor: &CompensatedExpr) -> usize {
        self.0.iter().find(|(known, _)| known == factor).map_or(0, |(_, power)| *power)
    }

    fn take_largest(&mut self, other: &Self) {
        for (factor, power) in &other.0 {
            match self.0.iter_mut().find(|(known, _)| known == factor) {
                Some((_, largest)) => *largest = (*largest).max(*power),
                None => self.0.push((factor.clone(), *power)),
            }
        }
    }

    fn without(&self, other: &CompensatedExpr) -> Self {
        Self(self.0.iter().filter(|(factor, _)| factor != other).cloned().collect())
    }

    /// `None` of no factors.
    fn product(&self) -> Option<CompensatedExpr> {
        let factors = self.0.iter().flat_map(|(factor, power)| std::iter::repeat_n(factor.clone(), *power));
        factors.reduce(|a, b| CompensatedExpr::Mul(a.into(), b.into()))
    }
}
