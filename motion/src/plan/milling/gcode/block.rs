//! A block: the codes and words of one line.

use gcode::core::{
    BlockVisitor, CommandVisitor, ControlFlow, Diagnostics, Number, ProgramVisitor, Span, TokenType, Value,
};

use super::error::Problem;

/// The parser counts codes in tenths in 32 bits: a number with more digits before the point than this is none.
const DIGITS: usize = 8;

/// A G or M code, in tenths: G91.1 is 911.
pub(super) type Tenths = u32;

/// What stands in one line.
#[derive(Debug, Default)]
pub(super) struct Block {
    /// G codes, in order.
    pub(super) general: Vec<Tenths>,
    /// M codes, in order.
    pub(super) miscellaneous: Vec<Tenths>,
    /// A program mark, `%`.
    pub(super) mark: bool,
    /// What could not be read.
    pub(super) problem: Option<Problem>,
    words: [Option<f64>; 26],
}

impl Block {
    /// Reads a line, without its optional `/`.
    pub(super) fn read(&mut self, line: &str) {
        *self = Self {
            general: std::mem::take(&mut self.general),
            miscellaneous: std::mem::take(&mut self.miscellaneous),
            ..Self::default()
        };
        self.general.clear();
        self.miscellaneous.clear();
        let bare = bare(line);
        if line.contains('\r') {
            return self.report(Problem::CarriageReturn);
        }
        if let Some(text) = oversized(&bare) {
            return self.report(Problem::Syntax { text: text.to_owned() });
        }
        gcode::core::parse(line, &mut Reader { line, block: self });
        // The parser says nothing of a code whose number is none, like G5.10.
        if codes(&bare) != self.general.len() + self.miscellaneous.len() {
            self.report(Problem::Syntax { text: bare.trim().to_owned() });
        }
    }

    /// Whether it has no codes and no words, at most comments or a program number.
    pub(super) fn is_empty(&self) -> bool {
        self.general.is_empty() && self.miscellaneous.is_empty() && self.words.iter().all(Option::is_none)
    }

    /// The number that stands with a letter.
    pub(super) fn word(&self, letter: char) -> Option<f64> {
        self.words[index(letter)?]
    }

    /// The first of these letters that has a number.
    pub(super) fn any(&self, letters: &str) -> Option<char> {
        letters.chars().find(|letter| self.word(*letter).is_some())
    }

    fn report(&mut self, problem: Problem) {
        self.problem.get_or_insert(problem);
    }
}

fn index(letter: char) -> Option<usize> {
    letter.is_ascii_alphabetic().then(|| usize::from(letter.to_ascii_uppercase() as u8 - b'A'))
}

/// The line without its comments, as the parser sees them.
fn bare(line: &str) -> String {
    let mut depth = 0_u32;
    let place = |letter: char| {
        let outside = depth == 0 && letter != '(';
        match letter {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        (outside, letter)
    };
    let code = line.chars().map(place).take_while(|place| *place != (true, ';'));
    code.map(|(outside, letter)| if outside { letter } else { ' ' }).collect()
}

/// A number with too many digits before the point.
fn oversized(bare: &str) -> Option<&str> {
    let number = |part: &&str| part.split('.').next().is_some_and(|whole| whole.len() > DIGITS);
    bare.split(|letter: char| !letter.is_ascii_digit() && letter != '.').find(number)
}

/// How many G and M codes there should be.
fn codes(bare: &str) -> usize {
    bare.chars().filter(|letter| matches!(letter, 'G' | 'g' | 'M' | 'm')).count()
}

/// Collects what the parser finds. Words count for the whole block, whichever code they follow.
struct Reader<'a> {
    line: &'a str,
    block: &'a mut Block,
}

impl Reader<'_> {
    /// The parser has read the number as an `f32`: here it is read again, from the same text.
    fn word(&mut self, letter: char, span: Span) {
        let text = &self.line[span.start..span.end()];
        let number: String = text.chars().skip(1).filter(|letter| !letter.is_whitespace()).collect();
        let (Some(index), Ok(value)) = (index(letter), number.parse::<f64>()) else {
            return self.block.report(Problem::Syntax { text: text.to_owned() });
        };
        if self.block.words[index].replace(value).is_some() {
            self.block.report(Problem::Twice { what: letter.to_ascii_uppercase().to_string() });
        }
    }

    fn again(&mut self) -> Reader<'_> {
        Reader { line: self.line, block: self.block }
    }
}

fn tenths(number: Number) -> Tenths {
    number.major() * 10 + number.minor().map_or(0, std::num::NonZeroU32::get)
}

impl ProgramVisitor for Reader<'_> {
    fn start_block(&mut self) -> ControlFlow<impl BlockVisitor + '_> {
        ControlFlow::Continue(self.again())
    }
}

impl BlockVisitor for Reader<'_> {
    fn comment(&mut self, value: &str, _span: Span) {
        if value.starts_with('(') && !value.ends_with(')') {
            self.block.report(Problem::Comment { text: value.trim_end().chars().take(40).collect() });
        }
    }

    fn program_delimiter(&mut self, _span: Span) {
        self.block.mark = true;
    }

    fn word_address(&mut self, letter: char, _value: Value<'_>, span: Span) {
        self.word(letter, span);
    }

    fn start_general_code(&mut self, number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        self.block.general.push(tenths(number));
        ControlFlow::Continue(self.again())
    }

    fn start_miscellaneous_code(&mut self, number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        self.block.miscellaneous.push(tenths(number));
        ControlFlow::Continue(self.again())
    }

    fn start_tool_change_code(&mut self, _number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        ControlFlow::Continue(self.again())
    }
}

impl CommandVisitor for Reader<'_> {
    fn argument(&mut self, letter: char, _value: Value<'_>, span: Span) {
        self.word(letter, span);
    }
}

impl Diagnostics for Reader<'_> {
    fn emit_unknown_content(&mut self, text: &str, _span: Span) {
        self.block.report(Problem::Syntax { text: text.to_owned() });
    }

    fn emit_unexpected(&mut self, actual: &str, _expected: &[TokenType], _span: Span) {
        self.block.report(Problem::Syntax { text: actual.to_owned() });
    }

    fn emit_parse_int_error(&mut self, value: &str, _error: std::num::ParseIntError, _span: Span) {
        self.block.report(Problem::Syntax { text: value.to_owned() });
    }
}
