//! Signatures: inputs with their `#[input(..)]`, and what a kernel returns.

use closedform_arith::limits::MAX_INPUTS;
use proc_macro2::Ident;
use quote::ToTokens;
use syn::punctuated::Punctuated;
use syn::{Attribute, FnArg, LitFloat, Meta, Path, ReturnType, Signature, Token, Type};

use crate::error::{self, Errors};
use crate::kernel::Input;
use crate::meta::{documentation, items, text};
use crate::pattern::{intended_names, plain_name};
use crate::scope::Scope;

/// What the signature says the kernel returns.
pub enum Returns {
    Number,
    Struct(Ident),
}

/// Refuses whatever makes the function more than a plain one; reads what it returns.
pub fn check_signature(signature: &Signature, errors: &mut Errors) -> Option<Returns> {
    let extras = [
        signature.constness.to_token_stream(),
        signature.asyncness.to_token_stream(),
        signature.safety.to_token_stream(),
        signature.abi.to_token_stream(),
        signature.generics.to_token_stream(),
        signature.generics.where_clause.to_token_stream(),
        signature.variadic.to_token_stream(),
    ];
    for extra in extras.iter().filter(|extra| !extra.is_empty()) {
        errors.push(extra, error::SIGNATURE);
    }
    returns(signature, errors)
}

fn returns(signature: &Signature, errors: &mut Errors) -> Option<Returns> {
    let ReturnType::Type(_, declared) = &signature.output else {
        errors.push(&signature.ident, error::RETURN_TYPE);
        return None;
    };
    match type_name(declared) {
        Some(name) if name == "f64" => Some(Returns::Number),
        Some(name) if name.to_string().starts_with(char::is_uppercase) => Some(Returns::Struct(name)),
        _ => {
            errors.push(declared, error::RETURN_TYPE);
            None
        }
    }
}

/// The name of a type that is one plain name.
fn type_name(declared: &Type) -> Option<Ident> {
    match declared {
        Type::Path(path) if path.qself.is_none() => path.path.get_ident().cloned(),
        _ => None,
    }
}

/// The inputs, declared in `scope`.
pub fn parse(signature: &Signature, scope: &mut Scope, errors: &mut Errors) -> Vec<Input> {
    if signature.inputs.is_empty() {
        errors.push(&signature.ident, error::NO_INPUTS);
    }
    if let Some(first_beyond) = signature.inputs.iter().nth(MAX_INPUTS) {
        errors.push(first_beyond, error::TOO_MANY_INPUTS);
    }
    signature.inputs.iter().filter_map(|argument| input(argument, scope, errors)).collect()
}

fn input(argument: &FnArg, scope: &mut Scope, errors: &mut Errors) -> Option<Input> {
    let FnArg::Typed(argument) = argument else {
        errors.push(argument, error::INPUT_PATTERN);
        return None;
    };
    let Some(name) = plain_name(&argument.pat) else {
        errors.push(&argument.pat, error::INPUT_PATTERN);
        intended_names(&argument.pat).into_iter().for_each(|name| scope.declare(name, errors));
        return None;
    };
    scope.declare(name, errors);
    if type_name(&argument.ty).is_none_or(|declared| declared != "f64") {
        errors.push(&argument.ty, error::INPUT_TYPE);
    }
    let mut input =
        Input { name: name.clone(), maxima: None, unit: None, doc: documentation(&argument.attrs), typical: None };
    for attribute in argument.attrs.iter().filter(|attribute| !attribute.path().is_ident("doc")) {
        describe(&mut input, attribute, errors);
    }
    Some(input)
}

fn describe(input: &mut Input, attribute: &Attribute, errors: &mut Errors) {
    let Meta::List(list) = &attribute.meta else { return errors.push(attribute, error::INPUT_ATTRIBUTE) };
    if !list.path.is_ident("input") {
        return errors.push(attribute, error::INPUT_ATTRIBUTE);
    }
    for item in items(list, error::INPUT_ATTRIBUTE, errors) {
        match item.path() {
            path if path.is_ident("maxima") => {
                once(&mut input.maxima, text(&item, errors).map(|text| text.value()), path, errors)
            }
            path if path.is_ident("unit") => {
                once(&mut input.unit, text(&item, errors).map(|text| text.value()), path, errors)
            }
            path if path.is_ident("typical") => once(&mut input.typical, typical(&item, errors), path, errors),
            path => errors.push(path, error::INPUT_ATTRIBUTE),
        }
    }
}

/// Fills `slot`, which must be empty.
fn once<T>(slot: &mut Option<T>, value: Option<T>, path: &Path, errors: &mut Errors) {
    if slot.is_some() {
        errors.push(path, error::ATTRIBUTE_TWICE);
    }
    *slot = value;
}

fn typical(item: &Meta, errors: &mut Errors) -> Option<(f64, f64)> {
    let range = ends(item).filter(|(low, high)| 0.0 <= *low && low <= high && high.is_finite());
    if range.is_none() {
        errors.push(item, error::TYPICAL);
    }
    range
}

fn ends(item: &Meta) -> Option<(f64, f64)> {
    let list = item.require_list().ok()?;
    let ends = list.parse_args_with(Punctuated::<LitFloat, Token![,]>::parse_terminated).ok()?;
    let ends = ends.iter().map(|end| end.base10_parse().ok()).collect::<Option<Vec<f64>>>()?;
    match ends[..] {
        [low, high] => Some((low, high)),
        _ => None,
    }
}
