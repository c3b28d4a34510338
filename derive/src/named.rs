//! Calls by name: the inputs of one point as a struct, and those of many as a struct of slices.
//!
//! They are names over the calls by position, which they hand everything to: no program is compiled again for them.

use closedform_syntax::Output;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::documentation;
use crate::parts::Parts;
use crate::record;

impl Parts<'_> {
    /// The structs of the module.
    pub fn records(&self) -> TokenStream {
        let Parts { kernel, inputs, .. } = self;
        let name = &kernel.name;
        let docs: Vec<String> = kernel.inputs.iter().map(documentation::of_input).collect();
        let record = record::implementation(&Ident::new("Inputs", name.span()), inputs);
        let returned = self.returned(&quote!(super::));
        let (of_inputs, of_columns) = documentation::of_records(name);
        let columns_of_results = self.columns_of_results();
        quote! {
            #[doc = #of_inputs]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct Inputs {
                #(#[doc = #docs] pub #inputs: f64),*
            }

            #record

            /// What a call returns.
            pub type Results = #returned;

            #[doc = #of_columns]
            #[derive(Clone, Copy, Debug)]
            pub struct Columns<'a> {
                #(#[doc = #docs] pub #inputs: &'a [f64]),*
            }

            #columns_of_results
        }
    }

    /// Room for the results of many points, where there are several of each.
    fn columns_of_results(&self) -> TokenStream {
        let Output::Struct { .. } = self.kernel.output else { return TokenStream::new() };
        let fields = self.kernel.meta.results.iter().map(|result| {
            let (name, documentation) = (&result.name, documentation::of_result(result));
            quote!(#[doc = #documentation] pub #name: &'a mut [f64])
        });
        quote! {
            /// Room for the results of many points, a slice each, of the length of those in [`Columns`].
            #[derive(Debug)]
            pub struct ResultColumns<'a> {
                #(#fields),*
            }
        }
    }

    /// The calls of those structs. They stand beside the function, since a module cannot name what surrounds it where
    /// that is the body of another function.
    pub fn calls_by_name(&self) -> TokenStream {
        let name = &self.kernel.name;
        let (singly, batches) = (self.single_calls(), self.batch_calls());
        let conditional: Vec<_> = self.conditional().collect();
        quote! {
            #(#conditional)*
            #[allow(unused, clippy::all, clippy::pedantic)]
            impl #name::Inputs {
                #singly
            }

            #(#conditional)*
            #[allow(unused, clippy::all, clippy::pedantic)]
            impl #name::Columns<'_> {
                #batches
            }
        }
    }

    fn single_calls(&self) -> TokenStream {
        let Parts { kernel, inputs, .. } = self;
        let name = &kernel.name;
        let returned = self.returned(&TokenStream::new());
        let given = quote!(#(self.#inputs),*);
        quote! {
            /// The value; NaN outside the domain.
            #[must_use]
            #[inline]
            pub fn call(self) -> #returned {
                #name(#given)
            }

            /// The value, or why there is none.
            ///
            /// # Errors
            ///
            /// Outside the domain, and where a result is too large or too small for `f64`.
            #[inline]
            pub fn checked(self) -> ::core::result::Result<#returned, ::closedform::ValueError> {
                #name::checked(#given)
            }

            /// What `faithful` returns by position.
            #[must_use]
            #[inline]
            pub fn faithful(self) -> #returned {
                #name::faithful(#given)
            }

            /// The value with a relative error of at most 1e-13; NaN outside the domain.
            #[must_use]
            #[inline]
            pub fn fast(self) -> #returned {
                #name::fast(#given)
            }

            /// The value, and a bound of its absolute error at these inputs; NaN outside the domain.
            #[must_use]
            #[inline]
            pub fn with_bound(self) -> (#returned, #returned) {
                #name::with_bound(#given)
            }
        }
    }

    fn batch_calls(&self) -> TokenStream {
        let Parts { kernel, inputs, .. } = self;
        let name = &kernel.name;
        let (room, taken) = match &kernel.output {
            Output::Value(_) => (quote!(&mut [f64]), quote!(results)),
            Output::Struct { fields, .. } => {
                let fields = fields.iter().map(|(field, _)| field);
                (quote!(#name::ResultColumns<'_>), quote!(#(results.#fields),*))
            }
        };
        quote! {
            /// The values of many points, bit for bit those of single calls.
            ///
            /// # Errors
            ///
            /// When a slice is not as long as the first one. Then nothing is written.
            #[inline]
            pub fn batch(self, results: #room) -> ::core::result::Result<(), ::closedform::LengthError> {
                #name::batch(#(self.#inputs,)* #taken)
            }

            /// What `fast` returns of many points.
            ///
            /// # Errors
            ///
            /// When a slice is not as long as the first one. Then nothing is written.
            #[inline]
            pub fn fast_batch(self, results: #room) -> ::core::result::Result<(), ::closedform::LengthError> {
                #name::fast_batch(#(self.#inputs,)* #taken)
            }
        }
    }
}
