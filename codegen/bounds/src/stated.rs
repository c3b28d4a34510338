//! Stated bounds in Rust text: the keys `bound` and `certificate` of an attribute, and nothing else, edited in place.

use crate::Keys;
use closedform_syntax::{Kernel, Source, sources};
use std::ops::Range;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Attribute, Meta, MetaList, Token};

/// What takes the place of some bytes of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    bytes: Range<usize>,
    text: String,
}

/// A text after its edits, which do not overlap.
#[must_use]
pub fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|edit| edit.bytes.start);
    let mut edited = text.to_owned();
    for Edit { bytes, text } in edits.into_iter().rev() {
        edited.replace_range(bytes, &text);
    }
    edited
}

/// A text whose kernels carry the certificates of the bounds that they state.
#[must_use]
pub fn with_certificates(text: &str) -> String {
    let sources = sources(text).unwrap_or_default().into_iter().flatten();
    let edits = sources.filter_map(|source| Some((source.attribute.clone(), stated_keys(source)?)));
    edited(text, edits.flat_map(|(attribute, keys)| enter(text, &attribute, &keys)).collect())
}

/// The keys of the bounds that a kernel states, if it states all of them.
fn stated_keys(source: Source) -> Option<Keys> {
    let kernel: Kernel = source.parse().ok()?;
    let bounds: Option<Vec<f64>> = kernel.meta.results.iter().map(|result| result.bound).collect();
    Some(Keys::of(&kernel, &bounds?))
}

/// The edits by which an attribute gets these keys.
#[must_use]
pub fn enter(text: &str, attribute: &Attribute, keys: &Keys) -> Vec<Edit> {
    let all = items(attribute);
    let (bound, certificate) = (named(&all, "bound"), named(&all, "certificate"));
    match (bound, certificate, all.last()) {
        (Some(bound), Some(certificate), _) => {
            vec![
                Edit { bytes: bytes(bound), text: keys.bound.clone() },
                Edit { bytes: bytes(certificate), text: keys.certificate.clone() },
            ]
        }
        (Some(one), None, _) | (None, Some(one), _) => {
            let both = [&keys.bound[..], &keys.certificate].join(&separator(text, one));
            vec![Edit { bytes: bytes(one), text: both }]
        }
        (None, None, Some(last)) => {
            let added = ["", &keys.bound, &keys.certificate].join(&separator(text, last));
            vec![insertion(bytes(last).end, added)]
        }
        (None, None, None) => enter_alone(attribute, keys),
    }
}

/// The edits by which an attribute without arguments gets these.
fn enter_alone(attribute: &Attribute, keys: &Keys) -> Vec<Edit> {
    match &attribute.meta {
        Meta::Path(path) => vec![insertion(path.span().byte_range().end, format!("({keys})"))],
        Meta::List(list) => vec![insertion(closing(list).start, keys.to_string())],
        Meta::NameValue(_) => Vec::new(),
    }
}

/// The edits by which an attribute loses its bound and its certificate.
#[must_use]
pub fn take_out(text: &str, attribute: &Attribute) -> Vec<Edit> {
    let Meta::List(list) = &attribute.meta else { return Vec::new() };
    let all = items(attribute);
    let goes = |item: &Meta| ["bound", "certificate"].iter().any(|key| item.path().is_ident(key));
    let Some(last) = all.iter().rposition(|item| !goes(item)) else {
        let arguments = list.path.span().byte_range().end..closing(list).end;
        return vec![Edit { bytes: arguments, text: String::new() }];
    };
    let before = all[..=last].windows(2).filter(|pair| goes(&pair[0]));
    let before = before.map(|pair| up_to(text, bytes(&pair[0]), bytes(&pair[1]).start));
    let after = all[last + 1..].first().zip(all.last()).map(|(first, end)| {
        let (kept, gone) = (bytes(&all[last]).end, bytes(first).start..bytes(end).end);
        if is_comma(text, kept..gone.start) {
            kept..gone.end
        } else {
            with_line(text, gone.start..after_comma(text, gone.end))
        }
    });
    before.chain(after).map(|bytes| Edit { bytes, text: String::new() }).collect()
}

