//! Polynomials in plain arithmetic, where no sum can cancel.

use crate::algebra::Polynomial;
use crate::field::TowerError;
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::nest::{Mode, Nested, Nester};

/// The steps of a polynomial in plain arithmetic, if no sum of theirs can cancel.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, polynomial: &Polynomial) -> Result<Option<Node>, TowerError> {
    nested(builder, polynomial).map(|nested| steps_of(builder, &nested)).transpose()
}

/// Whether a polynomial can be evaluated in plain arithmetic without cancellation.
#[must_use]
pub fn applies(builder: &Builder, polynomial: &Polynomial) -> bool {
    nested(builder, polynomial).is_some()
}

fn nested(builder: &Builder, polynomial: &Polynomial) -> Option<Nested> {
    Nester::new(&builder.tower.facts, builder.tower.inputs(), Mode::Plain).nest(polynomial)
}

fn steps_of(builder: &mut Builder, nested: &Nested) -> Result<Node, TowerError> {
    Ok(match nested {
        Nested::Constant(value) => builder.graph.constant(value),
        Nested::Var(var) => builder.variable(*var)?,
        Nested::Sum(a, b, signs) => {
            let (a, b) = (steps_of(builder, a)?, steps_of(builder, b)?);
            builder.graph.learn(a, signs[0]);
            builder.graph.learn(b, signs[1]);
            let sum = builder.graph.add(a, b);
            builder.graph.learn(sum, signs[2]);
            sum
        }
        Nested::Product(a, b) => {
            let (a, b) = (steps_of(builder, a)?, steps_of(builder, b)?);
            builder.graph.mul(a, b)
        }
    })
}
