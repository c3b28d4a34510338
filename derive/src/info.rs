//! The constant `INFO`.

use closedform_syntax::{
    Input, Kernel, Precision, ResultMeta, input_signs, operations, ordinary, ordinary_when_bounded,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

/// The magnitudes to expect of an input whose range is not given.
const TYPICAL: (f64, f64) = (1e-3, 1e3);

/// `INFO` of a kernel, as an expression.
pub fn info(kernel: &Kernel) -> TokenStream {
    let meta = &kernel.meta;
    let name = full_name(kernel);
    let [family, maxima, latex, source] = [&meta.family, &meta.maxima, &meta.latex, &meta.source].map(or_empty);
    let summary = &meta.summary;
    let inputs = kernel.inputs.iter().map(input);
    let domain = kernel.requires.iter().map(|require| &require.text);
    let results = meta.results.iter().map(result);
    let rules = &meta.rules;
    let precision = match meta.precision {
        Precision::Double => quote!(Double),
        Precision::DoubleDouble => quote!(DoubleDouble),
        Precision::Certified => quote!(Certified),
    };
    let operations = operations_literal(kernel);
    let ordinary = ordinary(kernel);
    quote! {
        ::closedform::Info {
            name: #name,
            family: #family,
            summary: #summary,
            maxima: #maxima,
            latex: #latex,
            source: #source,
            inputs: &[#(#inputs),*],
            domain: &[#(#domain),*],
            results: &[#(#results),*],
            rules: &[#(#rules),*],
            precision: ::closedform::Precision::#precision,
            operations: #operations,
            ordinary: #ordinary,
        }
    }
}

/// What is known of the inputs before `fast` looks at them, as an expression.
pub fn fast(kernel: &Kernel) -> TokenStream {
    let ordinary = ordinary_when_bounded(kernel);
    let signs = input_signs(kernel).into_iter().map(|signs| {
        let (negative, positive, zero) = (signs.negative, signs.positive, signs.zero);
        quote!(::closedform::Signs { negative: #negative, positive: #positive, zero: #zero })
    });
    quote!(::closedform::Fast { ordinary: #ordinary, signs: [#(#signs),*] })
}

fn full_name(kernel: &Kernel) -> String {
    match &kernel.meta.family {
        Some(family) => format!("{family}::{}", kernel.name.unraw()),
        None => kernel.name.unraw().to_string(),
    }
}

fn or_empty(text: &Option<String>) -> &str {
    text.as_deref().unwrap_or_default()
}

fn input(input: &Input) -> TokenStream {
    let name = input.name.unraw().to_string();
    let maxima = input.maxima.as_ref().unwrap_or(&name);
    let unit = or_empty(&input.unit);
    let (low, high) = input.typical.unwrap_or(TYPICAL);
    quote!(::closedform::Input { name: #name, maxima: #maxima, unit: #unit, typical: (#low, #high) })
}

fn result(result: &ResultMeta) -> TokenStream {
    let name = result.name.unraw().to_string();
    let [worksheet, unit] = [&result.worksheet, &result.unit].map(or_empty);
    let bound = match result.bound {
        Some(bound) => quote!(::core::option::Option::Some(#bound)),
        None => quote!(::core::option::Option::None),
    };
    quote!(::closedform::ResultInfo { name: #name, worksheet: #worksheet, unit: #unit, bound_ulp: #bound })
}

fn operations_literal(kernel: &Kernel) -> TokenStream {
    let operations = operations(kernel);
    let (keys, counts): (Vec<Ident>, Vec<u32>) =
        operations.named().map(|(key, _, count)| (Ident::new(key, Span::call_site()), count)).unzip();
    let compensated_expressions = operations.compensated_expressions;
    quote!(::closedform::Operations { #(#keys: #counts,)* compensated_expressions: #compensated_expressions })
}
