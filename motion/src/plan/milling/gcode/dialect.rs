//! Dialects of G-code: what each controller takes a line for, and which one a file is meant for.

use crate::plan::milling::{Machine, Rules};

/// A family of controllers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Dialect {
    /// RS274/NGC: variables, expressions, O-words.
    LinuxCnc,
    /// The same without variables and O-words.
    Grbl,
    /// Printers: an axis E, commands with free text, F for rapid moves too.
    Marlin,
    /// The same, with commands that are words.
    Klipper,
    /// O-numbers, M98 and M99, macros with IF, WHILE and GOTO.
    Fanuc,
}

impl Dialect {
    /// As options and summaries call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::LinuxCnc => "linuxcnc",
            Self::Grbl => "grbl",
            Self::Marlin => "marlin",
            Self::Klipper => "klipper",
            Self::Fanuc => "fanuc",
        }
    }

    /// Limits of its machines, where nothing is known of them.
    #[must_use]
    pub fn machine(self) -> Machine {
        if self.prints() { Machine::printer() } else { Machine::default() }
    }

    /// By which rules its controller looks ahead.
    #[must_use]
    pub fn rules(self) -> Rules {
        match self {
            Self::Marlin => Rules::MARLIN,
            Self::Klipper => Rules::KLIPPER,
            Self::LinuxCnc | Self::Grbl | Self::Fanuc => Rules::GRBL,
        }
    }

    /// Whether it is for printers: E is an axis, M0 to M1 and many others have free text, and F counts for rapid moves.
    pub(super) fn prints(self) -> bool {
        matches!(self, Self::Marlin | Self::Klipper)
    }

    /// Whether it has variables and expressions.
    pub(super) fn computes(self) -> bool {
        matches!(self, Self::LinuxCnc | Self::Fanuc)
    }

    /// Whether P of a dwell is in milliseconds.
    pub(super) fn dwells_in_milliseconds(self) -> bool {
        matches!(self, Self::Marlin | Self::Klipper | Self::Fanuc)
    }

    /// Which one the begin of a file is meant for.
    ///
    /// One sign that only one of them has decides; they are looked for in the order in which the dialects exclude each
    /// other. LinuxCNC's stands for all that have no such sign, since it has what all mills share.
    #[must_use]
    pub fn guess(head: &str) -> Self {
        let lower = head.to_ascii_lowercase();
        let code: Vec<&str> = lower.lines().map(bare).filter(|line| !line.is_empty()).collect();
        let any = |sign: fn(&str) -> bool| code.iter().any(|line| sign(line));
        if any(is_o_word) {
            return Self::LinuxCnc;
        }
        if any(is_klipper) {
            return Self::Klipper;
        }
        if ["flavor:marlin", "marlin", "prusaslicer", "cura_steamengine"].iter().any(|sign| lower.contains(sign))
            || any(is_printer)
        {
            return Self::Marlin;
        }
        // A number of a program alone says nothing: Mach, LinuxCNC and Haas have them too.
        if any(is_macro) || lower.contains("fanuc") {
            return Self::Fanuc;
        }
        if any(|line| line.starts_with('$')) { Self::Grbl } else { Self::LinuxCnc }
    }
}

/// A line without comments and spaces around it.
fn bare(line: &str) -> &str {
    let end = line.find([';', '(']).unwrap_or(line.len());
    line[..end].trim()
}

/// `o100 sub` and its kin.
fn is_o_word(line: &str) -> bool {
    const WORDS: [&str; 10] = ["sub", "endsub", "call", "if", "while", "do", "repeat", "return", "endif", "endwhile"];
    let Some(rest) = line.strip_prefix('o') else { return line.contains("#<") };
    if rest.starts_with('<') {
        return true;
    }
    let word = rest.trim_start_matches(|letter: char| letter.is_ascii_digit()).trim_start();
    rest.starts_with(|letter: char| letter.is_ascii_digit()) && WORDS.iter().any(|known| word.starts_with(known))
}

/// `SET_VELOCITY_LIMIT ACCEL=1000`: a word with an underscore, or words with values.
fn is_klipper(line: &str) -> bool {
    let mut words = line.split_ascii_whitespace();
    let Some(first) = words.next() else { return false };
    let is_name = |word: &str| {
        word.len() > 3
            && word.bytes().all(|letter| letter.is_ascii_alphanumeric() || letter == b'_')
            && word.bytes().take(2).all(|letter| letter.is_ascii_alphabetic())
    };
    is_name(first) && (first.contains('_') || words.any(|word| word.contains('=')))
}

/// An axis E that stands by itself, or the heaters and limits of a printer.
fn is_printer(line: &str) -> bool {
    line.split_ascii_whitespace().any(|word| {
        let value = |rest: &str| rest.parse::<f64>().is_ok();
        match word.as_bytes().first() {
            Some(b'e') => word.len() > 1 && value(&word[1..]),
            Some(b'm') => matches!(
                word.split('.').next().unwrap_or(word),
                "m82"
                    | "m83"
                    | "m104"
                    | "m106"
                    | "m107"
                    | "m109"
                    | "m140"
                    | "m190"
                    | "m201"
                    | "m203"
                    | "m204"
                    | "m205"
                    | "m862"
                    | "m900"
                    | "m117"
                    | "m500"
            ),
            _ => false,
        }
    })
}

/// `IF [#1 GT 2] GOTO 10`, `WHILE [#1 LT 2] DO1`, `G65 P9000`.
fn is_macro(line: &str) -> bool {
    let line = line.trim_start_matches(|letter: char| letter == 'n' || letter.is_ascii_digit()).trim_start();
    let after = |word: &str| line.strip_prefix(word).map(str::trim_start);
    after("if").or(after("while")).is_some_and(|rest| rest.starts_with('['))
        || after("goto").is_some()
        || line.contains("g65")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_told_apart() {
        let cases = [
            ("G21\nG1 X1 F100", Dialect::LinuxCnc),
            ("o100 sub\nG1 X1\no100 endsub", Dialect::LinuxCnc),
            ("#<depth> = 5", Dialect::LinuxCnc),
            ("$H\nG1 X1", Dialect::Grbl),
            ("G28\nM104 S200\nG1 X1 E0.5", Dialect::Marlin),
            ("G1 X1 E-5 F300", Dialect::Marlin),
            ("G1 X9.02e-7 F300", Dialect::LinuxCnc),
            ("SET_VELOCITY_LIMIT ACCEL=1000\nG1 X1", Dialect::Klipper),
            ("%\nO1234 (part)\nG0 X1", Dialect::LinuxCnc),
            ("%\nO1234 (part)\nG65 P9000 A1", Dialect::Fanuc),
            ("#1=5\nWHILE [#1 GT 0] DO1\nEND1", Dialect::Fanuc),
        ];
        for (text, dialect) in cases {
            assert_eq!(Dialect::guess(text), dialect, "{text}");
        }
    }
}
