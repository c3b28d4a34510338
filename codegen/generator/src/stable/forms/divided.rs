//! Quotients as one product over another: one division at most.

use crate::field::TowerError;
use crate::program::{Node, is_exact};
use crate::stable::builder::Builder;
use crate::stable::quotient::{Factor, Quotient};
use num_rational::BigRational;
use num_traits::One;

/// The product of the factors.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, quotient: &Quotient) -> Result<Node, TowerError> {
    let (over, under) = split_constant(&quotient.constant);
    let above = product(builder, &over, quotient, 1)?;
    let below = product(builder, &under, quotient, -1)?;
    Ok(builder.graph.div(above, below))
}

fn product(builder: &mut Builder, constant: &BigRational, quotient: &Quotient, side: i32) -> Result<Node, TowerError> {
    let mut product = builder.graph.constant(constant);
    for (factor, exponent) in &quotient.powers {
        let times = exponent * side;
        if times <= 0 {
            continue;
        }
        let node = match factor {
            Factor::Node(node) => *node,
            Factor::Polynomial(polynomial) => builder.polynomial(polynomial)?,
        };
        for _ in 0..times {
            product = builder.graph.mul(product, node);
        }
    }
    Ok(product)
}

/// A constant as an exact numerator over an exact denominator: dyadic ones stay above the bar.
fn split_constant(constant: &BigRational) -> (BigRational, BigRational) {
    if is_exact(constant) {
        return (constant.clone(), BigRational::one());
    }
    let below = BigRational::from_integer(constant.denom().clone());
    (BigRational::from_integer(constant.numer().clone()), below)
}
