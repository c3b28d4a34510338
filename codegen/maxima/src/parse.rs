//! Tokens to expressions and statements.

mod cursor;
mod expression;

use crate::ast::{Expr, ExprKind, Statement, Terminator};
use crate::error::{Error, Errors};
use crate::grammar::COMMA;
use crate::lex::{Lex, lex};
use crate::token::{HIDE, TokenKind};

use cursor::Cursor;
use expression::{expression, list};

/// How many brackets, prefix operators and powers may stand inside each other.
pub const NESTING_LIMIT: usize = 256;

/// How high a tree may be: mostly, how many terms a sum may have.
pub const HEIGHT_LIMIT: usize = 1024;

/// The one expression that `text` is, without terminator.
///
/// # Errors
///
/// The first thing that is wrong with the text.
pub fn parse_expression(text: &str) -> Result<Expr, Error> {
    let Lex { tokens, errors, operators } = lex(text);
    if let Some(error) = errors.into_iter().next() {
        return Err(error);
    }
    let mut cursor = Cursor::new(&tokens, &operators);
    let expression = top(&mut cursor)?;
    match cursor.kind() {
        TokenKind::End => Ok(expression),
        _ => Err(cursor.unexpected("an operator or the end")),
    }
}

/// The statements of a worksheet.
///
/// # Errors
///
/// Everything that is wrong with the text: after a mistake parsing goes on with the next statement.
pub fn parse_statements(text: &str) -> Result<Vec<Statement>, Errors> {
    let (statements, errors) = parse_what_can_be(text);
    if errors.is_empty() { Ok(statements) } else { Err(Errors { errors }) }
}

/// The statements of a worksheet that are right, and everything that is wrong with the others, in the order of the text.
#[must_use]
pub fn parse_what_can_be(text: &str) -> (Vec<Statement>, Vec<Error>) {
    let Lex { tokens, mut errors, operators } = lex(text);
    let mut unknown = errors.iter().map(|error| error.span().start).collect::<Vec<_>>().into_iter().peekable();
    let (mut cursor, mut statements) = (Cursor::new(&tokens, &operators), Vec::new());
    while *cursor.kind() != TokenKind::End {
        let read = statement(&mut cursor, text);
        if read.is_err() {
            cursor.skip_statement();
        }
        // what follows from a character or word that is no Maxima is not told besides
        let mut is_torn = false;
        let ends = read.is_err() && *cursor.kind() == TokenKind::End;
        while unknown.next_if(|place| *place < cursor.end_of_previous() || ends).is_some() {
            is_torn = true;
        }
        match read {
            _ if is_torn => {}
            Ok(statement) => statements.push(statement),
            Err(error) => errors.push(error),
        }
    }
    errors.sort_by_key(|error| error.span().start);
    (statements, errors)
}

fn statement(cursor: &mut Cursor, text: &str) -> Result<Statement, Error> {
    let label = label(cursor);
    let expression = top(cursor)?;
    let terminator = match cursor.kind() {
        TokenKind::Mark(";") => Terminator::Show,
        TokenKind::Mark(HIDE) => Terminator::Hide,
        TokenKind::End => return Err(Error::MissingTerminator { span: expression.span }),
        _ if text[expression.span.end..cursor.span().start].contains('\n') => {
            return Err(Error::MissingTerminator { span: expression.span });
        }
        _ => return Err(cursor.unexpected("an operator, `;` or `$`")),
    };
    cursor.advance();
    Ok(Statement { label, expression, terminator })
}

/// An expression, or `expression, option, ..`.
fn top(cursor: &mut Cursor) -> Result<Expr, Error> {
    let first = expression(cursor, COMMA)?.expression;
    if !cursor.take(",") {
        return Ok(first);
    }
    let (options, _) = list(cursor)?;
    let span = first.span.start..cursor.end_of_previous();
    Ok(Expr::new(ExprKind::Ev { expression: Box::new(first), options }, span))
}

/// `(%i12)` before the expression that it labels.
fn label(cursor: &mut Cursor) -> Option<String> {
    let [TokenKind::Mark("("), TokenKind::Symbol(name), TokenKind::Mark(")"), next] = cursor.look_ahead()? else {
        return None;
    };
    let number = name.strip_prefix("%i").or_else(|| name.strip_prefix("%o")).or_else(|| name.strip_prefix("%t"))?;
    let numbered = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    if !numbered || !begins_expression(next) {
        return None;
    }
    let name = name.clone();
    (0..3).for_each(|_| cursor.advance());
    Some(name)
}

/// Whether a label may stand before the token, which then cannot go on an expression.
fn begins_expression(kind: &TokenKind) -> bool {
    match kind {
        TokenKind::Mark(mark) => matches!(*mark, "if" | "for" | "while" | "unless" | "do" | "not" | "{" | "'" | "''"),
        TokenKind::End => false,
        _ => true,
    }
}
