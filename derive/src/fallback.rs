//! What stands in for a function that is no kernel: its errors, and its signature for the sake of its callers.

use closedform_syntax::check_limits;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;
use syn::{FnArg, ItemFn};

/// The errors, and the function with a body that never runs.
pub fn function(error: &syn::Error, mut function: ItemFn) -> TokenStream {
    for argument in &mut function.sig.inputs {
        if let FnArg::Typed(argument) = argument {
            argument.attrs.clear();
        }
    }
    let error = error.to_compile_error();
    let ItemFn { attrs, vis, sig, .. } = function;
    let name = &sig.ident;
    quote! {
        #error
        #(#attrs)*
        #[allow(unused)]
        #vis #sig {
            ::core::unreachable!()
        }
        #[doc = "Stands in for a kernel that does not compile."]
        #[allow(unused)]
        #vis mod #name {}
    }
}

/// The error of a function beyond the limits, and where its body alone is too deep, what [`function`] gives.
pub fn deep(error: &syn::Error, item: TokenStream) -> TokenStream {
    let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let head: TokenStream = item.into_iter().take_while(|token| !is_body(token)).collect();
    if check_limits(head.clone()).is_err() {
        return error.to_compile_error();
    }
    match syn::parse2(quote!(#head {})) {
        Ok(bodiless) => function(error, bodiless),
        Err(_) => error.to_compile_error(),
    }
}
