//! Slices, what `compensated!` and `residual!` take: which double-double operation each step is, and its exact terms.
//!
//! Interpreter and macro both fold slices by these functions, so they cannot disagree.

use crate::error;
use crate::kernel::{BinaryOp, Expr, Slice};

/// The operations that slices are made of, on numbers or on what stands for them.
pub trait SliceArithmetic {
    /// A number; as an operand it counts as exact.
    type Value;
    /// A number in double-double.
    type Wide;

    /// `-a`
    fn neg(&self, a: &Self::Value) -> Self::Value;
    /// `a + b`, error-free.
    fn two_sum(&self, a: &Self::Value, b: &Self::Value) -> Self::Wide;
    /// `a * b`, error-free.
    fn two_product(&self, a: &Self::Value, b: &Self::Value) -> Self::Wide;
    /// `-a`
    fn wide_neg(&self, a: &Self::Wide) -> Self::Wide;
    /// `a + b`
    fn wide_add_exact(&self, a: &Self::Wide, b: &Self::Value) -> Self::Wide;
    /// `a + b`
    fn wide_add(&self, a: &Self::Wide, b: &Self::Wide) -> Self::Wide;
    /// `a * b`
    fn wide_mul_exact(&self, a: &Self::Wide, b: &Self::Value) -> Self::Wide;
    /// `a * b`
    fn wide_mul(&self, a: &Self::Wide, b: &Self::Wide) -> Self::Wide;
    /// `a`, rounded once; where it is not larger than the slice's threshold, the slice of these operands, exactly.
    fn compensated(&self, a: &Self::Wide, slice: &Slice, operands: &[Self::Value]) -> Self::Value;
    /// `a`, rounded once.
    fn residual(&self, a: &Self::Wide) -> Self::Value;
}

/// The value of a `compensated!` slice, `leaf` being that of its literals and names.
pub fn fold_compensated<A: SliceArithmetic>(
    arithmetic: &A,
    slice: &Slice,
    leaf: &dyn Fn(&Expr) -> A::Value,
) -> A::Value {
    match fold(arithmetic, &slice.value, leaf) {
        Folded::Exact(value) => value,
        Folded::Wide(wide) => {
            let operands: Vec<A::Value> = slice.operands.iter().map(leaf).collect();
            arithmetic.compensated(&wide, slice, &operands)
        }
    }
}

/// The value of a `residual!` slice.
pub fn fold_residual<A: SliceArithmetic>(arithmetic: &A, slice: &Expr, leaf: &dyn Fn(&Expr) -> A::Value) -> A::Value {
    match fold(arithmetic, slice, leaf) {
        Folded::Exact(value) => value,
        Folded::Wide(wide) => arithmetic.residual(&wide),
    }
}

/// A part of a slice.
enum Folded<A: SliceArithmetic> {
    /// A literal, a name, or one of them negated.
    Exact(A::Value),
    /// Anything else.
    Wide(A::Wide),
}

fn fold<A: SliceArithmetic>(arithmetic: &A, slice: &Expr, leaf: &dyn Fn(&Expr) -> A::Value) -> Folded<A> {
    let part = |inner: &Expr| fold(arithmetic, inner, leaf);
    match slice {
        Expr::Neg(inner) => negated(arithmetic, part(inner)),
        Expr::Binary { op: BinaryOp::Mul, left, right } => Folded::Wide(product(arithmetic, part(left), part(right))),
        Expr::Binary { op: BinaryOp::Sub, left, right } => {
            Folded::Wide(sum(arithmetic, part(left), negated(arithmetic, part(right))))
        }
        Expr::Binary { left, right, .. } => Folded::Wide(sum(arithmetic, part(left), part(right))),
        exact => Folded::Exact(leaf(exact)),
    }
}

fn negated<A: SliceArithmetic>(arithmetic: &A, part: Folded<A>) -> Folded<A> {
    match part {
        Folded::Exact(value) => Folded::Exact(arithmetic.neg(&value)),
        Folded::Wide(wide) => Folded::Wide(arithmetic.wide_neg(&wide)),
    }
}

fn sum<A: SliceArithmetic>(arithmetic: &A, left: Folded<A>, right: Folded<A>) -> A::Wide {
    match (left, right) {
        (Folded::Exact(a), Folded::Exact(b)) => arithmetic.two_sum(&a, &b),
        (Folded::Wide(wide), Folded::Exact(exact)) | (Folded::Exact(exact), Folded::Wide(wide)) => {
            arithmetic.wide_add_exact(&wide, &exact)
        }
        (Folded::Wide(a), Folded::Wide(b)) => arithmetic.wide_add(&a, &b),
    }
}

fn product<A: SliceArithmetic>(arithmetic: &A, left: Folded<A>, right: Folded<A>) -> A::Wide {
    match (left, right) {
        (Folded::Exact(a), Folded::Exact(b)) => arithmetic.two_product(&a, &b),
        (Folded::Wide(wide), Folded::Exact(exact)) | (Folded::Exact(exact), Folded::Wide(wide)) => {
            arithmetic.wide_mul_exact(&wide, &exact)
        }
        (Folded::Wide(a), Folded::Wide(b)) => arithmetic.wide_mul(&a, &b),
    }
}

