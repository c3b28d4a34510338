//! Batches: many points, one slice an input and one a result, or one struct a point.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

use crate::parts::Parts;

impl Parts<'_> {
    /// The function `batch`.
    pub fn batch(&self) -> TokenStream {
        self.rows_in_blocks(
            "batch",
            "The values of many points, bit for bit those of single calls; inputs first, then one slice a result.",
            ["first_tier", "decided"],
        )
    }

    /// The function `fast_batch`.
    pub fn fast_batch(&self) -> TokenStream {
        self.rows_in_blocks(
            "fast_batch",
            "What [`fast`] returns of many points; inputs first, then one slice a result.",
            ["fast_first_tier", "fast_again"],
        )
    }

    /// A batch, by blocks: all rows `first_tier`, which has no branch, and those `again` that escalate.
    fn rows_in_blocks(&self, name: &str, documentation: &str, [first_tier, again]: [&str; 2]) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let checks = self.length_checks();
        let [name, first_tier, again] = [name, first_tier, again].map(|name| Ident::new(name, Span::call_site()));
        let [escalate, escalated, row, any, block] =
            ["__escalate", "__escalated", "__row", "__any", "__block"].map(|name| Ident::new(name, Span::mixed_site()));
        let (pattern, blocks) = self.zipped(
            |input| quote!(::closedform::__private::Blocks(#input)),
            |result| quote!(::closedform::__private::BlocksMut(#result)),
        );
        let (_, rows) = self.zipped(|input| quote!(#input.iter()), |result| quote!(#result.iter_mut()));
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
                // Arguments of a function do not overlap: compilers need not look whether they do.
                #[inline(never)]
                fn #block(
                    #(#inputs: &[f64],)*
                    #(#results: &mut [f64],)*
                    #escalated: &mut [u64; ::closedform::__private::BLOCK],
                ) -> u64 {
                    let mut #any = 0;
                    for (#pattern, #row) in #rows.zip(#escalated) {
                        let #escalate = ::core::cell::Cell::new(0);
                        [#(*#results),*] =
                            ::closedform::__private::#first_tier::<Program, #sizes>(&[#(*#inputs),*], &#escalate);
                        *#row = #escalate.get();
                        #any |= #escalate.get();
                    }
                    #any
                }
                #checks
                let mut #escalated = [0; ::closedform::__private::BLOCK];
                for #pattern in #blocks {
                    if #block(#(#inputs,)* #(&mut *#results,)* &mut #escalated) == 0 {
                        continue;
                    }
                    for #row in ::closedform::__private::raised(&#escalated) {
                        if let (#(::core::option::Option::Some(#inputs),)* #(::core::option::Option::Some(#results)),*) =
                            (#(#inputs.get(#row),)* #(#results.get_mut(#row)),*)
                        {
                            [#(*#results),*] = ::closedform::__private::#again::<Program, #sizes>(&[#(*#inputs),*]);
                        }
                    }
                }
                ::core::result::Result::Ok(())
            }
        }
    }

    /// That all slices of a batch are as long as the first.
    fn length_checks(&self) -> TokenStream {
        let length = Ident::new("__length", Span::mixed_site());
        let slices = self.inputs.iter().copied().chain(&self.results);
        let checks = slices.clone().skip(1).map(|slice| {
            let name = slice.unraw().to_string();
            quote!(::closedform::__private::same_length(INFO.name, #name, #length, #slice.len())?;)
        });
        let first = self.inputs.first();
        quote! {
            let #length = #first.len();
            #(#checks)*
        }
    }

    /// A pattern and an iterator of all inputs and results together. Zipped slices need no bounds checks.
    fn zipped(
        &self,
        input: impl Fn(&Ident) -> TokenStream,
        result: impl Fn(&Ident) -> TokenStream,
    ) -> (TokenStream, TokenStream) {
        let inputs = self.inputs.iter().map(|name| (quote!(#name), input(name)));
        let results = self.results.iter().map(|name| (quote!(#name), result(name)));
        let zipped = inputs.chain(results).reduce(|(pattern, rows), (next_pattern, next_rows)| {
            (quote!((#pattern, #next_pattern)), quote!(#rows.zip(#next_rows)))
        });
        zipped.unwrap_or_default()
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