/// An item and what separates it from the next one, whose comments stay.
fn up_to(text: &str, item: Range<usize>, next: usize) -> Range<usize> {
    if is_comma(text, item.end..next) {
        item.start..next
    } else {
        with_line(text, item.start..after_comma(text, item.end))
    }
}

/// These bytes, with their line if nothing else is in it.
fn with_line(text: &str, bytes: Range<usize>) -> Range<usize> {
    let (before, after) = (text.get(..bytes.start).unwrap_or_default(), text.get(bytes.end..).unwrap_or_default());
    let line = before.rfind('\n').map(|end| end + 1).filter(|line| before[*line..].trim().is_empty());
    let rest = after.find('\n').map(|end| end + 1).filter(|end| after[..*end].trim().is_empty());
    line.zip(rest).map_or(bytes.clone(), |(line, rest)| line..bytes.end + rest)
}

fn is_comma(text: &str, between: Range<usize>) -> bool {
    text.get(between).is_some_and(|between| between.trim() == ",")
}

/// The end of the comma that follows, if one does.
fn after_comma(text: &str, end: usize) -> usize {
    let rest = text.get(end..).unwrap_or_default();
    let comma = rest.trim_start().starts_with(',');
    if comma { end + rest.len() - rest.trim_start().len() + 1 } else { end }
}

fn insertion(at: usize, text: String) -> Edit {
    Edit { bytes: at..at, text }
}

fn items(attribute: &Attribute) -> Vec<Meta> {
    let Meta::List(list) = &attribute.meta else { return Vec::new() };
    let parsed = Punctuated::<Meta, Token![,]>::parse_terminated.parse2(list.tokens.clone());
    parsed.map(|items| items.into_iter().collect()).unwrap_or_default()
}

fn named<'a>(items: &'a [Meta], key: &str) -> Option<&'a Meta> {
    items.iter().find(|item| item.path().is_ident(key))
}

fn bytes(item: &Meta) -> Range<usize> {
    item.span().byte_range()
}

fn closing(list: &MetaList) -> Range<usize> {
    list.delimiter.span().close().byte_range()
}

