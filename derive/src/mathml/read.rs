//! The reader: LaTeX letter by letter, into tags.

use super::symbol::{escaped, symbol};

/// How deep groups may be nested.
const DEPTH: usize = 128;

/// Reads one text.
pub struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

/// What ends a list of parts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// The text.
    Text,
    /// `}`
    Brace,
    /// `]`
    Bracket,
    /// `\right`
    Right,
    /// `&`
    Cell,
    /// `\\`
    Row,
    /// `\end`
    Environment,
}

impl<'a> Reader<'a> {
    pub fn new(latex: &'a str) -> Self {
        Reader { rest: latex, depth: 0 }
    }

    /// The formulas of the text.
    pub fn rows(mut self) -> Option<Vec<String>> {
        let mut rows = Vec::new();
        loop {
            let (row, end) = self.parts(None)?;
            rows.push(row);
            match end {
                End::Text => return Some(rows),
                End::Row => {}
                _ => return None,
            }
        }
    }

    /// Parts side by side, and what ended them; a bracket does where that is `closed` by one.
    fn parts(&mut self, closed: Option<End>) -> Option<(String, End)> {
        self.depth += 1;
        if self.depth > DEPTH {
            return None;
        }
        let mut parts = String::new();
        let end = loop {
            self.rest = self.rest.trim_start();
            match self.end(closed) {
                Some(end) => break end,
                None => parts.push_str(&self.scripted()?),
            }
        };
        self.depth -= 1;
        Some((parts, end))
    }

    /// What ends a list here, passed over.
    fn end(&mut self, closed: Option<End>) -> Option<End> {
        let ends = [
            ("}", End::Brace),
            ("&", End::Cell),
            (r"\\", End::Row),
            (r"\right", End::Right),
            (r"\end", End::Environment),
        ];
        let bracket = [("]", End::Bracket)].into_iter().filter(|_| closed == Some(End::Bracket));
        if self.rest.is_empty() {
            return Some(End::Text);
        }
        let (mark, end) = ends.into_iter().chain(bracket).find(|(mark, _)| self.rest.starts_with(mark))?;
        self.rest = &self.rest[mark.len()..];
        Some(end)
    }

    /// A part with what stands below and above it.
    fn scripted(&mut self) -> Option<String> {
        let base = self.part()?;
        let (mut below, mut above) = (None, None);
        loop {
            let script = match self.rest.chars().next() {
                Some('_') => &mut below,
                Some('^') => &mut above,
                _ => break,
            };
            if script.is_some() {
                return None;
            }
            self.rest = &self.rest[1..];
            *script = Some(self.argument()?);
        }
        Some(match (below, above) {
            (None, None) => base,
            (Some(below), None) => format!("<msub>{base}{below}</msub>"),
            (None, Some(above)) => format!("<msup>{base}{above}</msup>"),
            (Some(below), Some(above)) => format!("<msubsup>{base}{below}{above}</msubsup>"),
        })
    }

    /// A group in braces, as one row.
    fn argument(&mut self) -> Option<String> {
        self.rest = self.rest.trim_start().strip_prefix('{')?;
        match self.parts(Some(End::Brace))? {
            (parts, End::Brace) => Some(format!("<mrow>{parts}</mrow>")),
            _ => None,
        }
    }

    fn part(&mut self) -> Option<String> {
        let letter = self.rest.chars().next()?;
        match letter {
            '{' => self.argument(),
            '\\' => self.command(),
            '0'..='9' => Some(self.number()),
            '_' | '^' => None,
            _ => {
                self.rest = &self.rest[letter.len_utf8()..];
                Some(match letter {
                    '-' => "<mo>−</mo>".into(),
                    letter if letter.is_alphabetic() => format!("<mi>{letter}</mi>"),
                    letter => format!("<mo>{}</mo>", escaped(letter)),
                })
            }
        }
    }

    fn number(&mut self) -> String {
        let end = self.rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        self.rest = rest;
        format!("<mn>{digits}</mn>")
    }

