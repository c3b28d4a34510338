//! Conditions and expressions as text, for errors at run time and reports.

use crate::kernel::{BinaryOp, Condition, Expr};

/// The expression as Rust text, with as few parentheses as its meaning needs.
pub fn expression_text(expr: &Expr) -> String {
    text(expr, 0)
}

/// The condition as Rust text, with as few parentheses as its meaning needs.
pub fn condition_text(condition: &Condition) -> String {
    match condition {
        Condition::Compare { op, left, right } => format!("{} {} {}", text(left, 0), op.rust(), text(right, 0)),
        Condition::And(left, right) => format!("{} && {}", operand_text(left), operand_text(right)),
        Condition::Or(left, right) => format!("{} || {}", condition_text(left), condition_text(right)),
        Condition::Not(inner) => format!("!({})", condition_text(inner)),
    }
}

/// An operand of `&&`.
fn operand_text(condition: &Condition) -> String {
    match condition {
        Condition::Or(..) => format!("({})", condition_text(condition)),
        _ => condition_text(condition),
    }
}

/// Sums bind weakest, then products, then unary minus.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const UNARY: u8 = 3;

/// The expression as Rust text, in parentheses where it binds weaker than `outer`.
fn text(expr: &Expr, outer: u8) -> String {
    let (strength, text) = match expr {
        Expr::Literal { value, .. } => return format!("{value:?}"),
        Expr::Name(name) => return name.ident.to_string(),
        Expr::Pi(_) => return "PI".to_owned(),
        Expr::Call(function, inner) => return format!("{}({})", function.name(), text(inner, 0)),
        Expr::Compensated(expression) => return format!("compensated!({})", text(&expression.value, 0)),
        Expr::Residual(inner) => return format!("residual!({})", text(inner, 0)),
        Expr::Extreme { largest, items } => {
            return format!("{}({})", if *largest { "max" } else { "min" }, list_text(items));
        }
        Expr::PositiveRoot(coefficients) => return format!("positive_root([{}])", list_text(coefficients)),
        Expr::If { condition, then, otherwise } => {
            let (then, otherwise) = (text(then, 0), text(otherwise, 0));
            (0, format!("if {} {{ {then} }} else {{ {otherwise} }}", condition_text(condition)))
        }
        Expr::Neg(inner) => (UNARY, format!("-{}", text(inner, UNARY))),
        Expr::Binary { op, left, right } => {
            let (strength, sign) = operator(*op);
            (strength, format!("{} {sign} {}", text(left, strength), text(right, strength + 1)))
        }
    };
    if strength < outer { format!("({text})") } else { text }
}

fn list_text(items: &[Expr]) -> String {
    items.iter().map(|item| text(item, 0)).collect::<Vec<_>>().join(", ")
}

fn operator(op: BinaryOp) -> (u8, char) {
    match op {
        BinaryOp::Add => (SUM, '+'),
        BinaryOp::Sub => (SUM, '-'),
        BinaryOp::Mul => (PRODUCT, '*'),
        BinaryOp::Div => (PRODUCT, '/'),
    }
}
