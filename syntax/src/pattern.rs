//! Patterns: the kernel language has plain names only.

use syn::{Ident, Pat, PatIdent};

/// The name, if the pattern is nothing else.
pub fn plain_name(pattern: &Pat) -> Option<&Ident> {
    match pattern {
        Pat::Ident(PatIdent { by_ref: None, mutability: None, subpat: None, ident, .. }) => Some(ident),
        _ => None,
    }
}

/// The names that a refused pattern was to declare: declared all the same, they spare follow-up errors.
pub fn intended_names(pattern: &Pat) -> Vec<&Ident> {
    match pattern {
        Pat::Ident(name) => vec![&name.ident],
        Pat::Type(typed) => intended_names(&typed.pat),
        Pat::Reference(reference) => intended_names(&reference.pat),
        Pat::Tuple(tuple) => tuple.elems.iter().flat_map(intended_names).collect(),
        _ => Vec::new(),
    }
}
