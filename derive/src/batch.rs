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
        let [escalate, escalated, row, any, block, rows, start, length] =
            ["__escalate", "__escalated", "__row", "__any", "__block", "__rows", "__start", "__length"]
                .map(|name| Ident::new(name, Span::mixed_site()));
        let padded: Vec<Ident> =
            (0..results.len()).map(|at| Ident::new(&format!("__padded{at}"), Span::mixed_site())).collect();
        let count = results.len();
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
                // Arguments of a function do not overlap: compilers need not look whether they do. Arrays of a known length need no
                // bounds checks.
                #[inline(never)]
                fn #block(
                    #(#inputs: &::closedform::__private::Column,)*
                    #(#results: &mut ::closedform::__private::Column,)*
                    #escalated: &mut [u64; ::closedform::__private::BLOCK],
                ) -> u64 {
                    let mut #any = 0;
                    for #row in 0..::closedform::__private::BLOCK {
                        let #escalate = ::core::cell::Cell::new(0);
                        [#(#results[#row]),*] = ::closedform::__private::#first_tier::<Program, #sizes>(
                            &[#(#inputs[#row]),*],
                            &#escalate,
                        );
                        #escalated[#row] = #escalate.get();
                        #any |= #escalate.get();
                    }
                    #any
                }
                fn #rows(
                    #(#inputs: &::closedform::__private::Column,)*
                    #(#results: &mut ::closedform::__private::Column,)*
                ) {
                    let mut #escalated = [0; ::closedform::__private::BLOCK];
                    if #block(#(#inputs,)* #(#results,)* &mut #escalated) == 0 {
                        return;
                    }
                    for #row in ::closedform::__private::raised(&#escalated) {
                        if let (#(::core::option::Option::Some(#inputs),)* #(::core::option::Option::Some(#results)),*) =
                            (#(#inputs.get(#row),)* #(#results.get_mut(#row)),*)
                        {
                            [#(*#results),*] = ::closedform::__private::#again::<Program, #sizes>(&[#(*#inputs),*]);
                        }
                    }
                }
                #checks
                for #start in ::closedform::__private::starts(#length) {
                    if let (#(::core::option::Option::Some(#inputs),)* #(::core::option::Option::Some(#results)),*) = (
                        #(::closedform::__private::block(#inputs, #start),)*
                        #(::closedform::__private::block_mut(#results, #start)),*
                    ) {
                        #rows(#(#inputs,)* #(#results),*);
                    }
                }
                if 0 < #length && #length < ::closedform::__private::BLOCK {
                    #(let #inputs = ::closedform::__private::padded(#inputs);)*
                    let [#(mut #padded),*] = [[0.0; ::closedform::__private::BLOCK]; #count];
                    #rows(#(&#inputs,)* #(&mut #padded),*);
                    #(::closedform::__private::unpadded(&#padded, #results);)*
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
