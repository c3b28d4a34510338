//! The key `example(..)`: a call of the kernel that its documentation shows.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{LitFloat, Meta, Token};

use crate::error::{self, Errors};
use crate::kernel::Example;
use crate::meta::{items, text};

/// An example as written, before the inputs and results of the kernel are known.
pub struct Written {
    /// Where it stands.
    item: Meta,
    example: Example,
}

impl Written {
    /// The example of a kernel of so many inputs and results.
    pub fn of(&self, inputs: usize, results: usize, errors: &mut Errors) -> Example {
        if self.example.inputs.len() != inputs {
            errors.push(&self.item, error::EXAMPLE_INPUTS);
        }
        if !self.example.results.is_empty() && self.example.results.len() != results {
            errors.push(&self.item, error::EXAMPLE_RESULTS);
        }
        self.example.clone()
    }
}

/// Reads the key.
pub fn parse(item: &Meta, errors: &mut Errors) -> Option<Written> {
    let Meta::List(list) = item else {
        errors.push(item, error::EXAMPLE);
        return None;
    };
    let mut example = Example { path: String::new(), inputs: Vec::new(), results: Vec::new() };
    for part in items(list, error::EXAMPLE, errors) {
        match part.path() {
            path if path.is_ident("path") => {
                example.path = text(&part, errors).map(|text| text.value()).unwrap_or_default();
            }
            path if path.is_ident("inputs") => example.inputs = numbers(&part, errors)?,
            path if path.is_ident("results") => example.results = numbers(&part, errors)?,
            path => errors.push(path, error::EXAMPLE),
        }
    }
    if syn::parse_str::<syn::Path>(&example.path).is_err() {
        errors.push(item, error::EXAMPLE_PATH);
    }
    Some(Written { item: item.clone(), example })
}

fn numbers(item: &Meta, errors: &mut Errors) -> Option<Vec<f64>> {
    let read = Punctuated::<Number, Token![,]>::parse_terminated;
    let numbers = item.require_list().and_then(|list| list.parse_args_with(read));
    if numbers.is_err() {
        errors.push(item, error::EXAMPLE);
    }
    numbers.ok().map(|numbers| numbers.iter().map(|number| number.0).collect())
}

/// A float literal, with or without a sign.
struct Number(f64);

impl Parse for Number {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let negative = input.parse::<Option<Token![-]>>()?.is_some();
        let literal: LitFloat = input.parse()?;
        let value: f64 = literal.base10_parse()?;
        if value.is_infinite() {
            return Err(syn::Error::new_spanned(literal, error::HUGE));
        }
        Ok(Number(if negative { -value } else { value }))
    }
}
