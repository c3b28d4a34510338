//! Expressions as short text, for messages.

use closedform_syntax::{BinaryOp, Expr};

/// How much of an expression a message shows.
const LENGTH: usize = 100;

/// An expression as written but for line breaks; its end is left out where it is long.
pub fn text(expr: &Expr) -> String {
    let whole = written(expr, 0);
    match whole.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{} ..", &whole[..end]),
        None => whole,
    }
}

/// Whether an expression is short enough to be shown whole.
pub fn is_whole(expr: &Expr) -> bool {
    written(expr, 0).chars().nth(LENGTH).is_none()
}

fn list(items: &[Expr]) -> String {
    items.iter().map(|item| written(item, 0)).collect::<Vec<_>>().join(", ")
}

fn written(expr: &Expr, outer: u8) -> String {
    match expr {
        Expr::Literal { value, .. } => format!("{value:?}"),
        Expr::Name(name) => name.ident.to_string(),
        Expr::Pi(_) => "PI".to_owned(),
        Expr::Call(function, inner) => format!("{}({})", function.name(), written(inner, 0)),
        Expr::Compensated(expression) => format!("compensated!({})", written(&expression.value, 0)),
        Expr::Residual(inner) => format!("residual!({})", written(inner, 0)),
        Expr::If { then, otherwise, .. } => {
            format!("if .. {{ {} }} else {{ {} }}", written(then, 0), written(otherwise, 0))
        }
        Expr::Extreme { largest, items } => {
            format!("{}({})", if *largest { "max" } else { "min" }, list(items))
        }
        Expr::PositiveRoot(coefficients) => format!("positive_root([{}])", list(coefficients)),
        Expr::Neg(inner) => format!("-{}", written(inner, 3)),
        Expr::Binary { op, left, right } => {
            let (strength, sign) = match op {
                BinaryOp::Add => (1, '+'),
                BinaryOp::Sub => (1, '-'),
                BinaryOp::Mul => (2, '*'),
                BinaryOp::Div => (2, '/'),
            };
            let inner = format!("{} {sign} {}", written(left, strength), written(right, strength + 1));
            if strength < outer { format!("({inner})") } else { inner }
        }
    }
}
