//! Conditions: comparisons of expressions, joined by `&&`, `||` and `!`.

use closedform_arith::Relation;
use syn::{BinOp, Expr, ExprBinary, UnOp};

use crate::error;
use crate::expression::Reader;
use crate::kernel::Condition;

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
        if let Some(op) = relation(&binary.op) {
            if [&binary.left, &binary.right].into_iter().any(|side| crate::comparison::is_decided(side)) {
                self.errors.push(binary, error::CHAINED);
                return None;
            }
            let (left, right) = (self.expression(&binary.left), self.expression(&binary.right));
            let (left, right) = (left?, right?);
            if [&left, &right].into_iter().any(|side| self.scope.has_residual(side)) {
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

fn relation(op: &BinOp) -> Option<Relation> {
    match op {
        BinOp::Lt(_) => Some(Relation::Less),
        BinOp::Le(_) => Some(Relation::LessOrEqual),
        BinOp::Gt(_) => Some(Relation::Greater),
        BinOp::Ge(_) => Some(Relation::GreaterOrEqual),
        BinOp::Eq(_) => Some(Relation::Equal),
        BinOp::Ne(_) => Some(Relation::NotEqual),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::error::RESIDUAL_DECIDES;

    fn refusal(body: &str) -> Option<String> {
        let text = format!("#[kernel]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
        crate::parse_file(&text).err().map(|error| error.to_string())
    }

    #[test]
    fn no_residual_decides_wherever_it_stands() {
        let residual = "residual!(x * y - 1.0)";
        for (before, side) in [
            ("", residual.to_owned()),
            ("", format!("y - -{residual} / x")),
            ("", format!("sqrt(abs({residual}))")),
            ("", format!("max({residual}, y)")),
            ("", format!("min(y, {residual})")),
            ("", format!("if x > y {{ y }} else {{ {residual} }}")),
            ("", format!("positive_root([-x, {residual}])")),
            ("let r = residual!(x * y - 1.0);", "r".to_owned()),
            ("let r = residual!(x * y - 1.0); let s = x / r; let t = max(s, x);", "compensated!(t * t - y)".to_owned()),
        ] {
            let chosen = format!("{before} if x > y && !({side} > 0.0) {{ x }} else {{ y }}");
            assert_eq!(refusal(&chosen).as_deref(), Some(RESIDUAL_DECIDES), "{chosen}");
            let turned = format!("{before} if 0.0 <= {side} {{ x }} else {{ y }}");
            assert_eq!(refusal(&turned).as_deref(), Some(RESIDUAL_DECIDES), "{turned}");
            if before.is_empty() {
                let required = format!("require!({side} > 0.0); x");
                assert_eq!(refusal(&required).as_deref(), Some(RESIDUAL_DECIDES), "{required}");
            }
        }
    }

    #[test]
    fn a_residual_beside_a_condition_is_no_mistake() {
        assert_eq!(refusal("let r = residual!(x * y - 1.0); let s = x; if s > y { r } else { s }"), None);
    }
}
