//! Expressions: from Rust's to ours, refusing everything else by a message of its own.

use std::borrow::Cow;

use closedform_arith::Function;
use closedform_arith::limits::MAX_DEGREE;
use syn::{
    BinOp, Block, Expr, ExprCall, ExprIf, ExprLit, ExprMacro, ExprMethodCall, ExprPath, ExprUnary, Lit, LitFloat, Stmt,
    UnOp,
};

use crate::error::{self, Errors};
use crate::kernel::{self, BinaryOp, CompensatedExpr};
use crate::scope::Scope;

/// Reads expressions and conditions; every method returns `None` only with an error added.
pub struct Reader<'a> {
    pub scope: &'a Scope,
    pub errors: &'a mut Errors,
}

impl<'r> Reader<'r> {
    /// Reads an expression.
    pub fn expression(&mut self, expr: &Expr) -> Option<kernel::Expr> {
        match expr {
            Expr::Paren(inner) => self.expression(&inner.expr),
            Expr::Group(inner) => self.expression(&inner.expr),
            Expr::Lit(literal) => self.literal(literal),
            Expr::Path(path) => self.name(path),
            Expr::Unary(unary) => self.negation(unary, Self::expression),
            Expr::Binary(binary) => match operator(&binary.op) {
                Some(op) => self.binary(op, [&binary.left, &binary.right], Self::expression),
                None => self.refuse(expr),
            },
            Expr::Call(call) => self.call(call),
            Expr::Macro(mac) => self.macro_call(mac),
            Expr::If(choice) => self.choice(choice),
            _ => self.refuse(expr),
        }
    }

    fn refuse<T>(&mut self, expr: &Expr) -> Option<T> {
        self.errors.push(expr, &refusal(expr));
        None
    }

    fn literal(&mut self, literal: &ExprLit) -> Option<kernel::Expr> {
        let message = match &literal.lit {
            Lit::Float(float) => match finite(float) {
                Ok(value) => return Some(kernel::Expr::Literal { value, span: float.span() }),
                Err(message) => message,
            },
            Lit::Int(_) => error::INTEGER,
            _ => error::LITERAL,
        };
        self.errors.push(literal, message);
        None
    }

    fn name(&mut self, path: &ExprPath) -> Option<kernel::Expr> {
        match path.path.get_ident() {
            Some(ident) if ident == "PI" => Some(kernel::Expr::Pi(ident.span())),
            Some(ident) => self.scope.resolve(ident, self.errors).map(kernel::Expr::Name),
            None => {
                self.errors.push(path, error::UNKNOWN_NAME);
                None
            }
        }
    }

    fn negation(&mut self, unary: &ExprUnary, read: Read<'r>) -> Option<kernel::Expr> {
        match unary.op {
            UnOp::Neg(_) => read(self, &unary.expr).map(|operand| kernel::Expr::Neg(operand.into())),
            UnOp::Not(_) => self.refuse_with(unary, error::CONDITION_AS_VALUE),
            UnOp::Deref(_) => self.refuse_with(unary, error::REFERENCE),
            _ => self.refuse_with(unary, error::OPERATOR),
        }
    }

    fn refuse_with<T>(&mut self, tokens: impl quote::ToTokens, message: &str) -> Option<T> {
        self.errors.push(tokens, message);
        None
    }

    fn binary(&mut self, op: BinaryOp, operands: [&Expr; 2], read: Read<'r>) -> Option<kernel::Expr> {
        // Both sides are read before either can fail, so that errors on both are found.
        let [left, right] = operands.map(|operand| read(self, operand));
        Some(kernel::Expr::Binary { op, left: left?.into(), right: right?.into() })
    }

