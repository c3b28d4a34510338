//! Text to tokens.

use std::ops::Range;
use std::rc::Rc;

use winnow::combinator::{alt, fail, not, opt, peek, repeat};
use winnow::error::EmptyError;
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location, Stream};
use winnow::token::{any, literal, none_of, one_of, take_while};

use crate::error::{DIGIT_LIMIT, Error};
use crate::operator::{Operator, declared};
use crate::token::{HIDE, MARKS, Token, TokenKind, WORDS};

type Input<'a> = LocatingSlice<&'a str>;
type Lexed<T> = Result<T, EmptyError>;

/// What stands between the mantissa and the exponent of a number.
const EXPONENT_LETTERS: [char; 12] = ['e', 'E', 'b', 'B', 'd', 'D', 'f', 'F', 's', 'S', 'l', 'L'];

/// What some editors put before a text to say that it is Unicode.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// The tokens of a text, the last one being the end, and everything that is none.
pub(crate) struct Lex {
    /// The tokens.
    pub tokens: Vec<Token>,
    /// What is none.
    pub errors: Vec<Error>,
    /// The operators that the text declares.
    pub operators: Vec<Rc<Operator>>,
}

/// All tokens of `text`, those of operators that it declares included.
pub(crate) fn lex(text: &str) -> Lex {
    let (tokens, errors) = lex_with(text, &[]);
    let operators = declared(&tokens);
    if operators.is_empty() {
        return Lex { tokens, errors, operators };
    }
    let names: Vec<String> = operators.iter().flat_map(|operator| operator.names()).collect();
    let (tokens, errors) = lex_with(text, &names);
    Lex { tokens, errors, operators }
}

/// All tokens, `declared` being operators.
fn lex_with(text: &str, declared: &[String]) -> (Vec<Token>, Vec<Error>) {
    let (mut tokens, mut errors) = (Vec::new(), Vec::new());
    let mut input = Input::new(text);
    let _ = opt(BYTE_ORDER_MARK).parse_next(&mut input) as Lexed<_>;
    loop {
        skip_blank(&mut input);
        let (start, checkpoint) = (input.current_token_start(), input.checkpoint());
        let begins = tokens.last().is_none_or(|token: &Token| matches!(token.kind, TokenKind::Mark(";" | HIDE)));
        let line = lisp_line(text, start).map(|length| (LISP, LISP, length));
        if let Some((mark, function, length)) = line.or_else(|| begins.then(|| question(text, start))?) {
            let argument = &text[start + mark.len()..start + length];
            tokens.extend(call_of_line(function, argument, start..start + length));
            input.next_slice(length);
            continue;
        }
        match token_or(declared).with_span().parse_next(&mut input) {
            Ok((kind, span)) => tokens.push(Token { kind, span }),
            Err(EmptyError) if start == text.len() => break,
            Err(EmptyError) => {
                let error = diagnose(&text[start..], start);
                input.reset(&checkpoint);
                input.next_slice(resume(&error, text.len()) - start);
                errors.push(error);
            }
        }
    }
    tokens.push(Token { kind: TokenKind::End, span: text.len()..text.len() });
    (tokens, errors)
}

/// Length of the line of Lisp that begins here, if one does.
fn lisp_line(text: &str, start: usize) -> Option<usize> {
    let rest = text[start..].strip_prefix(LISP)?;
    let before = text[..start].rsplit('\n').next().unwrap_or_default();
    let is_command = before.trim().is_empty() && rest.starts_with([' ', '\t', '(', '-']);
    is_command.then(|| text[start..].find('\n').unwrap_or(text.len() - start))
}

/// What Maxima hands to Lisp at the start of a line.
const LISP: &str = ":lisp";

/// A line that begins a statement and asks Maxima what a word means: what marks it, what answers it, and its length.
fn question(text: &str, start: usize) -> Option<(&'static str, &'static str, usize)> {
    let rest = &text[start..];
    let mark = ["??", "?"]
        .into_iter()
        .find(|mark| rest.strip_prefix(mark).is_some_and(|topic| topic.starts_with([' ', '\t'])))?;
    Some((mark, "describe", rest.find('\n').unwrap_or(rest.len())))
}

