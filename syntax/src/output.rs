//! The result at the end of a body: an expression or a struct literal.

use syn::{Expr, ExprStruct, FieldValue, Ident, Member};

use crate::error::{self, Errors};
use crate::expression::Reader;
use crate::input::Returns;
use crate::kernel::{self, Output};
use crate::scope::Scope;

/// Reads the result; it must be of the type that the signature `returns`.
pub fn parse(tail: &Expr, returns: Option<Returns>, scope: &Scope, errors: &mut Errors) -> Option<Output> {
    match (tail, returns) {
        (Expr::Struct(literal), Some(Returns::Struct(name))) if literal.path.is_ident(&name) => {
            fields(literal, scope, errors).map(|fields| Output::Struct { name, fields })
        }
        (Expr::Struct(_), Some(_)) | (_, Some(Returns::Struct(_))) => {
            errors.push(tail, error::RESULT_SHAPE);
            None
        }
        (_, Some(Returns::Number)) => Reader { scope, errors }.expression(tail).map(Output::Value),
        // The signature is in error already.
        (_, None) => None,
    }
}

fn fields(literal: &ExprStruct, scope: &Scope, errors: &mut Errors) -> Option<Vec<(Ident, kernel::Expr)>> {
    if let Some(rest) = &literal.dot2_token {
        errors.push(rest, error::REST);
    }
    if literal.fields.is_empty() {
        errors.push(literal, error::NO_FIELDS);
    }
    let mut seen: Vec<Ident> = Vec::new();
    let fields: Vec<_> = literal.fields.iter().map(|written| field(written, &mut seen, scope, errors)).collect();
    fields.into_iter().collect()
}

fn field(
    written: &FieldValue,
    seen: &mut Vec<Ident>,
    scope: &Scope,
    errors: &mut Errors,
) -> Option<(Ident, kernel::Expr)> {
    let Member::Named(name) = &written.member else {
        errors.push(written, error::FIELD);
        return None;
    };
    if seen.contains(name) {
        errors.push(name, error::FIELD_TWICE);
    }
    seen.push(name.clone());
    let value = Reader { scope, errors }.expression(&written.expr)?;
    Some((name.clone(), value))
}
