//! Statements: O-words and the macros of Fanuc, which say which lines come next.

use super::dialect::Dialect;
use super::error::Problem;
use super::text::{Kind, Text};

/// What a statement does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Keyword {
    Sub,
    EndSub,
    Call,
    Return,
    If,
    ElseIf,
    Else,
    EndIf,
    While,
    EndWhile,
    Do,
    Repeat,
    EndRepeat,
    Break,
    Continue,
    /// The number or the name of a program, alone.
    Program,
    /// `IF [..]` of Fanuc, with GOTO or THEN.
    Macro,
    /// `GOTO 10`.
    Goto,
}

/// O-words; of those that begin alike the longer one first.
const KEYWORDS: [(&[u8], Keyword); 15] = [
    (b"endsub", Keyword::EndSub),
    (b"endwhile", Keyword::EndWhile),
    (b"endrepeat", Keyword::EndRepeat),
    (b"endif", Keyword::EndIf),
    (b"elseif", Keyword::ElseIf),
    (b"else", Keyword::Else),
    (b"sub", Keyword::Sub),
    (b"call", Keyword::Call),
    (b"return", Keyword::Return),
    (b"if", Keyword::If),
    (b"while", Keyword::While),
    (b"do", Keyword::Do),
    (b"repeat", Keyword::Repeat),
    (b"break", Keyword::Break),
    (b"continue", Keyword::Continue),
];

/// A statement of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Statement {
    pub(super) keyword: Keyword,
    pub(super) label: Label,
    /// Where the line goes on.
    pub(super) rest: usize,
}

/// What belongs together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Label {
    /// A number without leading zeros, or a name.
    Known(String),
    /// To be computed, from this place on.
    Computed(usize),
}

impl Statement {
    /// The statement of a line in lower case without blanks; none where it has codes.
    pub(super) fn of(code: &[u8], dialect: Dialect) -> Result<Option<Self>, Problem> {
        if !dialect.computes() {
            return Ok(None);
        }
        let begin = after_number(code);
        match code.get(begin) {
            Some(b'o' | b':') => o_word(code, begin + 1).map(Some),
            Some(b'i' | b'w' | b'g' | b'd' | b'e') if dialect == Dialect::Fanuc => Ok(of_fanuc(code, begin)),
            _ => Ok(None),
        }
    }

    /// The same of a line as it stands in the file; what cannot be read is none.
    pub(super) fn of_raw(line: &[u8], dialect: Dialect, text: &mut Text) -> Option<Self> {
        let may_be = |byte: u8| matches!(byte, b'o' | b'O' | b':' | b'n' | b'N') || dialect == Dialect::Fanuc;
        let first = line.iter().copied().find(|byte| !byte.is_ascii_whitespace())?;
        if !may_be(first) || !matches!(text.read(line, dialect), Ok(Kind::Code)) {
            return None;
        }
        Self::of(&text.code, dialect).ok().flatten()
    }

    /// Whether it is this one, of this label.
    pub(super) fn is(&self, label: &str, keywords: &[Keyword]) -> bool {
        keywords.contains(&self.keyword) && matches!(&self.label, Label::Known(known) if known == label)
    }
}

/// Behind the number of the line.
fn after_number(code: &[u8]) -> usize {
    match code {
        [b'n', rest @ ..] => 1 + rest.iter().take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count(),
        _ => 0,
    }
}

/// The number of a line as it stands in the file.
pub(super) fn line_number(line: &[u8]) -> Option<u64> {
    let line = line.trim_ascii_start();
    let line = line.strip_prefix(b"/").unwrap_or(line).trim_ascii_start();
    let digits = line.strip_prefix(b"N").or(line.strip_prefix(b"n"))?.trim_ascii_start();
    let end = digits.iter().take_while(|byte| byte.is_ascii_digit()).count();
    std::str::from_utf8(&digits[..end]).ok()?.parse().ok()
}

fn o_word(code: &[u8], begin: usize) -> Result<Statement, Problem> {
    let (label, at) = label(code, begin)?;
    let rest = &code[at..];
    if rest.is_empty() {
        return Ok(Statement { keyword: Keyword::Program, label, rest: at });
    }
    match KEYWORDS.iter().find(|(word, _)| rest.starts_with(word)) {
        Some((word, keyword)) => Ok(Statement { keyword: *keyword, label, rest: at + word.len() }),
        None => {
            let text = String::from_utf8_lossy(code).to_ascii_uppercase();
            Err(Problem::Syntax { text: text.chars().take(40).collect() })
        }
    }
}

