//! The attribute `#[kernel(..)]`: what is known of a kernel besides its code.

use closedform_arith::Precision;
use proc_macro2::{Ident, Span, TokenStream};
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Lit, LitStr, Meta, Path, Token};

use crate::error::{self, Errors};
use crate::example;
use crate::kernel::{self, Certificate, Output, ResultMeta};
use crate::meta::{documentation, items, text};

/// The attribute as written, before the results of the kernel are known.
#[derive(Default)]
pub struct Written {
    texts: Vec<(Path, String)>,
    rules: Vec<String>,
    precision: Precision,
    bounds: Vec<About<f64>>,
    bound_place: Option<Span>,
    certificate: Option<LitStr>,
    results: Vec<About<Described>>,
    example: Option<example::Written>,
}

/// A fact about one result.
struct About<T> {
    /// Where it stands.
    path: Path,
    /// The field, for a kernel that returns a struct.
    field: Option<Ident>,
    fact: T,
}

/// What `result(..)` tells.
#[derive(Default)]
struct Described {
    worksheet: Option<String>,
    unit: Option<String>,
}

/// Reads the attribute.
pub fn parse(attribute: TokenStream, errors: &mut Errors) -> Written {
    let mut written = Written::default();
    let parsed = Punctuated::<Meta, Token![,]>::parse_terminated.parse2(attribute);
    let items = errors.take(parsed).unwrap_or_default();
    for (position, item) in items.iter().enumerate() {
        let named = |key| items.iter().take(position).any(|earlier| earlier.path().is_ident(key));
        if item.path().get_ident().is_some_and(named) {
            errors.push(item.path(), error::ATTRIBUTE_TWICE);
        } else {
            written.read(item, errors);
        }
    }
    written
}

impl Written {
    fn read(&mut self, item: &Meta, errors: &mut Errors) {
        let path = item.path();
        match path.get_ident().map(Ident::to_string).as_deref() {
            Some("family" | "maxima" | "latex" | "source") => {
                self.texts.extend(text(item, errors).map(|text| (path.clone(), text.value())));
            }
            Some("precision") => self.precision = precision(item, errors),
            Some("rules") => self.rules = rules(item, errors),
            Some("bound") => {
                self.bound_place = path.get_ident().map(Ident::span);
                self.bounds = bounds(item, errors);
            }
            Some("certificate") => self.certificate = text(item, errors),
            Some("result") => {
                self.results = vec![About { path: path.clone(), field: None, fact: described(item, errors) }]
            }
            Some("results") => self.results.extend(results(item, errors)),
            Some("example") => self.example = example::parse(item, errors),
            _ => errors.push(path, error::ATTRIBUTE),
        }
    }

    /// Gives every result what was written about it.
    pub fn resolve(
        &self,
        output: &Output,
        kernel: &Ident,
        inputs: usize,
        attributes: &[Attribute],
        errors: &mut Errors,
    ) -> kernel::Meta {
        self.bounds.iter().for_each(|about| about.check(output, errors));
        self.results.iter().for_each(|about| about.check(output, errors));
        let results = match output {
            Output::Value(_) => vec![self.result(kernel, None)],
            Output::Struct { fields, .. } => fields.iter().map(|(field, _)| self.result(field, Some(field))).collect(),
        };
        let example = self.example.as_ref().map(|example| example.of(inputs, results.len(), errors));
        kernel::Meta {
            family: self.text("family"),
            maxima: self.text("maxima"),
            latex: self.text("latex"),
            source: self.text("source"),
            summary: summary(attributes),
            rules: self.rules.clone(),
            precision: self.precision,
            results,
            example,
            bound_place: self.bound_place,
            certificate: self.certificate.as_ref().map(|text| Certificate { text: text.value(), place: text.span() }),
        }
    }

    fn text(&self, key: &str) -> Option<String> {
        self.texts.iter().find(|(path, _)| path.is_ident(key)).map(|(_, text)| text.clone())
    }

    fn result(&self, name: &Ident, field: Option<&Ident>) -> ResultMeta {
        let described = self.results.iter().find(|about| about.field.as_ref() == field).map(|about| &about.fact);
        ResultMeta {
            name: name.clone(),
            worksheet: described.and_then(|described| described.worksheet.clone()),
            unit: described.and_then(|described| described.unit.clone()),
            bound: self.bounds.iter().find(|about| about.field.as_ref() == field).map(|about| about.fact),
        }
    }
}

impl<T> About<T> {
    /// Refuses facts about results that the kernel does not have.
    fn check(&self, output: &Output, errors: &mut Errors) {
        match (output, &self.field) {
            (Output::Value(_), None) => {}
            (Output::Value(_), Some(_)) => errors.push(&self.path, error::FIELD_META_OF_NUMBER),
            (Output::Struct { .. }, None) => errors.push(&self.path, error::NUMBER_META_OF_STRUCT),
            (Output::Struct { fields, .. }, Some(field)) => {
                if !fields.iter().any(|(known, _)| known == field) {
                    errors.push(field, error::UNKNOWN_FIELD);
                }
            }
        }
    }
}

