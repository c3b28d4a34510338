//! Expressions by precedence climbing, with Maxima's binding powers.

use std::ops::Range;

use crate::ast::{BinaryOperator, Branch, Expr, ExprKind, LoopClause, LoopWord, Quoting, UnaryOperator};
use crate::error::Error;
use crate::grammar::{APPLICATION, BODY, COMMA, CONDITION, DELIMITER, Mode, POSTFIX, Power, QUOTE};
use crate::operator::{Form, Operator};
use crate::token::TokenKind;

use super::HEIGHT_LIMIT;
use super::cursor::Cursor;

/// An expression with what its surroundings must know of it.
pub(super) struct Parsed {
    /// The expression.
    pub expression: Expr,
    mode: Mode,
    height: usize,
}

impl Parsed {
    fn leaf(kind: ExprKind, span: Range<usize>) -> Self {
        Self { expression: Expr::new(kind, span), mode: Mode::Any, height: 1 }
    }

    fn boxed(self) -> Box<Expr> {
        Box::new(self.expression)
    }
}

type Result<T> = std::result::Result<T, Error>;

/// An expression whose operators bind tighter than `power`.
pub(super) fn expression(cursor: &mut Cursor, power: Power) -> Result<Parsed> {
    operand(cursor, power, Mode::Any, "")
}

/// As `expression`, where `operator` takes nothing but what `wanted` says.
fn operand(cursor: &mut Cursor, power: Power, wanted: Mode, operator: &'static str) -> Result<Parsed> {
    cursor.descend()?;
    let mut left = begin(cursor)?;
    while power < power_here(cursor) {
        left = go_on(cursor, left)?;
    }
    check_mode(&left, wanted, operator)?;
    cursor.ascend();
    Ok(left)
}

/// Elements up to what is no comma, and the height of the highest.
pub(super) fn list(cursor: &mut Cursor) -> Result<(Vec<Expr>, usize)> {
    let (mut elements, mut height) = (Vec::new(), 0);
    loop {
        let element = expression(cursor, COMMA)?;
        height = height.max(element.height);
        elements.push(element.expression);
        if !cursor.take(",") {
            return Ok((elements, height));
        }
    }
}

fn check_mode(parsed: &Parsed, wanted: Mode, operator: &'static str) -> Result<()> {
    if parsed.mode.fits(wanted) {
        return Ok(());
    }
    let needs = if wanted == Mode::Logical { "a condition" } else { "a quantity" };
    Err(Error::OperandMode { operator, needs, span: parsed.expression.span.clone() })
}

fn is_loop_word(mark: &str) -> bool {
    mark == "do" || LoopWord::reserved(mark).is_some()
}

/// How strongly the token here binds the expression before it.
fn power_here(cursor: &Cursor) -> Power {
    if let Some(operator) = cursor.declared(false) {
        return operator.left;
    }
    match cursor.mark() {
        Some("(" | "[") => APPLICATION,
        Some("!" | "!!") => POSTFIX,
        Some(mark) if is_loop_word(mark) => BODY, // so `thru a:b do` is wrong, as in Maxima
        Some(mark) => BinaryOperator::infix(mark).map_or(DELIMITER, BinaryOperator::left_power),
        None => DELIMITER,
    }
}

/// `kind` from `start` to here, over parts of at most `height`.
fn node(cursor: &Cursor, start: usize, kind: ExprKind, mode: Mode, height: usize) -> Result<Parsed> {
    let span = start..cursor.end_of_previous();
    if height >= HEIGHT_LIMIT {
        return Err(Error::TooLong { span: span.end.saturating_sub(1)..span.end });
    }
    Ok(Parsed { expression: Expr::new(kind, span), mode, height: height + 1 })
}