    fn call(&mut self, call: &ExprCall) -> Option<kernel::Expr> {
        let name = match &*call.func {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        if let Some(function) = name.as_deref().and_then(Function::named) {
            return self.argument(call).map(|operand| kernel::Expr::Call(function, operand.into()));
        }
        match name.as_deref() {
            Some("max") => self.extreme(call, true),
            Some("min") => self.extreme(call, false),
            Some("positive_root") => self.root(call),
            Some("require" | "compensated" | "residual") => self.refuse_with(&call.func, error::BANG),
            _ => self.refuse_with(&call.func, &error::unknown_call()),
        }
    }

    fn argument(&mut self, call: &ExprCall) -> Option<kernel::Expr> {
        if call.args.len() != 1 {
            return self.refuse_with(call, error::ONE_ARGUMENT);
        }
        self.expression(call.args.first()?)
    }

    fn extreme(&mut self, call: &ExprCall, largest: bool) -> Option<kernel::Expr> {
        if call.args.len() < 2 {
            return self.refuse_with(call, error::TWO_ARGUMENTS);
        }
        let items: Vec<_> = call.args.iter().map(|item| self.expression(item)).collect();
        Some(kernel::Expr::Extreme { largest, items: items.into_iter().collect::<Option<_>>()? })
    }

    fn root(&mut self, call: &ExprCall) -> Option<kernel::Expr> {
        let coefficients = match call.args.first() {
            Some(Expr::Array(array)) if call.args.len() == 1 => &array.elems,
            _ => return self.refuse_with(call, error::ROOT),
        };
        if !(2..=MAX_DEGREE + 1).contains(&coefficients.len()) {
            return self.refuse_with(call, error::ROOT);
        }
        let read: Vec<_> = coefficients.iter().map(|coefficient| self.expression(coefficient)).collect();
        read.into_iter().collect::<Option<_>>().map(kernel::Expr::PositiveRoot)
    }

    fn macro_call(&mut self, mac: &ExprMacro) -> Option<kernel::Expr> {
        let compensated = mac.mac.path.is_ident("compensated");
        if !compensated && !mac.mac.path.is_ident("residual") {
            let late = mac.mac.path.is_ident("require");
            return self.refuse_with(mac, if late { error::LATE_REQUIRE } else { error::MACRO });
        }
        let read = mac.mac.parse_body::<Expr>();
        let expression = self.errors.take(read)?;
        let expression = self.compensated_expression(&expression)?;
        if !compensated {
            return Some(kernel::Expr::Residual(expression.into()));
        }
        match CompensatedExpr::new(expression) {
            Ok(expression) => Some(kernel::Expr::Compensated(expression)),
            Err(message) => self.refuse_with(mac, message),
        }
    }

    /// Reads an expression inside `compensated!` or `residual!`.
    fn compensated_expression(&mut self, expr: &Expr) -> Option<kernel::Expr> {
        match expr {
            Expr::Paren(inner) => self.compensated_expression(&inner.expr),
            Expr::Group(inner) => self.compensated_expression(&inner.expr),
            Expr::Lit(literal) => self.literal(literal),
            Expr::Path(path) if path.path.is_ident("PI") => self.refuse_with(expr, error::COMPENSATED),
            Expr::Path(path) => self.name(path),
            Expr::Unary(unary) => self.negation(unary, Self::compensated_expression),
            Expr::Binary(binary) => match operator(&binary.op) {
                Some(BinaryOp::Div) => self.refuse_with(expr, error::COMPENSATED_DIVISION),
                Some(op) => self.binary(op, [&binary.left, &binary.right], Self::compensated_expression),
                None => self.refuse(expr),
            },
            Expr::Call(_) | Expr::Macro(_) | Expr::If(_) => self.refuse_with(expr, error::COMPENSATED),
            _ => self.refuse(expr),
        }
    }

    fn choice(&mut self, choice: &ExprIf) -> Option<kernel::Expr> {
        let condition = self.condition(&choice.cond);
        let then = self.branch(&choice.then_branch);
        let Some((_, otherwise)) = &choice.else_branch else { return self.refuse_with(choice, error::IF_ELSE) };
        let otherwise = match &**otherwise {
            Expr::Block(block) => self.branch(&block.block),
            chained => self.expression(chained),
        };
        Some(kernel::Expr::If { condition: condition?.into(), then: then?.into(), otherwise: otherwise?.into() })
    }

    fn branch(&mut self, block: &Block) -> Option<kernel::Expr> {
        match &block.stmts[..] {
            [Stmt::Expr(value, None)] => self.expression(value),
            [Stmt::Macro(value)] if value.semi_token.is_none() => {
                self.macro_call(&ExprMacro { attrs: Vec::new(), mac: value.mac.clone() })
            }
            _ => self.refuse_with(block, error::BRANCH),
        }
    }
}

type Read<'r> = fn(&mut Reader<'r>, &Expr) -> Option<kernel::Expr>;

fn finite(float: &LitFloat) -> Result<f64, &'static str> {
    if !float.suffix().is_empty() {
        return Err(error::SUFFIX);
    }
    float.base10_parse().ok().filter(|value: &f64| value.is_finite()).ok_or(error::HUGE)
}

fn operator(op: &BinOp) -> Option<BinaryOp> {
    match op {
        BinOp::Add(_) => Some(BinaryOp::Add),
        BinOp::Sub(_) => Some(BinaryOp::Sub),
        BinOp::Mul(_) => Some(BinaryOp::Mul),
        BinOp::Div(_) => Some(BinaryOp::Div),
        _ => None,
    }
}

/// What is wrong with an expression that is not part of the kernel language.
pub fn refusal(expr: &Expr) -> Cow<'static, str> {
    let message = match expr {
        Expr::Binary(binary) => match binary.op {
            BinOp::And(_) | BinOp::Or(_) | BinOp::Eq(_) | BinOp::Ne(_) => error::CONDITION_AS_VALUE,
            BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) => error::CONDITION_AS_VALUE,
            _ => error::OPERATOR,
        },
        Expr::MethodCall(call) if is_power(call) => error::POWER,
        Expr::MethodCall(_) => return error::method().into(),
        Expr::Cast(_) => error::CAST,
        Expr::Reference(_) | Expr::RawAddr(_) => error::REFERENCE,
        Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) | Expr::Break(_) | Expr::Continue(_) => error::LOOP,
        Expr::Match(_) => error::MATCH,
        Expr::Return(_) => error::RETURN,
        _ => error::EXPRESSION,
    };
    message.into()
}

fn is_power(call: &ExprMethodCall) -> bool {
    ["powi", "powf", "pow"].iter().any(|power| call.method == power)
}
