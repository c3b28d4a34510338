//! Comparisons of comparisons: not part of the language, and told apart for the sake of a message that helps.

use proc_macro2::{Spacing, TokenStream, TokenTree};
use syn::{BinOp, Expr, Lit};

/// Whether an expression is a comparison or a truth value, in any parentheses.
pub fn is_decided(expr: &Expr) -> bool {
    match expr {
        Expr::Paren(inner) => is_decided(&inner.expr),
        Expr::Group(inner) => is_decided(&inner.expr),
        Expr::Lit(literal) => matches!(literal.lit, Lit::Bool(_)),
        Expr::Binary(binary) => is_comparison(&binary.op),
        _ => false,
    }
}

fn is_comparison(op: &BinOp) -> bool {
    matches!(op, BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) | BinOp::Eq(_) | BinOp::Ne(_))
}

/// Whether two comparisons follow each other somewhere in these tokens, with neither `&&` nor `||` between them.
pub fn is_chain(tokens: &TokenStream) -> bool {
    let mut left = vec![tokens.clone()];
    while let Some(level) = left.pop() {
        let mut compared = 0;
        let mut joint = false;
        for token in level {
            match token {
                TokenTree::Punct(sign) => {
                    match sign.as_char() {
                        // the second sign of an operator was counted with its first one
                        _ if joint => {}
                        '<' | '>' | '=' => compared += 1,
                        '!' if sign.spacing() == Spacing::Joint => compared += 1,
                        '&' | '|' | ',' => compared = 0,
                        _ => {}
                    }
                    joint = !joint && sign.spacing() == Spacing::Joint;
                }
                TokenTree::Group(group) => {
                    left.push(group.stream());
                    joint = false;
                }
                _ => joint = false,
            }
            if compared > 1 {
                return true;
            }
        }
    }
    false
}