fn label(code: &[u8], begin: usize) -> Result<(Label, usize), Problem> {
    let rest = code.get(begin..).unwrap_or_default();
    let unreadable = || Problem::Syntax { text: String::from_utf8_lossy(code).to_ascii_uppercase() };
    match rest.first() {
        Some(b'<') => {
            let end = rest.iter().position(|byte| *byte == b'>').ok_or_else(unreadable)?;
            Ok((Label::Known(String::from_utf8_lossy(&rest[1..end]).into_owned()), begin + end + 1))
        }
        Some(b'0'..=b'9') => {
            let end = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
            Ok((Label::Known(number(&rest[..end])), begin + end))
        }
        Some(b'#' | b'[') => {
            // A computed one ends where its keyword begins, outside of names and brackets.
            let mut depth = 0_i32;
            let is_end = |at: &usize| {
                match rest[*at] {
                    b'<' | b'[' => depth += 1,
                    b'>' | b']' => depth -= 1,
                    _ => {}
                }
                depth == 0 && KEYWORDS.iter().any(|(word, _)| rest[*at..].starts_with(word))
            };
            let end = (0..rest.len()).find(is_end).ok_or_else(unreadable)?;
            Ok((Label::Computed(begin), begin + end))
        }
        _ => Err(unreadable()),
    }
}

/// A number without leading zeros.
pub(super) fn number(digits: &[u8]) -> String {
    let text = String::from_utf8_lossy(digits);
    let short = text.trim_start_matches('0');
    if short.is_empty() { "0".to_owned() } else { short.to_owned() }
}

/// `IF [..]`, `WHILE [..] DO1`, `END1`, `GOTO 10`.
fn of_fanuc(code: &[u8], begin: usize) -> Option<Statement> {
    let rest = &code[begin..];
    let statement = |keyword, label: String, rest| Some(Statement { keyword, label: Label::Known(label), rest });
    if rest.starts_with(b"if[") {
        return statement(Keyword::Macro, String::new(), begin + 2);
    }
    if rest.starts_with(b"goto") {
        return statement(Keyword::Goto, String::new(), begin + 4);
    }
    if rest.starts_with(b"while[") {
        let end = rest.windows(2).rposition(|two| two == b"do")?;
        return statement(Keyword::While, loop_label(&rest[end + 2..])?, begin + 5);
    }
    if let Some(number) = rest.strip_prefix(b"do") {
        return statement(Keyword::While, loop_label(number)?, code.len());
    }
    if let Some(number) = rest.strip_prefix(b"end") {
        return statement(Keyword::EndWhile, loop_label(number)?, code.len());
    }
    None
}

/// The number of DO and END; no other label has a blank in it.
fn loop_label(digits: &[u8]) -> Option<String> {
    let is_number = !digits.is_empty() && digits.iter().all(u8::is_ascii_digit);
    is_number.then(|| format!("do {}", number(digits)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_are_recognised() {
        let known = |label: &str| Label::Known(label.to_owned());
        let of = |line: &str, dialect| {
            Statement::of_raw(line.as_bytes(), dialect, &mut Text::default()).map(|found| (found.keyword, found.label))
        };
        let cases = [
            ("O100 sub", Dialect::LinuxCnc, Keyword::Sub, known("100")),
            ("n5 o<My Sub> CALL [1]", Dialect::LinuxCnc, Keyword::Call, known("mysub")),
            ("o007 endwhile", Dialect::LinuxCnc, Keyword::EndWhile, known("7")),
            ("O#1 call", Dialect::LinuxCnc, Keyword::Call, Label::Computed(1)),
            ("O1234 (title)", Dialect::Fanuc, Keyword::Program, known("1234")),
            ("N10 WHILE [#1 LT 5] DO 2", Dialect::Fanuc, Keyword::While, known("do 2")),
            ("END2", Dialect::Fanuc, Keyword::EndWhile, known("do 2")),
            ("GOTO 10", Dialect::Fanuc, Keyword::Goto, known("")),
        ];
        for (line, dialect, keyword, label) in cases {
            assert_eq!(of(line, dialect), Some((keyword, label)), "{line}");
        }
        assert_eq!(of("G1 X1", Dialect::Fanuc), None);
        assert_eq!(line_number(b" /N0012 G1"), Some(12));
    }
}
