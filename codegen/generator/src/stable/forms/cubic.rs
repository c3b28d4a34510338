//! Sums with a cube root whose terms have one sign: they are taken as they stand.

use super::sum;
use crate::field::{Sign, TowerError};
use crate::program::{Graph, Node};
use crate::stable::builder::Builder;
use crate::stable::surd::Surd;

/// A term of a sum with a cube root.
#[derive(Clone, Copy)]
pub struct Term {
    /// Its step.
    pub node: Node,
    /// Its sign.
    pub sign: Sign,
}

impl Term {
    /// The term with the other sign.
    #[must_use]
    pub fn negated(self, graph: &mut Graph) -> Self {
        Self { node: graph.neg(self.node), sign: -self.sign }
    }
}

/// The sum, if its terms have one sign.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let signs = surd.cubic_terms().into_iter().map(|term| builder.tower.sign_of(&term));
    let sign = signs.fold(Sign::ZERO, Sign::plus);
    if !sign.is_definite() {
        return Ok(None);
    }
    let terms = terms(builder, surd)?;
    added(builder, surd, &terms, sign).map(Some)
}

/// The terms of a sum.
///
/// # Errors
/// When the tower has no room left.
pub fn terms(builder: &mut Builder, surd: &Surd) -> Result<Vec<Term>, TowerError> {
    let terms = surd.cubic_terms().into_iter().map(|term| {
        let sign = builder.tower.sign_of(&term);
        let node = sum::upright(builder, &term)?;
        builder.graph.learn(node, sign);
        Ok(Term { node, sign })
    });
    terms.collect()
}

/// The sum times the quotient in plain arithmetic; the caller knows that all terms have the given sign.
///
/// # Errors
/// When the tower has no room left.
pub fn added(builder: &mut Builder, surd: &Surd, terms: &[Term], sign: Sign) -> Result<Node, TowerError> {
    let mut quotient = surd.quotient.clone();
    let nodes = terms.iter().rev().map(|term| term.node);
    let sum = nodes.reduce(|sum, term| builder.graph.add_of_one_sign(sum, term, sign));
    sum.into_iter().for_each(|sum| quotient.multiply_node(sum, 1));
    builder.quotient(&quotient)
}
