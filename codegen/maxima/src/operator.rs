//! Operators that a text declares, itself or with a package that it loads: `infix("~")`, `prefix("grad")`.
//!
//! What such an operator means is a function of its name: `a ~ b` is read as a call of `~` with `a` and `b`.

use std::rc::Rc;

use num_traits::ToPrimitive;

use crate::grammar::Power;
use crate::token::{MARKS, Token, TokenKind, WORDS};

/// A declared operator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Operator {
    /// How it is written, and the function that it means.
    pub name: String,
    /// Where its operands stand.
    pub form: Form,
    /// How strongly it binds what stands before it.
    pub left: Power,
    /// How strongly it binds what stands after it.
    pub right: Power,
}

/// Where the operands of a declared operator stand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Form {
    /// On both sides.
    Infix,
    /// On both sides and between more of its kind.
    Nary,
    /// Behind it.
    Prefix,
    /// Before it.
    Postfix,
    /// Between it and this closing one.
    Match(String),
    /// Nowhere.
    Nofix,
}

impl Operator {
    /// All that is written of it.
    pub(crate) fn names(&self) -> Vec<String> {
        match &self.form {
            Form::Match(closing) => vec![self.name.clone(), closing.clone()],
            _ => vec![self.name.clone()],
        }
    }
}

/// The functions that declare operators.
const DECLARING: [&str; 6] = ["infix", "nary", "prefix", "postfix", "matchfix", "nofix"];

/// How strongly an operator binds where its declaration does not say it.
const USUAL: Power = 180;

/// An operator of a package: the function that declares it, its name, and how strongly it binds on both sides.
type Known = (&'static str, &'static str, Power, Power);

/// What packages of Maxima declare, by the names under which they are loaded.
const PACKAGES: [(&[&str], &[Known]); 6] = [
    (
        &["vect", "vect.mac"],
        &[
            ("infix", "~", 134, 133),
            ("prefix", "grad", 142, 142),
            ("prefix", "div", 142, 142),
            ("prefix", "curl", 142, 142),
            ("prefix", "laplacian", 142, 142),
        ],
    ),
    (&["ezunits"], &[("infix", "`", 118, 118), ("infix", "``", 117, 117)]),
    (&["cartan", "itensor", "ex_calc"], &[("infix", "~", USUAL, USUAL), ("infix", "|", USUAL, USUAL)]),
    (&["diff_form"], &[("infix", "@", USUAL, USUAL), ("infix", "&", USUAL, USUAL), ("infix", "|", USUAL, USUAL)]),
    (&["coma"], &[("nary", "//", 115, 115), ("infix", "/_", 150, 150), ("postfix", "//_", 20, 20)]),
    (
        &["to_poly_solve", "to_poly_solver"],
        &[("nary", "%and", 65, 65), ("nary", "%or", 60, 60), ("prefix", "%not", 70, 70)],
    ),
];

/// Whether the function of this name declares an operator.
#[must_use]
pub fn declares_operator(name: &str) -> bool {
    DECLARING.contains(&name)
}

/// The operators that a text declares, read from its tokens; the longest names first.
pub(crate) fn declared(tokens: &[Token]) -> Vec<Rc<Operator>> {
    let mut found: Vec<Operator> = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let TokenKind::Symbol(word) = &token.kind else { continue };
        if mark(tokens, at + 1) != Some("(") {
            continue;
        }
        if declares_operator(word) {
            found.extend(declaration(word, tokens, at + 2));
        } else if word == "load" {
            found.extend(name(tokens, at + 2).into_iter().flat_map(of_package));
        }
    }
    found.retain(|operator| is_free(&operator.name));
    found.sort_by_key(|operator| std::cmp::Reverse(operator.name.len()));
    found.dedup_by(|later, first| later.name == first.name && later.form == first.form);
    found.into_iter().map(Rc::new).collect()
}

/// Whether a name means nothing in Maxima, so that it may be declared without changing what other texts mean.
fn is_free(name: &str) -> bool {
    !name.is_empty() && !MARKS.contains(&name) && !WORDS.contains(&name) && !name.contains(char::is_whitespace)
}

fn of_package(name: &str) -> Vec<Operator> {
    let package = PACKAGES.iter().find(|(names, _)| names.contains(&name)).map_or(&[][..], |(_, operators)| operators);
    let operators = package.iter().filter_map(|(word, name, left, right)| {
        Some(Operator { name: (*name).to_owned(), form: form(word, None)?, left: *left, right: *right })
    });
    operators.collect()
}

/// `word("name", left, right)`, from the name on.
fn declaration(word: &str, tokens: &[Token], at: usize) -> Option<Operator> {
    let operator = name(tokens, at)?.to_owned();
    let second = (mark(tokens, at + 1) == Some(",")).then(|| name(tokens, at + 2)).flatten();
    let powers: Vec<Power> = numbers(tokens, at + 1);
    let left = powers.first().copied().unwrap_or(USUAL);
    let right = powers.get(1).copied().unwrap_or(left);
    Some(Operator { name: operator, form: form(word, second)?, left, right })
}

fn form(word: &str, closing: Option<&str>) -> Option<Form> {
    Some(match word {
        "infix" => Form::Infix,
        "nary" => Form::Nary,
        "prefix" => Form::Prefix,
        "postfix" => Form::Postfix,
        "nofix" => Form::Nofix,
        _ => Form::Match(closing?.to_owned()),
    })
}

fn mark(tokens: &[Token], at: usize) -> Option<&'static str> {
    match tokens.get(at)?.kind {
        TokenKind::Mark(mark) => Some(mark),
        _ => None,
    }
}

fn name(tokens: &[Token], at: usize) -> Option<&str> {
    match &tokens.get(at)?.kind {
        TokenKind::String(name) | TokenKind::Symbol(name) => Some(name),
        _ => None,
    }
}

/// The numbers of `, 1, 2`.
fn numbers(tokens: &[Token], at: usize) -> Vec<Power> {
    let mut found = Vec::new();
    let mut at = at;
    while mark(tokens, at) == Some(",")
        && let Some(TokenKind::Integer(value)) = tokens.get(at + 1).map(|token| &token.kind)
    {
        found.extend(value.to_u16().map(|power| power.min(crate::grammar::APPLICATION)));
        at += 2;
    }
    found
}
