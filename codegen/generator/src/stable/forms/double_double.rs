//! Polynomials in double-double, whose sums may cancel: what rules put into compensated expressions.

use crate::algebra::Polynomial;
use crate::field::TowerError;
use crate::program::{CompensatedExpr, Graph, beyond_literals, is_exact, leading_bits};
use crate::stable::builder::Builder;
use crate::stable::nest::{Mode, Nested, Nester};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The double-double form of a polynomial in the inputs, up to a positive constant that is returned beside it.
///
/// # Errors
/// When the tower has no room left.
pub fn polynomial(
    builder: &mut Builder,
    polynomial: &Polynomial,
) -> Result<(BigRational, CompensatedExpr), TowerError> {
    let content = polynomial.primitive().0.abs();
    let scaled = polynomial.scaled(&content.recip());
    let nested = Nester::new(&builder.tower.facts, builder.tower.inputs(), Mode::DoubleDouble).nest(&scaled);
    let nested = nested.unwrap_or(Nested::Constant(BigRational::zero()));
    Ok((content, operations(builder, &nested)?))
}

fn operations(builder: &mut Builder, nested: &Nested) -> Result<CompensatedExpr, TowerError> {
    Ok(match nested {
        Nested::Constant(value) => constant(&mut builder.graph, value),
        Nested::Var(var) => match builder.difference_of(*var) {
            Some((a, b)) => {
                let (a, b) = (builder.variable(a)?, builder.variable(b)?);
                CompensatedExpr::Sub(Box::new(CompensatedExpr::Leaf(a)), Box::new(CompensatedExpr::Leaf(b)))
            }
            None => CompensatedExpr::Leaf(builder.variable(*var)?),
        },
        Nested::Sum(a, b, _) => sum(builder, a, b)?,
        Nested::Product(a, b) => {
            CompensatedExpr::Mul(Box::new(operations(builder, a)?), Box::new(operations(builder, b)?))
        }
    })
}

/// `a + b`, as a difference where one of them begins with a minus.
fn sum(builder: &mut Builder, a: &Nested, b: &Nested) -> Result<CompensatedExpr, TowerError> {
    let (plus, minus) = match (opposite(a), opposite(b)) {
        (_, Some(minus)) => (a, minus),
        (Some(minus), None) => (b, minus),
        (None, None) => {
            let (a, b) = (operations(builder, a)?, operations(builder, b)?);
            return Ok(CompensatedExpr::Add(Box::new(a), Box::new(b)));
        }
    };
    let (plus, minus) = (operations(builder, plus)?, operations(builder, &minus)?);
    Ok(CompensatedExpr::Sub(Box::new(plus), Box::new(minus)))
}

/// The negative of a form that begins with a negative constant.
fn opposite(nested: &Nested) -> Option<Nested> {
    match nested {
        Nested::Constant(value) if value.is_negative() => Some(Nested::Constant(-value)),
        Nested::Product(a, b) => match opposite(a)? {
            Nested::Constant(one) if one.is_one() => Some((**b).clone()),
            a => Some(Nested::Product(Box::new(a), b.clone())),
        },
        _ => None,
    }
}

/// An integer of any size as an unevaluated sum of numbers that `f64` holds.
pub fn constant(graph: &mut Graph, value: &BigRational) -> CompensatedExpr {
    if is_exact(value) {
        return CompensatedExpr::Leaf(graph.constant(value));
    }
    let (high, rest) = match leading_bits(value) {
        Some(leading) => (CompensatedExpr::Leaf(graph.constant(&leading)), value - leading),
        None => {
            let (step, high, rest) = beyond_literals(value);
            let step = CompensatedExpr::Leaf(graph.constant(&step));
            (CompensatedExpr::Mul(Box::new(step), Box::new(constant(graph, &high))), rest)
        }
    };
    if rest.is_zero() { high } else { CompensatedExpr::Add(Box::new(high), Box::new(constant(graph, &rest))) }
}
