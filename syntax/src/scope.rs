//! The names that an expression can use.

use proc_macro2::Ident;

use crate::error::{self, Errors};
use crate::kernel::Name;

const RESERVED: [&str; 9] = ["sqrt", "abs", "max", "min", "positive_root", "compensated", "residual", "require", "f64"];

/// Inputs followed by steps, in order.
#[derive(Default)]
pub struct Scope(Vec<Ident>);

impl Scope {
    /// Adds `ident`, which must be new.
    pub fn declare(&mut self, ident: &Ident, errors: &mut Errors) {
        let text = ident.to_string();
        if !text.starts_with(|first: char| first.is_lowercase() || first == '_') || text == "_" {
            errors.push(ident, error::NAME_CASE);
        } else if RESERVED.contains(&text.as_str()) {
            errors.push(ident, error::NAME_RESERVED);
        } else if self.0.contains(ident) {
            errors.push(ident, error::NAME_TAKEN);
        }
        self.0.push(ident.clone());
    }

    /// What `ident` stands for.
    pub fn resolve(&self, ident: &Ident, errors: &mut Errors) -> Option<Name> {
        let slot = self.0.iter().position(|known| known == ident);
        if slot.is_none() {
            errors.push(ident, error::UNKNOWN_NAME);
        }
        Some(Name { ident: ident.clone(), slot: slot? })
    }
}
