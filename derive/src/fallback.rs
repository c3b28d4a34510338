//! What stands in for a function that is no kernel: its errors, and its signature for the sake of its callers.

use proc_macro2::TokenStream;
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