/// What an expression can begin with.
fn begin(cursor: &mut Cursor) -> Result<Parsed> {
    let span = cursor.span();
    let kind = match cursor.kind().clone() {
        TokenKind::Integer(value) => ExprKind::Integer(value),
        TokenKind::Float(text) => ExprKind::Float(text),
        TokenKind::BigFloat(text) => ExprKind::BigFloat(text),
        TokenKind::String(text) => ExprKind::String(text),
        TokenKind::Symbol(name) => ExprKind::Symbol(name),
        TokenKind::Mark(mark) => return begin_with_mark(cursor, mark),
        TokenKind::Declared(name) => return begin_with_declared(cursor, name),
        TokenKind::End => return Err(cursor.no_expression()),
    };
    cursor.advance();
    Ok(Parsed::leaf(kind, span))
}

fn begin_with_mark(cursor: &mut Cursor, mark: &'static str) -> Result<Parsed> {
    match mark {
        "(" => sequence(cursor),
        "[" => collection(cursor, "[", "]", ExprKind::List),
        "{" => collection(cursor, "{", "}", ExprKind::Set),
        "'" | "''" => quote(cursor, mark),
        "if" => condition(cursor),
        _ if is_loop_word(mark) => repetition(cursor),
        _ => match UnaryOperator::prefix(mark) {
            Some(operator) => prefix(cursor, operator),
            None => Err(cursor.no_expression()),
        },
    }
}

/// A declared operator before its operands; any other one is a name.
fn begin_with_declared(cursor: &mut Cursor, name: String) -> Result<Parsed> {
    let (start, operator) = (cursor.span().start, cursor.declared(true));
    cursor.advance();
    let Some(operator) = operator else {
        return Ok(Parsed::leaf(ExprKind::Symbol(name), start..cursor.end_of_previous()));
    };
    let (operands, height) = match &operator.form {
        Form::Prefix => {
            let inner = expression(cursor, operator.right)?;
            (vec![inner.expression], inner.height)
        }
        Form::Match(closing) => {
            let operands = list(cursor)?;
            if !cursor.take_declared(closing) {
                return Err(cursor.unexpected("the closing operator"));
            }
            operands
        }
        _ => (Vec::new(), 0),
    };
    called(cursor, start, &operator.name, operands, height)
}

/// A declared operator behind or between its operands.
fn go_on_with_declared(cursor: &mut Cursor, left: Parsed, operator: &Operator) -> Result<Parsed> {
    let (start, mut height) = (left.expression.span.start, left.height);
    let mut operands = vec![left.expression];
    cursor.advance();
    if operator.form != Form::Postfix {
        loop {
            let right = expression(cursor, operator.right)?;
            height = height.max(right.height);
            operands.push(right.expression);
            if operator.form != Form::Nary || !cursor.take_declared(&operator.name) {
                break;
            }
        }
    }
    called(cursor, start, &operator.name, operands, height)
}

/// A call of the function that a declared operator means.
fn called(cursor: &Cursor, start: usize, name: &str, arguments: Vec<Expr>, height: usize) -> Result<Parsed> {
    let function = Expr::new(ExprKind::Symbol(name.to_owned()), start..cursor.end_of_previous());
    node(cursor, start, ExprKind::Call { function: Box::new(function), arguments }, Mode::Any, height)
}

fn prefix(cursor: &mut Cursor, operator: UnaryOperator) -> Result<Parsed> {
    let start = cursor.span().start;
    cursor.advance();
    let inner = operand(cursor, operator.power(), operator.mode(), operator.symbol())?;
    let height = inner.height;
    node(cursor, start, ExprKind::Unary { operator, operand: inner.boxed() }, operator.mode(), height)
}

/// The elements between brackets, the opening one of which is here.
fn bracketed(cursor: &mut Cursor, bracket: &'static str, closing: &'static str) -> Result<(Vec<Expr>, usize)> {
    let open = cursor.span();
    cursor.advance();
    if cursor.take(closing) {
        return Ok((Vec::new(), 0));
    }
    let unclosed = |span| Error::UnclosedBracket { bracket, closing, open: open.clone(), span };
    if cursor.ends_statement() {
        return Err(unclosed(cursor.span()));
    }
    let elements = list(cursor)?;
    match cursor.mark() {
        Some(mark) if mark == closing => cursor.advance(),
        Some(")" | "]" | "}") => return Err(unclosed(cursor.span())),
        _ if cursor.ends_statement() => return Err(unclosed(cursor.span())),
        _ => return Err(cursor.unexpected("an operator, `,` or the closing bracket")),
    }
    Ok(elements)
}