/// A line as a call with a string.
fn call_of_line(function: &str, argument: &str, span: Range<usize>) -> [Token; 5] {
    let argument = TokenKind::String(argument.trim().trim_end_matches([';', '$']).to_owned());
    let function = TokenKind::Symbol(function.to_owned());
    let kinds = [function, TokenKind::Mark("("), argument, TokenKind::Mark(")"), TokenKind::Mark(HIDE)];
    kinds.map(|kind| Token { kind, span: span.clone() })
}

/// Where to go on after an error.
fn resume(error: &Error, end: usize) -> usize {
    match error {
        Error::UnknownCharacter { span, .. } | Error::MalformedNumber { span } | Error::LongNumber { span } => span.end,
        _ => end,
    }
}

fn diagnose(rest: &str, start: usize) -> Error {
    let mut characters = rest.chars();
    let first = characters.next().unwrap_or(' ');
    if rest.starts_with("/*") {
        return Error::UnterminatedComment { span: start..start + 2 };
    }
    match first {
        '"' => Error::UnterminatedString { span: start..start + 1 },
        '.' | '0'..='9' => wrong_number(rest, start),
        _ => Error::UnknownCharacter { character: first, span: start..start + first.len_utf8() },
    }
}

fn wrong_number(rest: &str, start: usize) -> Error {
    let mut input = Input::new(rest);
    match mantissa(&mut input) {
        Ok(mantissa) if mantissa.len() > DIGIT_LIMIT => {
            Error::LongNumber { span: start..start + input.current_token_start() }
        }
        _ => Error::MalformedNumber { span: malformed_number(rest, start) },
    }
}

fn malformed_number(rest: &str, start: usize) -> Range<usize> {
    let mantissa = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
    let letter = rest[mantissa..].chars().next().map_or(0, char::len_utf8);
    let sign = usize::from(rest[mantissa + letter..].starts_with(['+', '-']));
    start..start + mantissa + letter + sign
}

/// A token; the longest name of an operator counts, be it declared or Maxima's own.
fn token_or<'t>(declared: &'t [String]) -> impl FnMut(&mut Input<'t>) -> Lexed<TokenKind> {
    move |input: &mut Input<'t>| {
        let rest: &str = input;
        let longer = |name: &&String| MARKS.iter().all(|mark| mark.len() < name.len() || !rest.starts_with(mark));
        let is_word = |name: &str| name.starts_with(begins_symbol);
        let operator = declared.iter().filter(|name| !is_word(name) && rest.starts_with(name.as_str())).find(longer);
        if let Some(name) = operator {
            let (name, length) = (name.clone(), name.len());
            input.next_slice(length);
            return Ok(TokenKind::Declared(name));
        }
        Ok(match alt((number, string, symbol, mark)).parse_next(input)? {
            TokenKind::Symbol(name) if declared.contains(&name) => TokenKind::Declared(name),
            other => other,
        })
    }
}

fn mark(input: &mut Input) -> Lexed<TokenKind> {
    not(literal("/*")).parse_next(input)?; // a comment that never ends
    for text in MARKS.into_iter().chain([HIDE]) {
        if opt(literal(text)).parse_next(input)?.is_some() {
            return Ok(TokenKind::Mark(text));
        }
    }
    fail.parse_next(input)
}

fn skip_blank(input: &mut Input) {
    let space = take_while(1.., char::is_whitespace).void();
    let blank = alt((space, continuation, comment));
    let all: Lexed<()> = repeat(0.., blank).parse_next(input);
    debug_assert!(all.is_ok(), "blanks may be absent");
}

fn continuation(input: &mut Input) -> Lexed<()> {
    ('\\', opt('\r'), '\n').void().parse_next(input)
}

fn comment(input: &mut Input) -> Lexed<()> {
    literal("/*").parse_next(input)?;
    let mut open = 1_usize;
    while open > 0 {
        let step = alt((literal("/*").value(1), literal("*/").value(-1), any.value(0))).parse_next(input)?;
        open = open.saturating_add_signed(step);
    }
    Ok(())
}

/// Digits, which may go on in the next line; there is one at least.
fn digits(input: &mut Input) -> Lexed<String> {
    let piece = alt((take_while(1.., '0'..='9'), continuation.value("")));
    let digits = repeat(1.., piece).fold(String::new, |all, piece| all + piece);
    digits.verify(|digits: &String| !digits.is_empty()).parse_next(input)
}

