//! Function bodies: `require!`, then `let`, then the result.

use closedform_arith::limits::MAX_STEPS;
use syn::parse::{Parse, ParseStream};
use syn::{Expr, ExprMacro, ItemFn, LitStr, Local, LocalInit, Macro, Stmt, Token};

use crate::comparison;
use crate::error::{self, Errors};
use crate::expression::{Reader, refusal};
use crate::input::Returns;
use crate::kernel::{Let, Output, Require};
use crate::output;
use crate::pattern::{intended_names, plain_name};
use crate::print::condition_text;
use crate::scope::Scope;

/// What stands between the braces.
pub struct Body {
    pub requires: Vec<Require>,
    pub lets: Vec<Let>,
    pub output: Output,
}

/// Reads the body of `function`; `None` where there is no readable result, with its error added.
pub fn parse(function: &ItemFn, returns: Option<Returns>, scope: &mut Scope, errors: &mut Errors) -> Option<Body> {
    let (steps, tail) = split(function, errors);
    let mut requires = Vec::new();
    let mut lets = Vec::new();
    for step in steps {
        match step {
            Stmt::Macro(step) if step.mac.path.is_ident("require") => {
                if !lets.is_empty() {
                    errors.push(&step.mac, error::LATE_REQUIRE);
                }
                requires.extend(require(&step.mac, scope, errors));
            }
            Stmt::Local(step) if lets.len() == MAX_STEPS => {
                errors.push(step, error::STEPS);
                return None;
            }
            Stmt::Local(step) => lets.push(binding(step, scope, errors)),
            Stmt::Macro(step) => errors.push(&step.mac, error::MACRO),
            Stmt::Expr(step, _) if is_control_flow(step) => errors.push(step, &refusal(step)),
            step => errors.push(step, error::STATEMENT),
        }
    }
    let output = output::parse(&tail?, returns, scope, errors)?;
    Some(Body { requires, lets: lets.into_iter().flatten().collect(), output })
}

/// The steps, and the expression at the end.
fn split<'a>(function: &'a ItemFn, errors: &mut Errors) -> (&'a [Stmt], Option<Expr>) {
    let statements = &function.block.stmts[..];
    let Some((last, steps)) = statements.split_last() else {
        errors.push(&function.sig.ident, error::NO_RESULT);
        return (statements, None);
    };
    match last {
        Stmt::Expr(tail, None) => (steps, Some(tail.clone())),
        Stmt::Macro(tail) if tail.semi_token.is_none() && !tail.mac.path.is_ident("require") => {
            (steps, Some(Expr::Macro(ExprMacro { attrs: Vec::new(), mac: tail.mac.clone() })))
        }
        _ => {
            errors.push(last, error::NO_RESULT);
            (statements, None)
        }
    }
}

/// What as a statement deserves the message that it gets as an expression.
fn is_control_flow(step: &Expr) -> bool {
    matches!(step, Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) | Expr::Return(_) | Expr::Match(_))
}

/// The arguments of `require!`.
struct Requirement {
    condition: Expr,
    text: Option<LitStr>,
}

impl Parse for Requirement {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let condition = input.parse()?;
        let comma: Option<Token![,]> = input.parse()?;
        let text = if comma.is_some() && !input.is_empty() { Some(input.parse()?) } else { None };
        let _: Option<Token![,]> = input.parse()?;
        Ok(Requirement { condition, text })
    }
}

fn require(mac: &Macro, scope: &Scope, errors: &mut Errors) -> Option<Require> {
    let Ok(Requirement { condition, text }) = mac.parse_body() else {
        errors.push(mac, if comparison::is_chain(&mac.tokens) { error::CHAINED } else { error::REQUIRE });
        return None;
    };
    let condition = Reader { scope, errors }.condition(&condition)?;
    let text = text.map_or_else(|| condition_text(&condition), |text| text.value());
    Some(Require { condition, text })
}

/// Reads a step. Its name is declared even where its value is unreadable, to spare follow-up errors.
fn binding(local: &Local, scope: &mut Scope, errors: &mut Errors) -> Option<Let> {
    let value = match &local.init {
        Some(LocalInit { expr, diverge: None, .. }) => Reader { scope, errors }.expression(expr),
        _ => {
            errors.push(local, error::LET);
            None
        }
    };
    if let Some(name) = plain_name(&local.pat) {
        scope.declare_step(name, value.as_ref(), errors);
        return Some(Let { name: name.clone(), value: value? });
    }
    errors.push(local, error::LET);
    intended_names(&local.pat).into_iter().for_each(|name| scope.declare(name, errors));
    None
}
