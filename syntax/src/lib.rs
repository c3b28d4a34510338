//! The kernel language: the straight-line Rust function that a generator writes and `#[kernel]` reads.
//!
//! [`parse`] turns one function into a [`Kernel`] and checks it, [`parse_file`] does so for every kernel of a source
//! file. Errors point at the user's tokens and are collected: one run names them all. [`check_limits`] comes before, so
//! that nothing deep ends the stack; [`certified`] comes after, so that no bound is stated that was not proved. [`evaluate`]
//! and [`violated`] interpret a kernel; [`operations`] counts what it costs, [`ordinary`] tells at which inputs nothing over-
//! or underflows.
//!
//! This crate knows nothing of the runtime, which depends on it through the macro: arithmetic comes in by the trait
//! [`Real`](closedform_arith::Real).

mod attribute;
mod body;
mod certificate;
mod comparison;
mod compensated;
mod condition;
mod error;
mod example;
mod expression;
mod file;
mod input;
mod interpret;
mod kernel;
mod limits;
mod magnitude;
mod meta;
mod operations;
mod output;
mod pattern;
mod print;
mod scope;
mod table;
mod unit;
mod walk;

pub use closedform_arith::function::Domain as FunctionDomain;
pub use closedform_arith::{Function, Operations, Precision, Relation};

pub use certificate::{RULES, certificate, certified, fnv_1a};
pub use compensated::{Extended, Operand, Operation, Part};
pub use file::{Source, parse_file, sources};
pub use interpret::{Violation, evaluate, violated};
pub use kernel::{
    BinaryOp, CompensatedExpr, Condition, Example, Expr, Input, Kernel, Let, Meta, Name, Output, Require, ResultMeta,
};
pub use limits::check as check_limits;
pub use magnitude::{input_signs, ordinary, ordinary_when_bounded};
pub use operations::{operations, operations_of};
pub use print::{condition_text, expression_text};
pub use table::{Lowered, LoweredSum, lowered};
pub use unit::{BASES, Dimension, UnitError};

use proc_macro2::TokenStream;
use syn::{ItemFn, Result};

use error::Errors;
use scope::Scope;

/// The kernel written as the function `item` under `#[kernel(attribute)]`, whose tokens keep the limits.
///
/// # Errors
///
/// Everything in it that is not kernel language, all at once.
pub fn parse(attribute: TokenStream, item: ItemFn) -> Result<Kernel> {
    let mut errors = Errors::default();
    let written = attribute::parse(attribute, &mut errors);
    let mut scope = Scope::default();
    let returns = input::check_signature(&item.sig, &mut errors);
    let inputs = input::parse(&item.sig, &mut scope, &mut errors);
    let body = body::parse(&item, returns, &mut scope, &mut errors);
    let meta = body
        .as_ref()
        .map(|body| written.resolve(&body.output, &item.sig.ident, inputs.len(), &item.attrs, &mut errors));
    errors.finish()?;
    let (Some(body), Some(meta)) = (body, meta) else {
        return Err(syn::Error::new_spanned(&item.sig, error::UNREADABLE));
    };
    Ok(Kernel {
        attributes: item.attrs,
        visibility: item.vis,
        name: item.sig.ident,
        meta,
        inputs,
        requires: body.requires,
        lets: body.lets,
        output: body.output,
    })
}