fn mantissa(input: &mut Input) -> Lexed<String> {
    if opt('.').parse_next(input)?.is_some() {
        return Ok(format!(".{}", digits(input)?));
    }
    let whole = digits(input)?;
    let point = opt(('.', opt(digits))).parse_next(input)?;
    Ok(match point {
        Some((_, fraction)) => format!("{whole}.{}", fraction.unwrap_or_default()),
        None => whole,
    })
}

fn exponent(input: &mut Input) -> Lexed<String> {
    let letter = one_of(EXPONENT_LETTERS).parse_next(input)?;
    let sign = opt(one_of(['+', '-'])).parse_next(input)?;
    let digits = digits(input)?;
    Ok([letter].into_iter().chain(sign).chain(digits.chars()).collect())
}

fn number(input: &mut Input) -> Lexed<TokenKind> {
    peek(one_of(('0'..='9', '.'))).parse_next(input)?;
    let mantissa = mantissa.verify(|mantissa: &String| mantissa.len() <= DIGIT_LIMIT).parse_next(input)?;
    if opt(peek(one_of(EXPONENT_LETTERS))).parse_next(input)?.is_none() {
        return plain_number(mantissa);
    }
    let text = mantissa + &exponent(input)?;
    let big = text.contains(['b', 'B']);
    Ok(if big { TokenKind::BigFloat(text) } else { TokenKind::Float(text) })
}

/// A number without exponent: in Maxima `2.` is an integer.
fn plain_number(mantissa: String) -> Lexed<TokenKind> {
    let whole = mantissa.strip_suffix('.').unwrap_or(&mantissa);
    if whole.contains('.') {
        return Ok(TokenKind::Float(mantissa));
    }
    whole.parse().map(TokenKind::Integer).map_err(|_| EmptyError)
}

/// A character that a backslash takes out of the grammar.
fn escaped(input: &mut Input) -> Lexed<Option<char>> {
    alt((continuation.value(None), ('\\', any).map(|(_, character)| Some(character)))).parse_next(input)
}

fn string(input: &mut Input) -> Lexed<TokenKind> {
    let piece = alt((escaped, none_of('"').map(Some)));
    let text = repeat(0.., piece).fold(String::new, append);
    let (_, text, _) = ('"', text, '"').parse_next(input)?;
    Ok(TokenKind::String(text))
}

fn symbol(input: &mut Input) -> Lexed<TokenKind> {
    let lisp = opt('?').parse_next(input)?;
    let mut first = alt((one_of(begins_symbol).map(Some), escaped));
    let later = alt((one_of(continues_symbol).map(Some), escaped));
    let start = first.parse_next(input)?;
    let name: String = repeat(0.., later).fold(String::new, append).parse_next(input)?;
    let name: String = lisp.into_iter().chain(start).chain(name.chars()).collect();
    Ok(match WORDS.into_iter().find(|word| *word == name) {
        Some(word) => TokenKind::Mark(word), // even if it has a backslash
        None => TokenKind::Symbol(name),
    })
}

fn append(mut text: String, next: Option<char>) -> String {
    text.extend(next);
    text
}

/// Whether a name can begin with the character without a backslash.
pub(crate) fn begins_symbol(character: char) -> bool {
    character.is_alphabetic() || matches!(character, '_' | '%') || is_letter_to_maxima(character)
}

/// Marks of letters, digits and letters below the line, pictures. Maxima takes all that is not ASCII for letters, also what
/// looks like an operator or exponent and is meant as one: that is told instead.
fn is_letter_to_maxima(character: char) -> bool {
    matches!(character,
        '\u{300}'..='\u{36f}' | '\u{2080}'..='\u{2089}' | '\u{20d0}'..='\u{20f0}' | '\u{2600}'..='\u{27bf}'
        | '\u{fe0e}' | '\u{fe0f}' | '\u{1f000}'..='\u{1faff}')
}

/// Whether a name can go on with the character without a backslash.
pub(crate) fn continues_symbol(character: char) -> bool {
    begins_symbol(character) || character.is_ascii_digit()
}
