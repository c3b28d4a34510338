//! A line without blanks, comments and free text, as the other stages read it.

use super::dialect::Dialect;
use super::error::Problem;

/// What a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Codes and words, or nothing.
    Code,
    /// `%`: the program begins or ends.
    Mark,
    /// A command that is a word (Klipper's macros), or a setting (`$`) of grbl.
    Command,
}

/// A line, made ready; holds its memory from line to line.
#[derive(Debug, Default)]
pub(super) struct Text {
    /// Lower case, without blanks.
    pub(super) code: Vec<u8>,
    /// The last comment.
    pub(super) comment: Vec<u8>,
    /// Whether it begins with `/`.
    pub(super) is_optional: bool,
}

/// What ends a file of old systems.
const CTRL_Z: u8 = 0x1a;

impl Text {
    /// Reads a line without its end.
    pub(super) fn read(&mut self, line: &[u8], dialect: Dialect) -> Result<Kind, Problem> {
        self.code.clear();
        self.comment.clear();
        let mut line = line.trim_ascii();
        while let [rest @ .., CTRL_Z | 0] = line {
            line = rest.trim_ascii_end();
        }
        self.is_optional = line.first() == Some(&b'/');
        if self.is_optional {
            // `/2` is the second switch of several.
            line = line[1..].trim_ascii_start();
            if let [b'1'..=b'9', rest @ ..] = line
                && rest.first().is_none_or(|next| !next.is_ascii_digit())
            {
                line = rest;
            }
        }
        match line.first() {
            Some(b'%') => return Ok(Kind::Mark),
            Some(b'$') => return self.command(line),
            Some(_) if dialect.prints() && is_word(line) => return self.command(line),
            _ => {}
        }
        self.codes(line, dialect)?;
        if dialect.prints() {
            self.cut_free_text();
        }
        Ok(Kind::Code)
    }

    fn command(&mut self, line: &[u8]) -> Result<Kind, Problem> {
        let end = line.iter().position(|byte| *byte == b';').unwrap_or(line.len());
        self.code.extend(line[..end].trim_ascii_end().iter().map(u8::to_ascii_lowercase));
        Ok(Kind::Command)
    }

    fn codes(&mut self, line: &[u8], dialect: Dialect) -> Result<(), Problem> {
        let (mut at, mut depth) = (0, 0_u32);
        while let Some(byte) = line.get(at) {
            if !byte.is_ascii_digit() && *byte != b'.' && self.is_message() {
                return Ok(());
            }
            match byte {
                // other control characters are what damaged files and old tapes have
                b' ' | b'\t' | 0..=8 | 0x0b | 0x0c | 0x0e..=0x1f | 0x7f => {}
                b';' => {
                    self.comment.extend_from_slice(line[at + 1..].trim_ascii());
                    return Ok(());
                }
                b'(' => at = self.parenthesis(line, at)?,
                b'"' => at += line[at + 1..].iter().position(|byte| *byte == b'"').map_or(line.len(), |end| end + 1),
                b'\r' => return Err(Problem::CarriageReturn),
                b'*' if depth == 0 => return checksum(line, at),
                b'e' | b'E' if depth == 0 && !self.is_code() && is_exponent(line, at, dialect) => {
                    return Err(self.exponent(line, at));
                }
                _ => {
                    depth = match byte {
                        b'[' => depth + 1,
                        b']' => depth.saturating_sub(1),
                        _ => depth,
                    };
                    self.code.push(byte.to_ascii_lowercase());
                }
            }
            at += 1;
        }
        Ok(())
    }

    /// Whether M117 or M118 has come: all that follows is text for people.
    fn is_message(&self) -> bool {
        matches!(self.code.as_slice(), [.., b'm', b'1', b'1', b'7' | b'8'])
    }

    /// Whether the last word is a code, whose number has no exponent: `M68E3`.
    fn is_code(&self) -> bool {
        let letter = self.code.iter().rev().find(|byte| byte.is_ascii_alphabetic());
        matches!(letter, Some(b'g' | b'm'))
    }

    /// The place of the parenthesis that ends the comment. Comments nest where that closes them all; otherwise the first
    /// `)` ends them, as controllers have it.
    fn parenthesis(&mut self, line: &[u8], begin: usize) -> Result<usize, Problem> {
        let mut depth = 0_u32;
        let nested = line[begin..].iter().position(|byte| {
            match byte {
                b'(' => depth += 1,
                b')' => depth -= 1,
                _ => {}
            }
            depth == 0
        });
        let Some(end) = nested.or_else(|| line[begin..].iter().position(|byte| *byte == b')')) else {
            let text = String::from_utf8_lossy(&line[begin..]).chars().take(40).collect();
            return Err(Problem::Comment { text });
        };
        self.comment.clear();
        self.comment.extend_from_slice(line[begin + 1..begin + end].trim_ascii());
        Ok(begin + end)
    }