fn precision(item: &Meta, errors: &mut Errors) -> Precision {
    let Some(written) = text(item, errors) else { return Precision::default() };
    let written = written.value();
    Precision::ALL.into_iter().find(|precision| precision.name() == written).unwrap_or_else(|| {
        errors.push(item, error::PRECISION);
        Precision::default()
    })
}

fn rules(item: &Meta, errors: &mut Errors) -> Vec<String> {
    let parsed =
        item.require_list().and_then(|list| list.parse_args_with(Punctuated::<LitStr, Token![,]>::parse_terminated));
    match parsed {
        Ok(rules) => rules.iter().map(LitStr::value).collect(),
        Err(_) => {
            errors.push(item, error::RULES);
            Vec::new()
        }
    }
}

fn bounds(item: &Meta, errors: &mut Errors) -> Vec<About<f64>> {
    match item {
        Meta::NameValue(_) => bound(item, None, errors).into_iter().collect(),
        Meta::List(list) => {
            let fields = items(list, error::BOUND, errors);
            fields.iter().filter_map(|field| bound(field, field.path().get_ident(), errors)).collect()
        }
        Meta::Path(_) => {
            errors.push(item, error::BOUND);
            Vec::new()
        }
    }
}

fn bound(item: &Meta, field: Option<&Ident>, errors: &mut Errors) -> Option<About<f64>> {
    let number = match item {
        Meta::NameValue(pair) => not_negative(&pair.value),
        _ => None,
    };
    if number.is_none() {
        errors.push(item, error::BOUND);
    }
    Some(About { path: item.path().clone(), field: field.cloned(), fact: number? })
}

/// A literal of at least zero, with or without a decimal point.
fn not_negative(value: &Expr) -> Option<f64> {
    let Expr::Lit(ExprLit { lit, .. }) = value else { return None };
    let number: Option<f64> = match lit {
        Lit::Int(int) => int.base10_parse().ok(),
        Lit::Float(float) => float.base10_parse().ok(),
        _ => None,
    };
    number.filter(|number| *number >= 0.0 && number.is_finite())
}

fn results(item: &Meta, errors: &mut Errors) -> Vec<About<Described>> {
    let Meta::List(list) = item else {
        errors.push(item, error::RESULTS);
        return Vec::new();
    };
    let mut results: Vec<About<Described>> = Vec::new();
    for field in items(list, error::RESULTS, errors) {
        let Some(name) = field.path().get_ident().cloned() else {
            errors.push(field, error::RESULTS);
            continue;
        };
        if results.iter().any(|about| about.field.as_ref() == Some(&name)) {
            errors.push(&name, error::FIELD_TWICE);
        }
        let fact = described(&field, errors);
        results.push(About { path: item.path().clone(), field: Some(name), fact });
    }
    results
}

fn described(item: &Meta, errors: &mut Errors) -> Described {
    let mut described = Described::default();
    let Meta::List(list) = item else {
        errors.push(item, error::RESULT);
        return described;
    };
    for fact in items(list, error::RESULT, errors) {
        match fact.path() {
            path if path.is_ident("worksheet") => described.worksheet = text(&fact, errors).map(|text| text.value()),
            path if path.is_ident("unit") => described.unit = text(&fact, errors).map(|text| text.value()),
            path => errors.push(path, error::RESULT),
        }
    }
    described
}

/// The first paragraph of the documentation, in one line, as a page shows it.
fn summary(attributes: &[Attribute]) -> String {
    let documentation = documentation(attributes);
    let paragraph = documentation.lines().map(str::trim).skip_while(|line| line.is_empty());
    without_escapes(&paragraph.take_while(|line| !line.is_empty()).collect::<Vec<_>>().join(" "))
}

/// Markdown without the backslashes that take the meaning of what follows; code has none.
fn without_escapes(text: &str) -> String {
    let (mut shown, mut in_code) = (String::with_capacity(text.len()), false);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let escaped = letters.next_if(|next| letter == '\\' && !in_code && next.is_ascii_punctuation());
        in_code ^= letter == '`';
        shown.push(escaped.unwrap_or(letter));
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_summary_is_what_a_page_shows() {
        assert_eq!(without_escapes(r"v0 = kv0\*x4/t1, s\[1], C:\\ and \\\*"), r"v0 = kv0*x4/t1, s[1], C:\ and \*");
        assert_eq!(without_escapes(r"`a\*b` \` \* \a"), r"`a\*b` ` * \a");
    }
}
