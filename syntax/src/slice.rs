//! `compensated!`: which double-double operation each step of a slice takes.
//!
//! Interpreter and macro both fold slices by this one function, so they cannot disagree.

use crate::kernel::{BinaryOp, Expr};

/// The operations that a `compensated!` slice is made of, on numbers or on what stands for them.
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
    /// `a`, rounded once.
    fn round(&self, a: &Self::Wide) -> Self::Value;
}

/// The value of a `compensated!` slice, `leaf` being that of its literals and names.
pub fn fold_slice<A: SliceArithmetic>(arithmetic: &A, slice: &Expr, leaf: &dyn Fn(&Expr) -> A::Value) -> A::Value {
    match fold(arithmetic, slice, leaf) {
        Folded::Exact(value) => value,
        Folded::Wide(wide) => arithmetic.round(&wide),
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
