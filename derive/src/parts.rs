//! What the parts of an expansion share: the kernel, and names that its user does not see.

use closedform_syntax::{Kernel, Output};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Attribute;

/// What several parts of the expansion name.
pub struct Parts<'a> {
    /// The kernel.
    pub kernel: &'a Kernel,
    /// The inputs, as the user named them.
    pub inputs: Vec<&'a Ident>,
    /// One variable a result, invisible to the user's names.
    pub results: Vec<Ident>,
    /// Numbers of inputs, conditions and results, as generic arguments.
    pub sizes: TokenStream,
}

impl<'a> Parts<'a> {
    /// The parts of a kernel.
    pub fn of(kernel: &'a Kernel) -> Self {
        let results = kernel.meta.results.iter();
        let (n, k, m) = (kernel.inputs.len(), kernel.requires.len(), kernel.meta.results.len());
        Parts {
            kernel,
            inputs: kernel.inputs.iter().map(|input| &input.name).collect(),
            results: results.map(|result| unseen(&result.name)).collect(),
            sizes: quote!(#n, #k, #m),
        }
    }

    /// The attributes of conditional compilation, which everything beside the function carries too.
    pub fn conditional(&self) -> impl Iterator<Item = &'a Attribute> {
        self.kernel.attributes.iter().filter(|attribute| attribute.path().is_ident("cfg"))
    }

    /// The returned type, seen from where `path` leads to the kernel's own scope.
    pub fn returned(&self, path: &TokenStream) -> TokenStream {
        match &self.kernel.output {
            Output::Value(_) => quote!(f64),
            Output::Struct { name, .. } => quote!(#path #name),
        }
    }

    /// The returned value, made of the variables of the results.
    pub fn output(&self, path: &TokenStream) -> TokenStream {
        let results = &self.results;
        match &self.kernel.output {
            Output::Value(_) => quote!(#(#results)*),
            Output::Struct { name, fields } => {
                let fields = fields.iter().map(|(field, _)| field);
                quote!(#path #name { #(#fields: #results),* })
            }
        }
    }
}

/// A name that is spelt alike and that the user's names do not see.
fn unseen(name: &Ident) -> Ident {
    let mut unseen = name.clone();
    unseen.set_span(Span::mixed_site());
    unseen
}
