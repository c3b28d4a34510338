//! Polynomials in double-double, grouped as their author wrote them.

use crate::field::TowerError;
use crate::program::CompensatedExpr;
use crate::stable::builder::Builder;
use crate::stable::forms::double_double;
use closedform_project::expression::Expr;
use num_bigint::BigInt;
use num_rational::BigRational;

/// The double-double form of an expression; `None` where it is no polynomial with integer coefficients.
///
/// # Errors
/// When a name is no input.
pub fn compensated_as_written(builder: &mut Builder, expr: &Expr) -> Result<Option<CompensatedExpr>, TowerError> {
    Ok(match expr {
        Expr::Rational(value) if value.is_integer() => Some(double_double::constant(&mut builder.graph, value)),
        Expr::Symbol(name) => {
            let var = builder.tower.variable(name)?;
            Some(CompensatedExpr::Leaf(builder.variable(var)?))
        }
        Expr::Sum(items) => {
            let terms: Vec<Expr> = items.iter().filter(|item| !item.is_zero()).cloned().collect();
            joined(parts(builder, &terms)?, sum)
        }
        Expr::Product(items) => match items.split_first() {
            Some((first, rest)) if is_minus_one(first) => {
                joined(parts(builder, rest)?, product).map(|positive| CompensatedExpr::Neg(Box::new(positive)))
            }
            _ => joined(parts(builder, items)?, product),
        },
        Expr::Power(base, exponent) if *exponent > 0 => {
            let base = compensated_as_written(builder, base)?;
            joined(vec![base; *exponent as usize], product)
        }
        _ => None,
    })
}

fn parts(builder: &mut Builder, items: &[Expr]) -> Result<Vec<Option<CompensatedExpr>>, TowerError> {
    items.iter().map(|item| compensated_as_written(builder, item)).collect()
}

/// All parts joined, if there is none missing.
fn joined(
    parts: Vec<Option<CompensatedExpr>>,
    join: fn(CompensatedExpr, CompensatedExpr) -> CompensatedExpr,
) -> Option<CompensatedExpr> {
    parts.into_iter().collect::<Option<Vec<_>>>()?.into_iter().reduce(join)
}

fn sum(a: CompensatedExpr, b: CompensatedExpr) -> CompensatedExpr {
    match b {
        CompensatedExpr::Neg(b) => CompensatedExpr::Sub(Box::new(a), b),
        b => CompensatedExpr::Add(Box::new(a), Box::new(b)),
    }
}

fn product(a: CompensatedExpr, b: CompensatedExpr) -> CompensatedExpr {
    CompensatedExpr::Mul(Box::new(a), Box::new(b))
}

fn is_minus_one(expr: &Expr) -> bool {
    matches!(expr, Expr::Rational(value) if *value == BigRational::from_integer(BigInt::from(-1)))
}