    /// The word that has the exponent, for people.
    fn exponent(&self, line: &[u8], at: usize) -> Problem {
        let begin = self.code.iter().rposition(u8::is_ascii_alphabetic).unwrap_or(0);
        let rest: Vec<u8> = line[at + 1..]
            .iter()
            .copied()
            .take_while(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-'))
            .collect();
        let word = [&self.code[begin..], b"e", &rest].concat();
        Problem::Exponent { text: String::from_utf8_lossy(&word).to_ascii_uppercase().replace('E', "e") }
    }

    /// Codes of printers whose rest is text: names of files, messages, models.
    fn cut_free_text(&mut self) {
        let begin = match self.code.as_slice() {
            [b'n', rest @ ..] => 1 + rest.iter().take_while(|byte| byte.is_ascii_digit()).count(),
            _ => 0,
        };
        if self.code.get(begin) != Some(&b'm') {
            return;
        }
        let digits = self.code[begin + 1..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        let number = std::str::from_utf8(&self.code[begin + 1..begin + 1 + digits]).unwrap_or_default();
        if matches!(number.parse(), Ok(0_u32 | 1 | 16 | 20..=34 | 36 | 38 | 486 | 550..=599 | 808 | 862 | 928)) {
            self.code.truncate(begin + 1 + digits);
        }
    }
}

/// A word of two letters or more: codes have a number after the first.
fn is_word(line: &[u8]) -> bool {
    matches!(line, [first, second, ..] if first.is_ascii_alphabetic() && (second.is_ascii_alphabetic() || *second == b'_'))
}

/// Whether the letter E at this place belongs to the number before it. Printers have an axis E, which programs that write
/// their numbers with exponents write in lower case.
fn is_exponent(line: &[u8], at: usize, dialect: Dialect) -> bool {
    let before = at > 0 && (line[at - 1].is_ascii_digit() || line[at - 1] == b'.');
    let after = match &line[at + 1..] {
        [b'+' | b'-', digit, ..] | [digit, ..] => digit.is_ascii_digit(),
        [] => false,
    };
    before && after && (line[at] == b'e' || !dialect.prints())
}

/// The sum that printers put at the end of a line, `*` and the exclusive or of all bytes before it.
fn checksum(line: &[u8], at: usize) -> Result<(), Problem> {
    let end = line[at..].iter().position(|byte| *byte == b';').map_or(line.len(), |end| at + end);
    let text = std::str::from_utf8(&line[at + 1..end]).unwrap_or_default().trim();
    let Ok(given) = text.parse::<u8>() else {
        return Err(Problem::Syntax { text: format!("*{text}") });
    };
    let right = line[..at].iter().fold(0, |sum, byte| sum ^ byte);
    if given == right { Ok(()) } else { Err(Problem::Checksum { given, right }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(line: &str, dialect: Dialect) -> Result<String, Problem> {
        let mut text = Text::default();
        text.read(line.as_bytes(), dialect)?;
        Ok(String::from_utf8_lossy(&text.code).into_owned())
    }

    #[test]
    fn what_is_not_code_is_left_out() {
        let cases = [
            ("x 10 0  y2 00 .0", "x100y200.0"),
            ("G1 (a (b) c) X1 ; rest", "g1x1"),
            ("G1 (don't :( ) X1", "g1x1"),
            ("M117 X50 (", "m117"),
            ("N7 M118 \u{fc}ber", "n7m118"),
            ("M1170 X1", "m1170x1"),
            ("G1 X1\u{1a}", "g1x1"),
            ("/2 G1 X1", "g1x1"),
            ("N3 T0*57", "n3t0"),
            ("#1=[2*3]", "#1=[2*3]"),
        ];
        for (line, expected) in cases {
            assert_eq!(code(line, Dialect::LinuxCnc), Ok(expected.to_owned()), "{line}");
        }
        assert_eq!(code("M862.3 P \"MK3S\"", Dialect::Marlin), Ok("m862".to_owned()));
        assert_eq!(code("M23 x10.gco", Dialect::Marlin), Ok("m23".to_owned()));
        assert_eq!(code("G1 X10 E5", Dialect::Marlin), Ok("g1x10e5".to_owned()));
    }

    #[test]
    fn exponents_and_wrong_sums_are_told() {
        let exponent = |text: &str| Err(Problem::Exponent { text: text.to_owned() });
        assert_eq!(code("G1 X9.02e-7", Dialect::LinuxCnc), exponent("X9.02e-7"));
        assert_eq!(code("G1 Z-2.77E-17 F3", Dialect::LinuxCnc), exponent("Z-2.77e-17"));
        assert_eq!(code("G1 X1e5", Dialect::Marlin), exponent("X1e5"));
        assert_eq!(code("N3 T0*58", Dialect::LinuxCnc), Err(Problem::Checksum { given: 58, right: 57 }));
    }
}
