//! Batches: many points, one slice an input and one a result, or one struct a point.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::parts::Parts;

impl Parts<'_> {
    /// The function `batch`.
    pub fn batch(&self) -> TokenStream {
        self.by_columns(
            "batch",
            "The values of many points, bit for bit those of single calls; inputs first, then one slice a result.",
        )
    }

    /// The function `fast_batch`.
    pub fn fast_batch(&self) -> TokenStream {
        self.by_columns("fast_batch", "What [`fast`] returns of many points; inputs first, then one slice a result.")
    }

    /// A batch by columns.
    fn by_columns(&self, name: &str, documentation: &str) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let name = Ident::new(name, Span::call_site());
        quote! {
            #[doc = #documentation]
            ///
            /// # Errors
            ///
            /// When a slice is not as long as the first one. Then nothing is written.
            pub fn #name(
                #(#inputs: &[f64],)*
                #(#results: &mut [f64]),*
            ) -> ::core::result::Result<(), ::closedform::LengthError> {
                <Program as ::closedform::Program<#sizes>>::#name([#(#inputs),*], [#(#results),*])
            }
        }
    }

    /// The functions `rows` and `fast_rows`.
    pub fn rows(&self) -> TokenStream {
        let rows = self.rows_by(
            "rows",
            "The results of many rows of inputs, bit for bit those of single calls; of both slices the same length.",
            "batch",
        );
        let fast_rows = self.rows_by("fast_rows", "What [`fast`] returns of many rows of inputs.", "fast_batch");
        quote!(#rows #fast_rows)
    }

    /// Rows, by columns of few of them at a time.
    fn rows_by(&self, name: &str, documentation: &str, batch: &str) -> TokenStream {
        let Parts { results, sizes, .. } = self;
        let [name, batch] = [name, batch].map(|name| Ident::new(name, Span::call_site()));
        let output = self.output(&quote!(super::));
        quote! {
            #[doc = #documentation]
            ///
            /// # Errors
            ///
            /// When there are not as many results as rows. Then nothing is written.
            #[inline]
            pub fn #name(
                rows: &[Inputs],
                results: &mut [Results],
            ) -> ::core::result::Result<(), ::closedform::LengthError> {
                ::closedform::__private::rows(
                    INFO.name,
                    rows,
                    results,
                    |[#(#results),*]| #output,
                    <Program as ::closedform::Program<#sizes>>::#batch,
                )
            }
        }
    }
}