/// The error that there is nothing between brackets.
fn empty(expected: &'static str, span: Range<usize>) -> Error {
    Error::UnexpectedToken { found: "nothing".into(), expected, span }
}

fn collection(
    cursor: &mut Cursor,
    bracket: &'static str,
    closing: &'static str,
    kind: fn(Vec<Expr>) -> ExprKind,
) -> Result<Parsed> {
    let start = cursor.span().start;
    let (elements, height) = bracketed(cursor, bracket, closing)?;
    node(cursor, start, kind(elements), Mode::Any, height)
}

/// `(a)`, which is `a` and may stand everywhere, or `(a,b)`.
fn sequence(cursor: &mut Cursor) -> Result<Parsed> {
    let open = cursor.span();
    let (mut elements, height) = bracketed(cursor, "(", ")")?;
    if elements.len() > 1 {
        return node(cursor, open.start, ExprKind::Sequence(elements), Mode::Any, height);
    }
    let span = open.start..cursor.end_of_previous();
    let only = elements.pop().ok_or_else(|| empty("an expression between the parentheses", span.clone()))?;
    Ok(Parsed { expression: Expr::new(only.kind, span), mode: Mode::Any, height })
}

fn quote(cursor: &mut Cursor, mark: &str) -> Result<Parsed> {
    let start = cursor.span().start;
    cursor.advance();
    let quoting = match (mark, cursor.mark()) {
        ("'", Some("(")) => Quoting::Expression,
        ("'", _) => Quoting::Noun,
        (_, Some("(")) => Quoting::Value,
        _ => Quoting::Verb,
    };
    let inner = expression(cursor, QUOTE)?;
    let height = inner.height;
    node(cursor, start, ExprKind::Quote { quoting, expression: inner.boxed() }, Mode::Any, height)
}

fn condition(cursor: &mut Cursor) -> Result<Parsed> {
    let start = cursor.span().start;
    let (mut branches, mut height, mut word) = (Vec::new(), 0, "if");
    while cursor.take(word) {
        let condition = operand(cursor, CONDITION, Mode::Logical, word)?;
        if !cursor.take("then") {
            return Err(cursor.unexpected("`then`"));
        }
        let value = expression(cursor, BODY)?;
        height = height.max(condition.height).max(value.height);
        branches.push(Branch { condition: condition.expression, value: value.expression });
        word = "elseif";
    }
    let otherwise = if cursor.take("else") { Some(expression(cursor, BODY)?) } else { None };
    height = otherwise.as_ref().map_or(height, |parsed| height.max(parsed.height));
    let kind = ExprKind::If { branches, otherwise: otherwise.map(Parsed::boxed) };
    node(cursor, start, kind, Mode::Any, height)
}

fn repetition(cursor: &mut Cursor) -> Result<Parsed> {
    let start = cursor.span().start;
    let (mut clauses, mut height) = (Vec::new(), 0);
    let mut words = LoopWords::default();
    while !cursor.take("do") {
        let word = words.next(cursor)?;
        cursor.advance();
        let value = operand(cursor, word.power(), word.mode(), word.symbol())?;
        if word == LoopWord::For && value.expression.as_symbol().is_none() {
            let (expected, span) = ("a name after `for`", value.expression.span);
            return Err(Error::UnexpectedToken { found: "an expression".into(), expected, span });
        }
        height = height.max(value.height);
        clauses.push(LoopClause { word, value: value.expression });
    }
    let body = expression(cursor, BODY)?;
    let height = height.max(body.height);
    node(cursor, start, ExprKind::Loop { clauses, body: body.boxed() }, Mode::Any, height)
}

/// The words of a loop so far.
#[derive(Default)]
struct LoopWords {
    last: Option<LoopWord>,
    /// Each word once, so that a loop of many clauses is read in one pass.
    different: Vec<LoopWord>,
}

