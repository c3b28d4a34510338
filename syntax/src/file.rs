//! Source files: every kernel in them, wherever it stands.
//!
//! Kernels are looked for among the tokens: so they are found in modules, in functions and in what macros are given,
//! and whatever else a file holds need not be read. Nothing here recurses into the nesting of the source.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::borrow::Cow;
use std::str::FromStr;
use syn::{Attribute, ItemFn, Meta, Result};

use crate::error::{self, Errors};
use crate::kernel::Kernel;
use crate::limits;

/// What is said of a text that cannot be cut into tokens.
const NO_TOKENS: &str = "not Rust: here begins what is never closed, or what no token begins with";

/// A function under `#[kernel]`, not yet read as a kernel.
#[derive(Clone)]
pub struct Source {
    /// `#[kernel]` or `#[closedform::kernel]`, with arguments or without.
    pub attribute: Attribute,
    /// The function, without that attribute.
    pub function: ItemFn,
}

impl Source {
    /// The kernel.
    ///
    /// # Errors
    ///
    /// Everything in it that is not kernel language.
    pub fn parse(self) -> Result<Kernel> {
        crate::parse(arguments(self.attribute), self.function)
    }
}

/// Every function under `#[kernel]` in a Rust source file, in order, or why it is no function that can be read. What
/// holds a `$` is the template of a macro and left out.
///
/// # Errors
///
/// What keeps the text from being tokens of Rust.
pub fn sources(text: &str) -> Result<Vec<Result<Source>>> {
    let mut sources = Vec::new();
    let mut around: Vec<(Vec<TokenTree>, usize)> = Vec::new();
    let (mut tokens, mut at) = (listed(tokens_of(text)?), 0);
    loop {
        let Some(token) = tokens.get(at) else {
            let Some(outer) = around.pop() else { return Ok(sources) };
            (tokens, at) = outer;
            continue;
        };
        let attributes = attributes(&tokens[at..]);
        if let TokenTree::Group(group) = token {
            let inner = listed(group.stream());
            around.push((std::mem::replace(&mut tokens, inner), at + 1));
            at = 0;
        } else if attributes.is_empty() {
            at += 1;
        } else {
            let function = function(&tokens[at + 2 * attributes.len()..]).filter(|_| attributes.iter().any(is_kernel));
            let length = 2 * attributes.len() + function.unwrap_or(0);
            let item = &tokens[at..at + length];
            if function.is_some() && !is_template(item) {
                sources.push(source(item.iter().cloned().collect()));
            }
            at += length;
        }
    }
}

/// Every kernel in a Rust source file, in order.
///
/// # Errors
///
/// Everything in any of them that is not kernel language, or what keeps the text from being tokens of Rust.
pub fn parse_file(text: &str) -> Result<Vec<Kernel>> {
    let mut errors = Errors::default();
    let kernels = sources(text)?.into_iter().filter_map(|source| errors.take(source.and_then(Source::parse))).collect();
    errors.finish()?;
    Ok(kernels)
}

fn tokens_of(text: &str) -> Result<TokenStream> {
    let text = without_shebang(text);
    TokenStream::from_str(&text).map_err(|error| syn::Error::new(error.span(), NO_TOKENS))
}

fn source(item: TokenStream) -> Result<Source> {
    limits::check(item.clone())?;
    let mut function: ItemFn = syn::parse2(item)?;
    let is_kernel = |attribute: &Attribute| is_kernel_path(&path_of(attribute));
    match function.attrs.iter().position(is_kernel) {
        Some(position) => Ok(Source { attribute: function.attrs.remove(position), function }),
        None => Err(syn::Error::new_spanned(&function.sig, error::UNREADABLE)),
    }
}

fn listed(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}

/// A first line for the shell is no Rust, and becomes a comment of the same length; inner attributes begin alike.
fn without_shebang(text: &str) -> Cow<'_, str> {
    let mark = text.len() - text.trim_start_matches('\u{feff}').len();
    let (before, rest) = text.split_at(mark);
    match rest.strip_prefix("#!") {
        Some(line) if !line.trim_start().starts_with('[') => format!("{before}//{line}").into(),
        _ => text.into(),
    }
}

/// What stands in the brackets of the attributes at the beginning of these tokens.
fn attributes(tokens: &[TokenTree]) -> Vec<&Group> {
    let attribute = |pair: &'_ [TokenTree]| match pair {
        [TokenTree::Punct(sign), TokenTree::Group(group)] => {
            sign.as_char() == '#' && group.delimiter() == Delimiter::Bracket
        }
        _ => false,
    };
    let pairs = tokens.chunks(2).take_while(|pair| attribute(pair));
    pairs.filter_map(|pair| if let TokenTree::Group(group) = &pair[1] { Some(group) } else { None }).collect()
}

/// How many tokens a function takes at the beginning of these, its body included; `None` of any other item.
fn function(tokens: &[TokenTree]) -> Option<usize> {
    let is_end = |token: &TokenTree| match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(sign) => sign.as_char() == ';',
        _ => false,
    };
    let end = tokens.iter().position(is_end)?;
    let is_function = tokens[..end].iter().any(|token| matches!(token, TokenTree::Ident(word) if word == "fn"));
    (is_function && matches!(tokens[end], TokenTree::Group(_))).then_some(end + 1)
}

/// Whether a macro puts something in for what begins with `$`.
fn is_template(tokens: &[TokenTree]) -> bool {
    let mut left: Vec<TokenTree> = tokens.to_vec();
    while let Some(token) = left.pop() {
        match token {
            TokenTree::Punct(sign) if sign.as_char() == '$' => return true,
            TokenTree::Group(group) => left.extend(group.stream()),
            _ => {}
        }
    }
    false
}

fn is_kernel(attribute: &&Group) -> bool {
    let words = attribute.stream().into_iter().map_while(|token| match token {
        TokenTree::Ident(word) => Some(word.to_string()),
        TokenTree::Punct(sign) if sign.as_char() == ':' => Some(String::new()),
        _ => None,
    });
    is_kernel_path(&words.filter(|word| !word.is_empty()).collect::<Vec<_>>())
}

fn path_of(attribute: &Attribute) -> Vec<String> {
    attribute.path().segments.iter().map(|segment| segment.ident.to_string()).collect()
}

/// `kernel` or `closedform::kernel`
fn is_kernel_path(path: &[String]) -> bool {
    path.last().is_some_and(|word| word == "kernel")
}

fn arguments(attribute: Attribute) -> TokenStream {
    match attribute.meta {
        Meta::List(list) => list.tokens,
        _ => TokenStream::new(),
    }
}
