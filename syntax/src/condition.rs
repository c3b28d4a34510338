//! Conditions: comparisons of expressions, joined by `&&`, `||` and `!`.

use syn::{BinOp, Expr, ExprBinary, UnOp};

use crate::error;
use crate::expression::Reader;
use crate::kernel::{Comparison, Condition};

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
            let (left, right) = (self.expression(&binary.left), self.expression(&binary.right));
            return Some(Condition::Compare { op, left: left?, right: right? });
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
