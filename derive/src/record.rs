//! Structs of numbers with names: the trait `Record`, for the inputs of every kernel, and derived for structs of results.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::ext::IdentExt;
use syn::{Error, Fields, ItemStruct, Type};

const SHAPE: &str = "a record is a struct of named fields, each `f64`, without generic parameters";

/// The expansion of `#[derive(Record)]`.
pub fn derived(item: TokenStream) -> TokenStream {
    let read = syn::parse2(item).and_then(|item: ItemStruct| {
        let names = names(&item)?;
        Ok(implementation(&item.ident, &names))
    });
    read.unwrap_or_else(Error::into_compile_error)
}

/// The names of the fields of a record.
fn names(item: &ItemStruct) -> syn::Result<Vec<&Ident>> {
    let Fields::Named(fields) = &item.fields else { return Err(Error::new_spanned(&item.ident, SHAPE)) };
    if !item.generics.params.is_empty() || fields.named.is_empty() {
        return Err(Error::new_spanned(&item.ident, SHAPE));
    }
    let is_number =
        |declared: &Type| matches!(declared, Type::Path(path) if path.qself.is_none() && path.path.is_ident("f64"));
    let name = |field: &'_ syn::Field| match &field.ident {
        Some(_) if is_number(&field.ty) => Ok(()),
        _ => Err(Error::new_spanned(&field.ty, SHAPE)),
    };
    fields.named.iter().try_for_each(name)?;
    Ok(fields.named.iter().filter_map(|field| field.ident.as_ref()).collect())
}

/// The trait for a struct of these fields, and what the feature `serde` adds.
pub fn implementation(record: &Ident, fields: &[&Ident]) -> TokenStream {
    let count = fields.len();
    let names = fields.iter().map(|field| field.unraw().to_string());
    let numbers = Ident::new("__numbers", Span::mixed_site());
    let variables: Vec<Ident> =
        (0..count).map(|position| Ident::new(&format!("__number_{position}"), Span::mixed_site())).collect();
    let name = record.unraw().to_string();
    quote! {
        impl ::closedform::Record<#count> for #record {
            const NAMES: &'static [&'static str; #count] = &[#(#names),*];

            #[inline]
            fn from_numbers(#numbers: [f64; #count]) -> Self {
                let [#(#variables),*] = #numbers;
                Self { #(#fields: #variables),* }
            }

            #[inline]
            fn numbers(self) -> [f64; #count] {
                [#(self.#fields),*]
            }
        }

        ::closedform::__serialized!(#record, #name, #count);
    }
}
