//! Source files: every kernel in them.

use proc_macro2::TokenStream;
use syn::{Attribute, Item, ItemFn, Meta, Result};

use crate::error::Errors;
use crate::kernel::Kernel;

/// Every function under `#[kernel]` in a Rust source file, those in inline modules included, in order.
///
/// # Errors
///
/// Everything in any of them that is not kernel language, or what keeps the file from being Rust.
pub fn parse_file(text: &str) -> Result<Vec<Kernel>> {
    let file = syn::parse_file(text)?;
    let mut errors = Errors::default();
    let mut kernels = Vec::new();
    collect(file.items, &mut kernels, &mut errors);
    errors.finish()?;
    Ok(kernels)
}

fn collect(items: Vec<Item>, kernels: &mut Vec<Kernel>, errors: &mut Errors) {
    for item in items {
        match item {
            Item::Fn(function) => kernels.extend(kernel(function, errors)),
            Item::Mod(module) => {
                let inline = module.content.map(|(_, items)| items);
                collect(inline.unwrap_or_default(), kernels, errors);
            }
            _ => {}
        }
    }
}

fn kernel(mut function: ItemFn, errors: &mut Errors) -> Option<Kernel> {
    let position = function.attrs.iter().position(is_kernel)?;
    let attribute = function.attrs.remove(position);
    errors.take(crate::parse(arguments(attribute), function))
}

/// `#[kernel]` or `#[closedform::kernel]`, with arguments or without.
fn is_kernel(attribute: &Attribute) -> bool {
    attribute.path().segments.last().is_some_and(|segment| segment.ident == "kernel")
}

fn arguments(attribute: Attribute) -> TokenStream {
    match attribute.meta {
        Meta::List(list) => list.tokens,
        _ => TokenStream::new(),
    }
}
