//! The formula as written, as an expression of Rust.

use crate::ast::Expr;
use crate::double::{Arithmetic, fold};

/// The formula as a person would type it into Rust, in the order of the text; `names` become `identifiers`. `None` where
/// [`evaluate_double`](crate::evaluate_double) has no value.
#[must_use]
pub fn double_rust(formula: &Expr, names: &[impl AsRef<str>], identifiers: &[impl AsRef<str>]) -> Option<String> {
    let name = |name: &str| {
        let at = names.iter().position(|known| known.as_ref() == name)?;
        identifiers.get(at).map(|identifier| identifier.as_ref().to_owned())
    };
    fold(formula, &Text(&name))
}

/// Expressions of Rust, each of which may stand as an operand.
struct Text<'a>(&'a dyn Fn(&str) -> Option<String>);

impl Arithmetic for Text<'_> {
    type Value = String;

    fn number(&self, value: f64) -> String {
        format!("{value:?}_f64")
    }

    fn name(&self, name: &str) -> Option<String> {
        (self.0)(name)
    }

    fn neg(&self, a: String) -> String {
        format!("(-{a})")
    }

    fn abs(&self, a: String) -> String {
        format!("{a}.abs()")
    }

    fn sqrt(&self, a: String) -> String {
        format!("{a}.sqrt()")
    }

    fn cbrt(&self, a: String) -> String {
        format!("{a}.cbrt()")
    }

    fn add(&self, a: String, b: String) -> String {
        format!("({a} + {b})")
    }

    fn sub(&self, a: String, b: String) -> String {
        format!("({a} - {b})")
    }

    fn mul(&self, a: String, b: String) -> String {
        format!("({a} * {b})")
    }

    fn div(&self, a: String, b: String) -> String {
        format!("({a} / {b})")
    }

    /// By repeated squaring, from the leading bit of `count`.
    fn power(&self, a: String, count: u32) -> String {
        if count == 1 {
            return a;
        }
        let squares = (0..count.ilog2()).rev().map(|bit| if count >> bit & 1 == 1 { "p * p * a" } else { "p * p" });
        let steps: String = squares.map(|step| format!("let p = {step}; ")).collect();
        format!("{{ let a = {a}; let p = a; {steps}p }}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse_expression;

    #[test]
    fn the_text_keeps_the_order_of_operations() {
        let rust = |text: &str| double_rust(&parse_expression(text).unwrap(), &["x", "y"], &["a_x", "y"]);
        assert_eq!(rust("x-y*2").as_deref(), Some("(a_x - (y * 2.0_f64))"));
        assert_eq!(rust("sqrt(-x)/3").as_deref(), Some("((-a_x).sqrt() / 3.0_f64)"));
        assert_eq!(rust("x^3").as_deref(), Some("{ let a = a_x; let p = a; let p = p * p * a; p }"));
        assert_eq!(rust("x^(-1/2)").as_deref(), Some("(1.0_f64 / a_x.sqrt())"));
        assert_eq!(rust("sin(x)"), None);
    }
}
