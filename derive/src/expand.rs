//! What a kernel becomes: the function, and the module of its other shapes.

use closedform_syntax::{Kernel, Output};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Attribute;
use syn::ext::IdentExt;

use crate::{info, program, table};

/// The expansion of a kernel.
pub fn kernel(kernel: &Kernel) -> TokenStream {
    let parts = Parts::of(kernel);
    let function = parts.function();
    let module = parts.module();
    quote!(#function #module)
}

/// What several parts of the expansion name.
struct Parts<'a> {
    kernel: &'a Kernel,
    /// The inputs, as the user named them.
    inputs: Vec<&'a Ident>,
    /// One variable a result, invisible to the user's names.
    results: Vec<Ident>,
    /// Numbers of inputs, conditions and results, as generic arguments.
    sizes: TokenStream,
}

impl<'a> Parts<'a> {
    fn of(kernel: &'a Kernel) -> Self {
        let results = kernel.meta.results.iter();
        let (n, k, m) = (kernel.inputs.len(), kernel.requires.len(), kernel.meta.results.len());
        Parts {
            kernel,
            inputs: kernel.inputs.iter().map(|input| &input.name).collect(),
            results: results.map(|result| unseen(&result.name)).collect(),
            sizes: quote!(#n, #k, #m),
        }
    }

    /// The function itself.
    fn function(&self) -> TokenStream {
        let Kernel { attributes, visibility, name, .. } = self.kernel;
        let Parts { inputs, results, sizes, .. } = self;
        let must_use = missing(attributes, "must_use").then(|| quote!(#[must_use]));
        let inline = missing(attributes, "inline").then(|| quote!(#[inline]));
        let returned = self.returned(&TokenStream::new());
        let output = self.output(&TokenStream::new());
        quote! {
            #(#attributes)*
            #must_use
            #inline
            #[allow(clippy::too_many_arguments)]
            #visibility fn #name(#(#inputs: f64),*) -> #returned {
                let [#(#results),*] = ::closedform::__private::value::<#name::Program, #sizes>(&[#(#inputs),*]);
                #output
            }
        }
    }

    /// The module beside it.
    fn module(&self) -> TokenStream {
        let Kernel { attributes, visibility, name, .. } = self.kernel;
        let conditional = attributes.iter().filter(|attribute| attribute.path().is_ident("cfg"));
        let plain = name.unraw();
        let documentation = format!("[`{plain}`](fn@{name}) in its other arithmetics and shapes.");
        let items = [
            self.constants(),
            self.program(),
            self.evaluate(),
            self.checked(),
            self.faithful(),
            self.fast(),
            self.with_bound(),
            self.batch(),
            self.fast_batch(),
            self.single(),
        ];
        quote! {
            #(#conditional)*
            #[doc = #documentation]
            #[allow(unused, clippy::all, clippy::pedantic)]
            #visibility mod #name {
                #(#items)*
            }
        }
    }

    fn constants(&self) -> TokenStream {
        let info = info::info(self.kernel);
        let sizes = &self.sizes;
        quote! {
            /// What is known of the kernel besides its code.
            pub const INFO: ::closedform::Info = #info;

            /// The kernel as a value, for tools that know none by name.
            pub const KERNEL: ::closedform::Kernel = ::closedform::Kernel::of::<Program, #sizes>();
        }
    }

    /// The type that carries the program to whatever is generic over programs.
    fn program(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let (n, m) = (inputs.len(), results.len());
        let (evaluate, domain) = (program::evaluate(self.kernel), program::domain(self.kernel));
        let (k, table) = (self.kernel.requires.len(), table::table(self.kernel));
        let all = program::inputs();
        let fast = info::fast(self.kernel);
        let slices = Ident::new("__slices", Span::mixed_site());
        quote! {
            pub(super) struct Program;

            impl ::closedform::Program<#sizes> for Program {
                const INFO: &'static ::closedform::Info = &INFO;
                const TABLE: ::core::option::Option<&'static ::closedform::Table<'static>> = #table;
                const FAST: ::closedform::Fast<#n> = #fast;

                #[inline(always)]
                fn evaluate<R: ::closedform::Real>(#all: &[R; #n]) -> [R; #m] {
                    #evaluate
                }

                #[inline(always)]
                fn domain<R: ::closedform::Real>(#all: &[R; #n]) -> [bool; #k] {
                    #domain
                }

                fn batch(
                    #all: [&[f64]; #n],
                    #slices: [&mut [f64]; #m],
                ) -> ::core::result::Result<(), ::closedform::LengthError> {
                    let [#(#inputs),*] = #all;
                    let [#(#results),*] = #slices;
                    self::batch(#(#inputs,)* #(#results),*)
                }

                fn fast_batch(
                    #all: [&[f64]; #n],
                    #slices: [&mut [f64]; #m],
                ) -> ::core::result::Result<(), ::closedform::LengthError> {
                    let [#(#inputs),*] = #all;
                    let [#(#results),*] = #slices;
                    self::fast_batch(#(#inputs,)* #(#results),*)
                }
            }
        }
    }

    fn evaluate(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let (n, m) = (inputs.len(), results.len());
        quote! {
            /// The same program in any arithmetic, whether or not the inputs lie in the domain.
            #[must_use]
            pub fn evaluate<R: ::closedform::Real>(inputs: &[R; #n]) -> [R; #m] {
                <Program as ::closedform::Program<#sizes>>::evaluate(inputs)
            }
        }
    }

    fn checked(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let returned = self.returned(&quote!(super::));
        let output = self.output(&quote!(super::));
        quote! {
            /// The value, or why there is none.
            ///
            /// # Errors
            ///
            /// Outside the domain, and where a result is too large or too small for `f64`.
            pub fn checked(
                #(#inputs: f64),*
            ) -> ::core::result::Result<#returned, ::closedform::ValueError> {
                let [#(#results),*] = ::closedform::__private::checked::<Program, #sizes>(&[#(#inputs),*])?;
                ::core::result::Result::Ok(#output)
            }
        }
    }

    fn faithful(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let returned = self.returned(&quote!(super::));
        let output = self.output(&quote!(super::));
        let documentation = if self.kernel.meta.results.iter().all(|result| result.bound.is_some()) {
            "The value with an error of less than one ulp; slower. NaN outside the domain."
        } else {
            "The value computed in double-double and rounded once; slower. NaN outside the domain.\n\nNo bound of its error \
             is known: the kernel carries no certificate."
        };
        quote! {
            #[doc = #documentation]
            #[must_use]
            pub fn faithful(#(#inputs: f64),*) -> #returned {
                let [#(#results),*] = ::closedform::__private::faithful::<Program, #sizes>(&[#(#inputs),*]);
                #output
            }
        }
    }

    fn fast(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let returned = self.returned(&quote!(super::));
        let output = self.output(&quote!(super::));
        quote! {
            /// The value with a relative error of at most 1e-13; NaN outside the domain. Most calls take `f64` alone.
            #[must_use]
            #[inline]
            pub fn fast(#(#inputs: f64),*) -> #returned {
                let [#(#results),*] = ::closedform::__private::fast::<Program, #sizes>(&[#(#inputs),*]);
                #output
            }
        }
    }

    fn with_bound(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let returned = self.returned(&quote!(super::));
        let output = self.output(&quote!(super::));
        let (values, errors) = (Ident::new("__values", Span::mixed_site()), Ident::new("__errors", Span::mixed_site()));
        quote! {
            /// The value, and a bound of its absolute error at these inputs; NaN outside the domain.
            #[must_use]
            pub fn with_bound(#(#inputs: f64),*) -> (#returned, #returned) {
                let (#values, #errors) =
                    ::closedform::__private::with_bound::<Program, #sizes>(&[#(#inputs),*]);
                let [#(#results),*] = #values;
                let #values = #output;
                let [#(#results),*] = #errors;
                (#values, #output)
            }
        }
    }

    fn batch(&self) -> TokenStream {
        self.rows_in_blocks(
            "batch",
            "The values of many points, bit for bit those of single calls; inputs first, then one slice a result.",
            ["first_tier", "value"],
        )
    }

    fn fast_batch(&self) -> TokenStream {
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

    fn single(&self) -> TokenStream {
        let Parts { inputs, results, sizes, .. } = self;
        let m = results.len();
        let (documentation, returned, output) = match self.kernel.output {
            Output::Value(_) => ("The value in single precision", quote!(f32), quote!(#(#results)*)),
            Output::Struct { .. } => (
                "The fields in single precision, in the order of `INFO.results`",
                quote!([f32; #m]),
                quote!([#(#results),*]),
            ),
        };
        let documentation = format!("{documentation}: evaluated in `f64` and rounded once. NaN outside the domain.");
        quote! {
            #[doc = #documentation]
            #[must_use]
            pub fn f32(#(#inputs: f32),*) -> #returned {
                let [#(#results),*] = ::closedform::__private::single::<Program, #sizes>(&[#(#inputs),*]);
                #output
            }
        }
    }

    /// The returned type, seen from where `path` leads to the kernel's own scope.
    fn returned(&self, path: &TokenStream) -> TokenStream {
        match &self.kernel.output {
            Output::Value(_) => quote!(f64),
            Output::Struct { name, .. } => quote!(#path #name),
        }
    }

    /// The returned value, made of the variables of the results.
    fn output(&self, path: &TokenStream) -> TokenStream {
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

fn missing(attributes: &[Attribute], name: &str) -> bool {
    !attributes.iter().any(|attribute| attribute.path().is_ident(name))
}
