//! The names that an expression can use.

use std::collections::HashSet;

use closedform_arith::Function;
use proc_macro2::Ident;

use crate::error::{self, Errors};
use crate::kernel::{Expr, Name};

/// What the language means by itself, besides the functions of the table.
const RESERVED: [&str; 7] = ["max", "min", "positive_root", "compensated", "residual", "require", "f64"];

/// Inputs followed by steps, in order.
#[derive(Default)]
pub struct Scope {
    names: Vec<Ident>,
    /// The steps whose values depend on a `residual!`, by slot.
    residual: HashSet<usize>,
}

impl Scope {
    /// Adds `ident`, which must be new.
    pub fn declare(&mut self, ident: &Ident, errors: &mut Errors) {
        let text = ident.to_string();
        if !text.starts_with(|first: char| first.is_lowercase() || first == '_') || text == "_" {
            errors.push(ident, error::NAME_CASE);
        } else if RESERVED.contains(&text.as_str()) || Function::named(&text).is_some() {
            errors.push(ident, error::NAME_RESERVED);
        } else if self.names.contains(ident) {
            errors.push(ident, error::NAME_TAKEN);
        }
        self.names.push(ident.clone());
    }

    /// Adds the name of a step with this value, if that could be read.
    pub fn declare_step(&mut self, ident: &Ident, value: Option<&Expr>, errors: &mut Errors) {
        if value.is_some_and(|value| self.has_residual(value)) {
            self.residual.insert(self.names.len());
        }
        self.declare(ident, errors);
    }

    /// Whether the value of an expression depends on a `residual!`, in itself or in a step that it names.
    pub fn has_residual(&self, expr: &Expr) -> bool {
        expr.any(&mut |part| match part {
            Expr::Residual(_) => true,
            Expr::Name(name) => self.residual.contains(&name.slot),
            _ => false,
        })
    }

    /// What `ident` stands for.
    pub fn resolve(&self, ident: &Ident, errors: &mut Errors) -> Option<Name> {
        let slot = self.names.iter().position(|known| known == ident);
        if slot.is_none() {
            errors.push(ident, error::UNKNOWN_NAME);
        }
        Some(Name { ident: ident.clone(), slot: slot? })
    }
}