/// The most factors of a term of a `compensated!` slice.
pub const MAX_FACTORS: usize = 16;

/// The most terms.
const MAX_TERMS: usize = 1 << 14;

/// The most operands.
const MAX_OPERANDS: usize = 255;

/// How much larger than its error before rounding a slice has to be, in units of 2^-53: with one percent for the
/// roundings of sizes, a settled slice is right to 2^-53/1000 before it is rounded.
const MARGIN: f64 = 1010.0;

impl Slice {
    /// A slice, and what its exact evaluation needs; its product of sums is expanded.
    ///
    /// # Errors
    ///
    /// When it has too many terms, factors or operands.
    pub fn new(value: Expr) -> Result<Self, &'static str> {
        let mut operands = Vec::new();
        let sum = expand(&value, &mut operands)?;
        let mut terms = Vec::new();
        for Product { negative, factors } in sum {
            terms.push(factors.len() as u8 | if negative { 0x80 } else { 0 });
            terms.extend(factors);
        }
        let threshold = error(&value).units.max(1.0) * MARGIN / (1_u64 << 53) as f64;
        Ok(Slice { value: value.into(), operands, terms, threshold })
    }
}

/// A product of operands, by position.
#[derive(Clone)]
struct Product {
    negative: bool,
    factors: Vec<u8>,
}

fn expand(expr: &Expr, operands: &mut Vec<Expr>) -> Result<Vec<Product>, &'static str> {
    match expr {
        Expr::Neg(inner) => Ok(turned(expand(inner, operands)?)),
        Expr::Binary { op, left, right } => {
            let (left, right) = (expand(left, operands)?, expand(right, operands)?);
            match op {
                BinaryOp::Mul => multiplied(&left, &right),
                BinaryOp::Sub => Ok([left, turned(right)].concat()),
                BinaryOp::Add | BinaryOp::Div => Ok([left, right].concat()),
            }
        }
        leaf => {
            let known = operands.iter().position(|operand| same_leaf(operand, leaf));
            let position = known.unwrap_or(operands.len());
            if known.is_none() {
                operands.push(leaf.clone());
            }
            let position = u8::try_from(position).ok().filter(|position| usize::from(*position) < MAX_OPERANDS);
            Ok(vec![Product { negative: false, factors: vec![position.ok_or(error::COMPENSATED_SIZE)?] }])
        }
    }
}

fn turned(mut sum: Vec<Product>) -> Vec<Product> {
    sum.iter_mut().for_each(|product| product.negative = !product.negative);
    sum
}

fn multiplied(left: &[Product], right: &[Product]) -> Result<Vec<Product>, &'static str> {
    let pairs = left.iter().flat_map(|a| right.iter().map(move |b| (a, b)));
    let products: Vec<Product> = pairs
        .take(MAX_TERMS + 1)
        .map(|(a, b)| Product { negative: a.negative != b.negative, factors: [&a.factors[..], &b.factors].concat() })
        .collect();
    let fits = products.len() <= MAX_TERMS && products.iter().all(|product| product.factors.len() <= MAX_FACTORS);
    if fits { Ok(products) } else { Err(error::COMPENSATED_SIZE) }
}

fn same_leaf(a: &Expr, b: &Expr) -> bool {
    match (a, b) {
        (Expr::Name(a), Expr::Name(b)) => a.slot == b.slot,
        (Expr::Literal { value: a, .. }, Expr::Literal { value: b, .. }) => a.to_bits() == b.to_bits(),
        _ => false,
    }
}

/// What is known of the error of a part of a slice.
struct PartError {
    /// Whether it is an operand.
    exact: bool,
    /// The n of: its error is at most n 2^-106 times the sum of the magnitudes of its terms.
    units: f64,
}

/// Counts the theorems that `closedform`'s `Wide` and `Measured` state; each is rounded up to a whole number, which
/// covers terms of higher order and, in products, what underflows.
fn error(expr: &Expr) -> PartError {
    let wide = |units| PartError { exact: false, units };
    match expr {
        Expr::Neg(inner) => error(inner),
        Expr::Binary { op, left, right } => {
            let (left, right) = (error(left), error(right));
            let (larger, both) = (left.units.max(right.units), left.units + right.units);
            match (op, left.exact, right.exact) {
                (BinaryOp::Mul, true, true) => wide(1.0),
                (BinaryOp::Mul, false, false) => wide(both + 9.0),
                (BinaryOp::Mul, _, _) => wide(both + 3.0),
                (_, true, true) => wide(0.0),
                (_, false, false) => wide(larger + 4.0),
                (_, _, _) => wide(larger + 3.0),
            }
        }
        Expr::Literal { .. } | Expr::Name(_) => PartError { exact: true, units: 0.0 },
        // no part of a slice: of anything else nothing is known
        _ => wide(f64::INFINITY),
    }
}
