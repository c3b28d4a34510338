//! What attributes are made of: lists of keys, keys with texts, and documentation.

use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Lit, LitStr, Meta, MetaList, Token};

use crate::error::{self, Errors};

/// The items of a list; `message` says how to write it.
pub fn items(list: &MetaList, message: &str, errors: &mut Errors) -> Vec<Meta> {
    match list.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated) {
        Ok(items) => items.into_iter().collect(),
        Err(_) => {
            errors.push(list, message);
            Vec::new()
        }
    }
}

/// The text of `key = "text"`.
pub fn text(item: &Meta, errors: &mut Errors) -> Option<LitStr> {
    if let Meta::NameValue(pair) = item
        && let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = &pair.value
    {
        return Some(text.clone());
    }
    errors.push(item, error::TEXT);
    None
}

/// The documentation among attributes, as Markdown.
pub fn documentation(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    });
    lines.collect::<Vec<_>>().join("\n")
}
