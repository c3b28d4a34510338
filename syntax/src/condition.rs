//! Conditions: comparisons of expressions, joined by `&&`, `||` and `!`.

use syn::{BinOp, Expr, ExprBinary, UnOp};

use crate::error;
use crate::expression::Reader;
use crate::kernel::{self, Comparison, Condition};

impl Reader<'_> {
    /// Reads a condition.
    pub fn condition(&mut self, expr: &Expr) -> Option<Condition> {
        match expr {
            Expr::Paren(inner) => self.condition(&inner.expr),
            Expr::Group(inner) => self.condition(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Not(_)) => {
                self.condition(&unary.expr).map(|condition| Condition::Not(condition.into()))
            }
            Expr::Binary(binary) => self.joined(binary),
            _ => self.no_condition(expr),
        }
    }

    fn joined(&mut self, binary: &ExprBinary) -> Option<Condition> {
        if let Some(op) = comparison(&binary.op) {
            if [&binary.left, &binary.right].into_iter().any(|side| crate::comparison::is_decided(side)) {
                self.errors.push(binary, error::CHAINED);
                return None;
            }
            let (left, right) = (self.expression(&binary.left), self.expression(&binary.right));
            let (left, right) = (left?, right?);
            if [&left, &right].into_iter().any(has_residual) {
                self.errors.push(binary, error::RESIDUAL_DECIDES);
                return None;
            }
            return Some(Condition::Compare { op, left, right });
        }
        let join = match binary.op {
            BinOp::And(_) => Condition::And,
            BinOp::Or(_) => Condition::Or,
            _ => return self.no_condition(binary),
        };
        let (left, right) = (self.condition(&binary.left), self.condition(&binary.right));
        Some(join(left?.into(), right?.into()))
    }

    fn no_condition(&mut self, tokens: impl quote::ToTokens) -> Option<Condition> {
        self.errors.push(tokens, error::CONDITION);
        None
    }
}

fn has_residual(expr: &kernel::Expr) -> bool {
    match expr {
        kernel::Expr::Residual(_) => true,
        kernel::Expr::Neg(inner) | kernel::Expr::Sqrt(inner) | kernel::Expr::Abs(inner) => has_residual(inner),
        kernel::Expr::Binary { left, right, .. } => has_residual(left) || has_residual(right),
        _ => false,
    }
}

fn comparison(op: &BinOp) -> Option<Comparison> {
    match op {
        BinOp::Lt(_) => Some(Comparison::Less),
        BinOp::Le(_) => Some(Comparison::LessEqual),
        BinOp::Gt(_) => Some(Comparison::Greater),
        BinOp::Ge(_) => Some(Comparison::GreaterEqual),
        BinOp::Eq(_) => Some(Comparison::Equal),
        BinOp::Ne(_) => Some(Comparison::NotEqual),
        _ => None,
    }
}
