//! A block: the codes and words of one line, and the parameters that it sets.

use super::dialect::Dialect;
use super::error::Problem;
use super::expression::Scanner;
use super::parameters::{Controller, Parameters};

/// A G or M code, in tenths: G91.1 is 911.
pub(super) type Tenths = u32;

/// The largest code.
const LARGEST: f64 = 9999.9;

/// A code may be a computed number: so far from tenths it may be, as in LinuxCNC.
const NEAR: f64 = 1e-4;

/// What stands in one line.
#[derive(Debug, Default)]
pub(super) struct Block {
    /// G codes, in order.
    pub(super) general: Vec<Tenths>,
    /// M codes, in order.
    pub(super) miscellaneous: Vec<Tenths>,
    /// Distance and angle from the origin (`@` and `^`).
    pub(super) polar: [Option<f64>; 2],
    words: [Option<f64>; 26],
    settings: Vec<(Name, f64)>,
    /// Whether P has a point: Haas takes it for seconds then, and for milliseconds without.
    pub(super) has_point: bool,
    /// Words that were left out, because a name has no value.
    pub(super) left_out: Vec<Problem>,
}

/// Of a parameter.
#[derive(Debug)]
enum Name {
    Number(u32),
    Name(String),
}

impl Block {
    /// Reads a line, in lower case and without blanks, and sets its parameters.
    pub(super) fn read(
        &mut self,
        code: &[u8],
        dialect: Dialect,
        parameters: &mut Parameters,
        controller: &dyn Controller,
    ) -> Result<(), Problem> {
        self.clear();
        let mut scanner = Scanner::new(code, 0, parameters, controller);
        if scanner.take(b"n") {
            scanner.value()?;
        }
        while let Some(letter) = scanner.peek() {
            match letter {
                b'#' => self.setting(&mut scanner, dialect)?,
                b'a'..=b'z' => self.read_word(letter, &mut scanner, dialect)?,
                // which of several spindles
                b'$' => {
                    scanner.at += 1;
                    scanner.value()?;
                }
                b'@' | b'^' => self.read_polar(letter, &mut scanner)?,
                _ => return Err(scanner.unreadable()),
            }
        }
        for (name, value) in self.settings.drain(..) {
            match name {
                Name::Number(number) => parameters.set(number, value)?,
                Name::Name(name) => parameters.set_name(&name, value)?,
            }
        }
        Ok(())
    }

    fn clear(&mut self) {
        self.general.clear();
        self.miscellaneous.clear();
        self.settings.clear();
        self.left_out.clear();
        self.has_point = false;
        self.polar = [None; 2];
        self.words = [None; 26];
    }

    fn read_word(&mut self, letter: u8, scanner: &mut Scanner, dialect: Dialect) -> Result<(), Problem> {
        scanner.at += 1;
        if matches!(scanner.peek(), Some(b'#' | b'[')) && !dialect.computes() {
            let what = "a parameter or an expression".to_owned();
            return Err(Problem::Dialect { what, dialect: dialect.name() });
        }
        if let Some(axis) = alone(letter, scanner, dialect) {
            self.words[axis].get_or_insert(0.0);
            return Ok(());
        }
        let begin = scanner.at;
        let value = match scanner.value() {
            // What only the sender of a program knows: the word counts as if it were not there, and that is told.
            Err(problem @ Problem::Undefined { .. }) if is_short(&problem) => {
                self.left_out.push(problem);
                return Ok(());
            }
            value => value?,
        };
        self.has_point |= letter == b'p' && scanner.code[begin..scanner.at].contains(&b'.');
        match letter {
            b'g' => self.general.push(tenths('G', value)?),
            b'm' => self.miscellaneous.push(tenths('M', value)?),
            _ => {
                if self.words[usize::from(letter - b'a')].replace(value).is_some() {
                    return Err(Problem::Twice { what: char::from(letter).to_ascii_uppercase().to_string() });
                }
            }
        }
        Ok(())
    }

    fn read_polar(&mut self, letter: u8, scanner: &mut Scanner) -> Result<(), Problem> {
        scanner.at += 1;
        let value = scanner.value()?;
        self.polar[usize::from(letter == b'^')] = Some(value);
        Ok(())
    }

    /// `#1=2`, `#<name>=2`: counts from the next line on.
    fn setting(&mut self, scanner: &mut Scanner, dialect: Dialect) -> Result<(), Problem> {
        if !dialect.computes() {
            return Err(Problem::Dialect { what: "a parameter".to_owned(), dialect: dialect.name() });
        }
        scanner.at += 1;
        let name = match scanner.peek() {
            Some(b'<') => Name::Name(scanner.name()?),
            _ => Name::Number(scanner.index()?),
        };
        if !scanner.take(b"=") {
            return Err(scanner.unreadable());
        }
        let value = scanner.value()?;
        self.settings.push((name, value));
        Ok(())
    }

    /// Whether it has no codes and no words.
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

    /// All words, from A to Z.
    pub(super) fn words(&self) -> &[Option<f64>; 26] {
        &self.words
    }

    /// With a word that was taken out.
    pub(super) fn put(&mut self, letter: char, value: Option<f64>) {
        if let Some(index) = index(letter) {
            self.words[index] = value;
        }
    }

    /// Without a word that has been used.
    pub(super) fn remove(&mut self, letter: char) -> Option<f64> {
        self.words[index(letter)?].take()
    }
}

/// Whether it is one of the names that a sender replaces.
fn is_short(problem: &Problem) -> bool {
    matches!(problem, Problem::Undefined { name } if name.len() == 4 && !name.starts_with('_'))
}

fn index(letter: char) -> Option<usize> {
    letter.is_ascii_alphabetic().then(|| usize::from(letter.to_ascii_uppercase() as u8 - b'A'))
}

/// Printers name axes without a number: `G28 X Y`.
fn alone(letter: u8, scanner: &Scanner, dialect: Dialect) -> Option<usize> {
    let ends = scanner.peek().is_none_or(|next| next.is_ascii_lowercase());
    (ends && dialect.prints() && !matches!(letter, b'g' | b'm' | b't')).then(|| usize::from(letter - b'a'))
}

fn tenths(letter: char, value: f64) -> Result<Tenths, Problem> {
    let tenths = (10.0 * value).round();
    if !(0.0..=LARGEST).contains(&value) || (10.0 * value - tenths).abs() > 10.0 * NEAR {
        return Err(Problem::Syntax { text: format!("{letter}{value}") });
    }
    Ok(tenths as Tenths)
}
