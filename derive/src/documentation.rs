//! Documentation: what is added to that of a kernel, and what its structs and their fields say.

use closedform_syntax::{Input, Kernel, ResultMeta};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ext::IdentExt;
use syn::{Attribute, Expr, ExprLit, Lit, Meta};

use crate::{example, mathml};

/// The attributes of a kernel up to the first paragraph of its documentation; its formula, set as mathematics; and its other
/// attributes, with links to its shapes and an example.
pub fn of(kernel: &Kernel) -> (&[Attribute], TokenStream, Vec<TokenStream>) {
    let attributes = &kernel.attributes;
    let first = attributes.iter().position(is_blank_line).unwrap_or(attributes.len());
    let (above, below) = attributes.split_at(first);
    // tags are for pages alone: editors would show them letter by letter
    let formula = kernel.meta.latex.as_deref().and_then(mathml::formulas);
    let formula = formula.map(|formula| quote!(#[cfg_attr(doc, doc = #formula)])).unwrap_or_default();
    let shapes = shapes(&kernel.name);
    let example = kernel.meta.example.as_ref().and_then(|example| example::of(kernel, example));
    let below = below.iter().map(|attribute| quote!(#attribute));
    let added = [Some(shapes), example].into_iter().flatten().map(|text| quote!(#[doc = #text]));
    (above, formula, below.chain(added).collect())
}

fn is_blank_line(attribute: &Attribute) -> bool {
    match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => {
            matches!(&pair.value, Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) if text.value().trim().is_empty())
        }
        _ => false,
    }
}

fn shapes(name: &Ident) -> String {
    let name = name.unraw();
    format!(
        "\n# Shapes\n\nThe module [`{name}`](mod@{name}) has the other shapes of this call: [`Inputs`]({name}::Inputs) and \
         [`Columns`]({name}::Columns)\nby name, [`checked`]({name}::checked), [`faithful`]({name}::faithful), \
         [`fast`]({name}::fast), [`with_bound`]({name}::with_bound), \n[`batch`]({name}::batch), [`rows`]({name}::rows) and more.\n"
    )
}

/// Of the module beside a kernel.
pub fn of_module(name: &Ident) -> String {
    let name = name.unraw();
    format!("[`{name}`](fn@{name}) in its other arithmetics and shapes.")
}

/// Of the struct of inputs, and of that of their columns.
pub fn of_records(name: &Ident) -> (String, String) {
    let name = name.unraw();
    let function = format!("[`{name}`](fn@super::{name})");
    (format!("The inputs of {function}, by name."), format!("The inputs of {function} at many points, a slice each."))
}

/// Of the field of an input.
pub fn of_input(input: &Input) -> String {
    let name = input.name.unraw().to_string();
    let worksheet = input.maxima.as_deref().filter(|maxima| *maxima != name);
    field(input.unit.as_deref(), &input.doc, worksheet)
}

/// Of the field of a result.
pub fn of_result(result: &ResultMeta) -> String {
    field(result.unit.as_deref(), "", result.worksheet.as_deref())
}

/// Unit, meaning, and the name in the worksheet where that is another one.
fn field(unit: Option<&str>, meaning: &str, worksheet: Option<&str>) -> String {
    let unit = unit.filter(|unit| !unit.is_empty() && *unit != "1");
    let quantity = unit.map_or_else(|| "A number".to_owned(), |unit| format!("In {}", plain(unit)));
    let meaning = meaning.trim().trim_end_matches('.');
    let colon = if meaning.is_empty() { "" } else { ": " };
    let worksheet = worksheet.map(|name| format!(" In the worksheet {}.", code(name))).unwrap_or_default();
    format!("{quantity}{colon}{meaning}.{worksheet}")
}

/// A unit as Markdown: code, where it holds what Markdown reads as more.
fn plain(unit: &str) -> String {
    let is_plain = |letter: char| letter.is_alphanumeric() || matches!(letter, ' ' | '/' | '^' | '.' | '-' | '%');
    if unit.chars().all(is_plain) { unit.to_owned() } else { code(unit) }
}

fn code(text: &str) -> String {
    if text.contains('`') { format!("`` {text} ``") } else { format!("`{text}`") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_says_its_unit_its_meaning_and_its_other_name() {
        for (unit, meaning, worksheet, text) in [
            (Some("m/s"), "speed at the end", Some("v1"), "In m/s: speed at the end. In the worksheet `v1`."),
            (Some("1"), " a ratio. ", None, "A number: a ratio."),
            (Some("N*m"), "", None, "In `N*m`."),
            (None, "", None, "A number."),
        ] {
            assert_eq!(field(unit, meaning, worksheet), text);
        }
    }
}
