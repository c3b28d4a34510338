//! What a kernel becomes: the function, and the module of its other shapes.

use closedform_syntax::{Kernel, Output};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Attribute;

use crate::parts::Parts;
use crate::{documentation, info, program, table};

/// The expansion of a kernel.
pub fn kernel(kernel: &Kernel) -> TokenStream {
    let parts = Parts::of(kernel);
    let function = parts.function();
    let (module, calls) = (parts.module(), parts.calls_by_name());
    quote!(#function #module #calls)
}

impl Parts<'_> {
    /// The function itself.
    fn function(&self) -> TokenStream {
        let Kernel { attributes, visibility, name, .. } = self.kernel;
        let Parts { inputs, results, sizes, .. } = self;
        let (above, formula, below) = documentation::of(self.kernel);
        let must_use = missing(attributes, "must_use").then(|| quote!(#[must_use]));
        let inline = missing(attributes, "inline").then(|| quote!(#[inline]));
        let returned = self.returned(&TokenStream::new());
        let output = self.output(&TokenStream::new());
        quote! {
            #(#above)*
            #formula
            #(#below)*
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
        let Kernel { visibility, name, .. } = self.kernel;
        let conditional = self.conditional();
        let documentation = documentation::of_module(name);
        let items = [
            self.constants(),
            self.records(),
            self.program(),
            self.evaluate(),
            self.checked(),
            self.faithful(),
            self.fast(),
            self.with_bound(),
            self.batch(),
            self.fast_batch(),
            self.rows(),
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
        let [slices, of] = ["__slices", "__of"].map(|name| Ident::new(name, Span::mixed_site()));
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

                #[inline(always)]
                fn each_input<T, U>(#all: [T; #n], mut #of: impl ::core::ops::FnMut(T) -> U) -> [U; #n] {
                    let [#(#inputs),*] = #all;
                    [#(#of(#inputs)),*]
                }

                #[inline(always)]
                fn each_result<T, U>(#all: [T; #m], mut #of: impl ::core::ops::FnMut(T) -> U) -> [U; #m] {
                    let [#(#results),*] = #all;
                    [#(#of(#results)),*]
                }

                fn batch(
                    #all: [&[f64]; #n],
                    #slices: [&mut [f64]; #m],
                ) -> ::core::result::Result<(), ::closedform::LengthError> {
                    ::closedform::__private::batch::<Self, #sizes>(#all, #slices)
                }

                fn fast_batch(
                    #all: [&[f64]; #n],
                    #slices: [&mut [f64]; #m],
                ) -> ::core::result::Result<(), ::closedform::LengthError> {
                    ::closedform::__private::fast_batch::<Self, #sizes>(#all, #slices)
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
}

fn missing(attributes: &[Attribute], name: &str) -> bool {
    !attributes.iter().any(|attribute| attribute.path().is_ident(name))
}