    fn command(&mut self) -> Option<String> {
        let name = self.command_name()?;
        match name {
            "frac" => Some(format!("<mfrac>{}{}</mfrac>", self.argument()?, self.argument()?)),
            "sqrt" => self.root(),
            "mathrm" | "operatorname" => Some(format!("<mi mathvariant=\"normal\">{}</mi>", self.text()?)),
            "text" => Some(format!("<mtext>{}</mtext>", self.text()?)),
            "left" => self.fenced(),
            "begin" => self.cases(),
            "^" | "~" => {
                self.rest = self.rest.strip_prefix("{}")?;
                Some(format!("<mi>{name}</mi>"))
            }
            name => symbol(name),
        }
    }

    /// The name of the command here: letters, or one other sign.
    fn command_name(&mut self) -> Option<&'a str> {
        let after = self.rest.strip_prefix('\\')?;
        let letters = after.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(after.len());
        let end = if letters == 0 { after.chars().next()?.len_utf8() } else { letters };
        let (name, rest) = after.split_at(end);
        self.rest = rest;
        Some(name)
    }

    fn root(&mut self) -> Option<String> {
        let Some(degree) = self.rest.strip_prefix('[') else {
            return Some(format!("<msqrt>{}</msqrt>", self.argument()?));
        };
        self.rest = degree;
        let (degree, end) = self.parts(Some(End::Bracket))?;
        (end == End::Bracket).then_some(())?;
        Some(format!("<mroot>{}<mrow>{degree}</mrow></mroot>", self.argument()?))
    }

    /// A group of upright letters, in which signs may be escaped.
    fn text(&mut self) -> Option<String> {
        self.rest = self.rest.strip_prefix('{')?;
        let mut text = String::new();
        loop {
            let letter = self.rest.chars().next()?;
            self.rest = &self.rest[letter.len_utf8()..];
            match letter {
                '}' => return Some(text),
                '{' => return None,
                '\\' => {
                    let sign = self.rest.chars().next()?;
                    let (sign, length) = if self.rest.starts_with("backslash{}") {
                        ('\\', "backslash{}".len())
                    } else {
                        (sign, sign.len_utf8())
                    };
                    self.rest = &self.rest[length..];
                    self.rest = self.rest.strip_prefix("{}").filter(|_| matches!(sign, '^' | '~')).unwrap_or(self.rest);
                    (!sign.is_ascii_alphabetic()).then(|| text.push_str(&escaped(sign)))?;
                }
                letter => text.push_str(&escaped(letter)),
            }
        }
    }

    /// Parts between the signs after `\left` and `\right`.
    fn fenced(&mut self) -> Option<String> {
        let left = self.fence()?;
        let (parts, end) = self.parts(Some(End::Right))?;
        (end == End::Right).then_some(())?;
        let right = self.fence()?;
        Some(format!("<mrow>{left}{parts}{right}</mrow>"))
    }

    fn fence(&mut self) -> Option<String> {
        if self.rest.starts_with('\\') {
            let name = self.command_name()?;
            return symbol(name);
        }
        let sign = self.rest.chars().next()?;
        self.rest = &self.rest[sign.len_utf8()..];
        match sign {
            '.' => Some(String::new()),
            '(' | ')' | '[' | ']' | '|' => Some(format!("<mo>{sign}</mo>")),
            _ => None,
        }
    }

    /// The rows of `cases`, cell by cell.
    fn cases(&mut self) -> Option<String> {
        self.rest = self.rest.strip_prefix("{cases}")?;
        let (mut rows, mut cells) = (String::new(), String::new());
        loop {
            let (cell, end) = self.parts(Some(End::Environment))?;
            cells.push_str(&format!("<mtd>{cell}</mtd>"));
            if matches!(end, End::Row | End::Environment) {
                rows.push_str(&format!("<mtr>{}</mtr>", std::mem::take(&mut cells)));
            }
            match end {
                End::Cell | End::Row => {}
                End::Environment => break,
                _ => return None,
            }
        }
        self.rest = self.rest.strip_prefix("{cases}")?;
        Some(format!("<mrow><mo>{{</mo><mtable columnalign=\"left\">{rows}</mtable></mrow>"))
    }
}
