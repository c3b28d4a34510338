//! Rule `one-reciprocal`: quotients whose denominators have factors in common share one division.

use super::{Rule, gathered};
use crate::field::Sign;
use crate::program::{Graph, Node, Op, Wide};
use crate::stable::builder::Builder;
use num_rational::BigRational;
use num_traits::One;

/// The rule.
pub const RULE: Rule = Rule {
    name: "one-reciprocal",
    statement: "a/p, b/q, .. = (a*(d/p))*r, (b*(d/q))*r, .. where d is the least common multiple of p, q, .. and r = 1/d",
    condition: "the contract asks for one division, and a, b, .. p, q, .. are polynomials of the inputs",
};

/// A quotient of polynomials: the numerator, and the factors of the denominator with their powers.
struct Quotient {
    numerator: Wide,
    denominator: Factors,
    sign: Sign,
}

/// Factors in the order in which they are met, and their powers.
#[derive(Clone, Default)]
struct Factors(Vec<(Wide, usize)>);

/// The results, those that are quotients through one reciprocal.
pub fn apply(builder: &mut Builder, results: &[Node]) -> Vec<Node> {
    let quotients: Vec<Option<Quotient>> = results.iter().map(|&result| quotient(&builder.graph, result)).collect();
    let mut common = Factors::default();
    quotients.iter().flatten().for_each(|quotient| common.take_largest(&quotient.denominator));
    let Some(whole) = common.product() else { return results.to_vec() };
    if quotients.iter().flatten().count() < 2 || !gathered::fits(&whole) {
        return results.to_vec();
    }
    let one = builder.graph.constant(&BigRational::one());
    let whole = builder.graph.compensated(whole, Sign::ANY);
    let reciprocal = builder.graph.div(one, whole);
    builder.apply(&RULE, reciprocal);
    let through = |(&result, quotient): (&Node, &Option<Quotient>)| {
        let Some(quotient) = quotient else { return result };
        let rest = common.without(&quotient.denominator).product();
        let scaled = rest.into_iter().fold(quotient.numerator.clone(), |a, b| Wide::Mul(a.into(), b.into()));
        if !gathered::fits(&scaled) {
            return result;
        }
        let scaled = builder.graph.compensated(scaled, Sign::ANY);
        let value = builder.graph.mul(scaled, reciprocal);
        builder.graph.learn(value, quotient.sign);
        value
    };
    results.iter().zip(&quotients).map(through).collect()
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
            Some(Quotient { numerator: Wide::Neg(quotient.numerator.into()), sign: graph.sign(node), ..quotient })
        }
        _ => None,
    }
}

impl Factors {
    fn insert(&mut self, wide: Wide) {
        match wide {
            Wide::Mul(a, b) => [a, b].into_iter().for_each(|factor| self.insert(*factor)),
            factor => match self.0.iter_mut().find(|(known, _)| *known == factor) {
                Some((_, power)) => *power += 1,
                None => self.0.push((factor, 1)),
            },
        }
    }

    fn power(&self, factor: &Wide) -> usize {
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

    fn without(&self, other: &Self) -> Self {
        Self(self.0.iter().map(|(factor, power)| (factor.clone(), power - other.power(factor))).collect())
    }

    /// `None` of no factors.
    fn product(&self) -> Option<Wide> {
        let factors = self.0.iter().flat_map(|(factor, power)| std::iter::repeat_n(factor.clone(), *power));
        factors.reduce(|a, b| Wide::Mul(a.into(), b.into()))
    }
}