/// What stands between an item and the next one: a new line where the item begins one.
fn separator(text: &str, item: &Meta) -> String {
    let before = text.get(..bytes(item).start).unwrap_or_default();
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    let (above, indent) = before.split_at(line);
    let starts_its_line = line > 0 && indent.chars().all(char::is_whitespace);
    match starts_its_line {
        true if above.ends_with("\r\n") => format!(",\r\n{indent}"),
        true => format!(",\n{indent}"),
        false => ", ".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KEYS: [&str; 2] = ["bound = 2.0", "certificate = \"1-2\""];

    fn keys() -> Keys {
        let [bound, certificate] = KEYS.map(str::to_owned);
        Keys { bound, certificate }
    }

    fn attribute(text: &str) -> Attribute {
        sources(text).unwrap().remove(0).unwrap().attribute
    }

    fn entered(attribute_text: &str) -> String {
        let text = format!("// ä\n{attribute_text}\npub fn f(x: f64) -> f64 {{ x }} // end\n");
        let edited = edited(&text, enter(&text, &attribute(&text), &keys()));
        let (head, tail) = edited.split_once("\npub").unwrap();
        assert_eq!(tail, " fn f(x: f64) -> f64 { x } // end\n");
        head.strip_prefix("// ä\n").unwrap().to_owned()
    }

    fn left(attribute_text: &str) -> String {
        let text = format!("{attribute_text} fn f(x: f64) -> f64 {{ x }}");
        edited(&text, take_out(&text, &attribute(&text))).replace(" fn f(x: f64) -> f64 { x }", "")
    }

    #[test]
    fn keys_are_entered_and_the_rest_stays() {
        let both = KEYS.join(", ");
        let cases = [
            ("#[kernel]", format!("#[kernel({both})]")),
            ("#[closedform::kernel ()]", format!("#[closedform::kernel ({both})]")),
            ("#[kernel(family = \"ü\")]", format!("#[kernel(family = \"ü\", {both})]")),
            ("#[kernel( latex = \"a\" , )]", format!("#[kernel( latex = \"a\", {both} , )]")),
            ("#[kernel(bound=9, latex=\"a\")]", format!("#[kernel({both}, latex=\"a\")]")),
            ("#[kernel(certificate = \"0\")]", format!("#[kernel({both})]")),
            ("#[kernel(certificate = \"0\", bound = 1)]", "#[kernel(certificate = \"1-2\", bound = 2.0)]".to_owned()),
            ("#[kernel(\n  bound(a = 1),\n)]", format!("#[kernel(\n  {},\n)]", KEYS.join(",\n  "))),
            (
                "#[kernel(\r\n\tlatex = \"a\"\r\n)]",
                format!("#[kernel(\r\n\tlatex = \"a\",\r\n\t{}\r\n)]", KEYS.join(",\r\n\t")),
            ),
        ];
        for (before, after) in cases {
            assert_eq!(entered(before), after, "{before}");
        }
    }

    #[test]
    fn keys_are_taken_out_and_the_rest_stays() {
        let cases = [
            ("#[kernel(bound = 1, certificate = \"0\")]", "#[kernel]"),
            ("#[kernel(latex = \"a\", bound = 1, certificate = \"0\",)]", "#[kernel(latex = \"a\",)]"),
            ("#[kernel(bound(a = 1), latex = \"a\")]", "#[kernel(latex = \"a\")]"),
            (
                "#[kernel(\n    bound = 1,\n    certificate = \"0\",\n    latex = \"a\"\n)]",
                "#[kernel(\n    latex = \"a\"\n)]",
            ),
            ("#[kernel(latex = \"a\", // first\n bound = 1, )]", "#[kernel(latex = \"a\", // first\n  )]"),
            ("#[kernel(\n  latex = \"a\", // first\n  bound = 1,\n)]", "#[kernel(\n  latex = \"a\", // first\n)]"),
            ("#[kernel(bound = 1, // first\n latex = \"a\")]", "#[kernel( // first\n latex = \"a\")]"),
            ("#[kernel(source = \"a\")]", "#[kernel(source = \"a\")]"),
            ("#[kernel]", "#[kernel]"),
        ];
        for (before, after) in cases {
            assert_eq!(left(before), after, "{before}");
        }
    }

    #[test]
    fn shebangs_and_marks_of_byte_order_move_nothing() {
        for first in ["#!/usr/bin/env rust\n", "\u{feff}", "\u{feff}#!/usr/bin/env rust\r\n"] {
            let text = format!("{first}#[kernel] fn f(x: f64) -> f64 {{ x }}");
            let expected = format!("{first}#[kernel({})] fn f(x: f64) -> f64 {{ x }}", keys());
            assert_eq!(edited(&text, enter(&text, &attribute(&text), &keys())), expected);
        }
    }

    #[test]
    fn certificates_are_those_of_the_stated_bounds() {
        let text = "#[kernel(bound = 0.5)]\nfn f(x: f64) -> f64 { 3.0 * x }\n#[kernel]\nfn g(x: f64) -> f64 { x }\n";
        let certified = with_certificates(text);
        assert!(
            closedform_syntax::parse_file(&certified).unwrap().iter().all(|k| closedform_syntax::certified(k).is_ok())
        );
        assert_eq!(with_certificates(&certified), certified);
        assert!(certified.ends_with("#[kernel]\nfn g(x: f64) -> f64 { x }\n"), "{certified}");
    }
}