impl LoopWords {
    /// The word here, if the loop can have it.
    fn next(&mut self, cursor: &Cursor) -> Result<LoopWord> {
        let word = self.word(cursor).ok_or_else(|| cursor.unexpected("`do` or another loop word"))?;
        if !self.different.iter().all(|earlier| go_together(*earlier, word)) {
            return Err(Error::LoopWord { word: word.symbol(), span: cursor.span() });
        }
        if !self.different.contains(&word) {
            self.different.push(word);
        }
        self.last = Some(word);
        Ok(word)
    }

    fn word(&self, cursor: &Cursor) -> Option<LoopWord> {
        let after_for = self.last == Some(LoopWord::For);
        match cursor.kind() {
            TokenKind::Symbol(name) if after_for && name == "in" => Some(LoopWord::In),
            TokenKind::Mark(":") if after_for => Some(LoopWord::From),
            TokenKind::Mark(mark) => LoopWord::reserved(mark),
            _ => None,
        }
    }
}

/// Whether one loop can have both words.
fn go_together(earlier: LoopWord, later: LoopWord) -> bool {
    use LoopWord::{From, In, Next, Step, Thru, Unless, While};
    let counts = |word| matches!(word, From | Step | Next | Thru);
    let twice = earlier == later && !matches!(later, While | Unless);
    !(twice || earlier == In && counts(later) || counts(earlier) && later == In)
}

/// What `left` becomes with the operator, argument list or subscript here.
fn go_on(cursor: &mut Cursor, left: Parsed) -> Result<Parsed> {
    if let Some(operator) = cursor.declared(false) {
        return go_on_with_declared(cursor, left, &operator);
    }
    let mark = cursor.mark().unwrap_or_default();
    if let "(" | "[" = mark {
        return apply(cursor, left, mark);
    }
    if let Some(operator) = UnaryOperator::postfix(mark) {
        return postfix(cursor, left, operator);
    }
    match BinaryOperator::infix(mark) {
        Some(operator) => infix(cursor, left, operator),
        None => Err(cursor.unexpected("an operator")),
    }
}

fn apply(cursor: &mut Cursor, function: Parsed, bracket: &str) -> Result<Parsed> {
    if let ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) = function.expression.kind {
        return Err(cursor.unexpected("an operator: a number is no function"));
    }
    let mut function = function;
    if let ExprKind::String(name) = &function.expression.kind
        && cursor.is_declared(name)
    {
        function.expression.kind = ExprKind::Symbol(name.clone());
    }
    let (start, below) = (function.expression.span.start, function.height);
    let (kind, height) = if bracket == "(" {
        let (arguments, height) = bracketed(cursor, "(", ")")?;
        (ExprKind::Call { function: function.boxed(), arguments }, height)
    } else {
        let (indices, height) = subscripts(cursor)?;
        (ExprKind::Subscript { array: function.boxed(), indices }, height)
    };
    node(cursor, start, kind, Mode::Any, height.max(below))
}

fn subscripts(cursor: &mut Cursor) -> Result<(Vec<Expr>, usize)> {
    let start = cursor.span().start;
    let (indices, height) = bracketed(cursor, "[", "]")?;
    if indices.is_empty() {
        return Err(empty("a subscript", start..cursor.end_of_previous()));
    }
    Ok((indices, height))
}

fn postfix(cursor: &mut Cursor, left: Parsed, operator: UnaryOperator) -> Result<Parsed> {
    check_mode(&left, operator.mode(), operator.symbol())?;
    cursor.advance();
    let (start, height) = (left.expression.span.start, left.height);
    node(cursor, start, ExprKind::Unary { operator, operand: left.boxed() }, operator.mode(), height)
}

fn infix(cursor: &mut Cursor, left: Parsed, operator: BinaryOperator) -> Result<Parsed> {
    check_mode(&left, operator.operands(), operator.symbol())?;
    cursor.advance();
    let right = operand(cursor, operator.right_power(), operator.operands(), operator.symbol())?;
    let (start, height) = (left.expression.span.start, left.height.max(right.height));
    let kind = ExprKind::Binary { operator, left: left.boxed(), right: right.boxed() };
    node(cursor, start, kind, operator.result(), height)
}
