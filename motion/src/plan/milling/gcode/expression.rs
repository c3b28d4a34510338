//! Numbers, parameters and expressions in a line, evaluated as they are read.

use super::error::Problem;
use super::parameters::{Controller, Parameters};

/// Brackets in brackets, more than anybody writes.
const DEEPEST: u32 = 200;

/// Reads a line, without blanks and in lower case, from a place on.
pub(super) struct Scanner<'a> {
    pub(super) code: &'a [u8],
    pub(super) at: usize,
    depth: u32,
    parameters: &'a Parameters,
    controller: &'a dyn Controller,
}

/// Operators of two numbers, those that bind less first.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Operator {
    And,
    Or,
    ExclusiveOr,
    Equal,
    Different,
    Greater,
    GreaterOrEqual,
    Less,
    LessOrEqual,
    Plus,
    Minus,
    Times,
    Divided,
    Remainder,
    Power,
}

impl<'a> Scanner<'a> {
    pub(super) fn new(code: &'a [u8], at: usize, parameters: &'a Parameters, controller: &'a dyn Controller) -> Self {
        Self { code, at, depth: 0, parameters, controller }
    }

    /// The next byte, if there is one.
    pub(super) fn peek(&self) -> Option<u8> {
        self.code.get(self.at).copied()
    }

    /// Whether the line goes on with this text, which is then passed.
    pub(super) fn take(&mut self, text: &[u8]) -> bool {
        let found = self.code[self.at.min(self.code.len())..].starts_with(text);
        if found {
            self.at += text.len();
        }
        found
    }

    /// A number, a parameter, a function or an expression in brackets.
    pub(super) fn value(&mut self) -> Result<f64, Problem> {
        self.nested(Self::inner_value)
    }

    fn inner_value(&mut self) -> Result<f64, Problem> {
        match self.peek() {
            Some(b'0'..=b'9' | b'.') => self.number(1.0),
            Some(sign @ (b'-' | b'+')) => {
                self.at += 1;
                let sign = if sign == b'-' { -1.0 } else { 1.0 };
                match self.peek() {
                    Some(b'0'..=b'9' | b'.') => self.number(sign),
                    Some(b'#' | b'[' | b'a'..=b'z') => Ok(sign * self.value()?),
                    _ => Err(self.unreadable()),
                }
            }
            Some(b'[') => self.brackets(),
            Some(b'#') => self.parameter(),
            Some(b'a'..=b'z') => self.function(),
            _ => Err(self.unreadable()),
        }
    }

    fn nested(&mut self, read: impl FnOnce(&mut Self) -> Result<f64, Problem>) -> Result<f64, Problem> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(wrong("is too deep: write it in several lines"));
        }
        let value = read(self)?;
        self.depth -= 1;
        Ok(value)
    }

    /// Digits with at most one point. Numbers of few digits are a quotient of two that are exact, so it is rounded once.
    fn number(&mut self, sign: f64) -> Result<f64, Problem> {
        const EXACT: u64 = 1 << 53;
        const POWERS: [f64; 23] = [
            1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
            1e19, 1e20, 1e21, 1e22,
        ];
        let begin = self.at;
        let (mut digits, mut decimals, mut has_point, mut exact) = (0_u64, 0_usize, false, true);
        let mut any = false;
        while let Some(byte) = self.peek() {
            match byte {
                b'0'..=b'9' => {
                    any = true;
                    exact &= digits < EXACT / 16;
                    digits = digits.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
                    decimals += usize::from(has_point);
                }
                b'.' if !has_point => has_point = true,
                _ => break,
            }
            self.at += 1;
        }
        if !any || self.peek() == Some(b'.') {
            return Err(self.unreadable());
        }
        if exact && decimals < POWERS.len() {
            return Ok(sign * (digits as f64 / POWERS[decimals]));
        }
        let text = std::str::from_utf8(&self.code[begin..self.at]).unwrap_or_default();
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(sign * value),
            _ => Err(self.unreadable()),
        }
    }

    /// `[` an expression `]`.
    pub(super) fn brackets(&mut self) -> Result<f64, Problem> {
        if !self.take(b"[") {
            return Err(wrong("has no bracket: put it in [ ]"));
        }
        let value = self.nested(|scanner| scanner.operation(0))?;
        if self.take(b"]") { Ok(value) } else { Err(wrong("has no end: close it with ]")) }
    }

    /// Operators that bind at least so much, from left to right.
    fn operation(&mut self, least: u32) -> Result<f64, Problem> {
        let mut value = self.value()?;
        loop {
            let before = self.at;
            let Some(operator) = self.operator() else { return Ok(value) };
            let strength = operator.strength();
            if strength < least {
                self.at = before;
                return Ok(value);
            }
            let right = self.nested(|scanner| scanner.operation(strength + 1))?;
            value = operator.of(value, right)?;
        }
    }

    fn operator(&mut self) -> Option<Operator> {
        const ALL: [(&[u8], Operator); 16] = [
            (b"**", Operator::Power),
            (b"*", Operator::Times),
            (b"/", Operator::Divided),
            (b"+", Operator::Plus),
            (b"-", Operator::Minus),
            (b"mod", Operator::Remainder),
            (b"and", Operator::And),
            (b"xor", Operator::ExclusiveOr),
            (b"or", Operator::Or),
            (b"eq", Operator::Equal),
            (b"ne", Operator::Different),
            (b"gt", Operator::Greater),
            (b"ge", Operator::GreaterOrEqual),
            (b"lt", Operator::Less),
            (b"le", Operator::LessOrEqual),
            (b"&&", Operator::And),
        ];
        ALL.iter().find(|(text, _)| self.take(text)).map(|(_, operator)| *operator)
    }

    /// `#5`, `##5`, `#[1+2]`, `#<name>`.
    fn parameter(&mut self) -> Result<f64, Problem> {
        self.at += 1;
        if self.peek() == Some(b'<') {
            let name = self.name()?;
            let value = self.parameters.name(&name, self.controller);
            return value.ok_or(Problem::Undefined { name });
        }
        if let Some(name) = self.short_name() {
            return self.parameters.name(&name, self.controller).ok_or(Problem::Undefined { name });
        }
        let number = self.index()?;
        Ok(self.parameters.number(number, self.controller))
    }

    /// `#TOLX`: names of four letters without brackets, which GRBL-Plotter replaces before it sends a line.
    fn short_name(&mut self) -> Option<String> {
        let name = self.code.get(self.at..self.at + 4)?;
        let is_name = name.iter().all(u8::is_ascii_lowercase) && self.code.get(self.at + 4) != Some(&b'[');
        is_name.then(|| {
            self.at += 4;
            String::from_utf8_lossy(name).into_owned()
        })
    }

    /// The number of a parameter.
    pub(super) fn index(&mut self) -> Result<u32, Problem> {
        let value = self.value()?;
        let whole = value.round();
        if (value - whole).abs() > 1e-4 || !(0.0..=4e9).contains(&whole) {
            return Err(wrong(&format!("names the parameter #{value}: its number must be whole and positive")));
        }
        Ok(whole as u32)
    }

    /// `<name>`.
    pub(super) fn name(&mut self) -> Result<String, Problem> {
        let begin = self.at + 1;
        let Some(length) = self.code.get(begin..).and_then(|rest| rest.iter().position(|byte| *byte == b'>')) else {
            return Err(wrong("has a name without end: close it with >"));
        };
        self.at = begin + length + 1;
        Ok(String::from_utf8_lossy(&self.code[begin..begin + length]).into_owned())
    }

    fn function(&mut self) -> Result<f64, Problem> {
        let begin = self.at;
        while self.peek().is_some_and(|byte| byte.is_ascii_lowercase()) {
            self.at += 1;
        }
        let code = self.code;
        let name = &code[begin..self.at];
        if name == b"exists" {
            return self.exists();
        }
        if self.peek() != Some(b'[') {
            self.at = begin;
            return Err(self.unreadable());
        }
        if name == b"atan" {
            return self.arc_tangent();
        }
        let value = self.brackets()?;
        let result = match name {
            b"abs" => value.abs(),
            b"acos" => value.acos().to_degrees(),
            b"asin" => value.asin().to_degrees(),
            b"cos" => value.to_radians().cos(),
            b"exp" => value.exp(),
            b"fix" => value.floor(),
            b"fup" => value.ceil(),
            b"ln" => value.ln(),
            b"round" | b"rnd" => value.round(),
            b"sin" => value.to_radians().sin(),
            b"sqrt" | b"sqr" => value.sqrt(),
            b"tan" => value.to_radians().tan(),
            _ => {
                let name = String::from_utf8_lossy(name).to_ascii_uppercase();
                return Err(wrong(&format!("has the function {name}, which is none: correct it")));
            }
        };
        finite(result)
    }

    /// `atan[y]/[x]`, or Fanuc's `atan[y]` of a quotient.
    fn arc_tangent(&mut self) -> Result<f64, Problem> {
        let above = self.brackets()?;
        if self.take(b"/[") {
            self.at -= 1;
            return Ok(above.atan2(self.brackets()?).to_degrees());
        }
        Ok(above.atan().to_degrees())
    }

    /// `exists[#<name>]`.
    fn exists(&mut self) -> Result<f64, Problem> {
        if !self.take(b"[#") {
            return Err(wrong("asks EXISTS of no parameter: write EXISTS[#<name>]"));
        }
        let known = match self.peek() {
            Some(b'<') => {
                let name = self.name()?;
                self.parameters.name(&name, self.controller).is_some()
            }
            _ => self.index().map(|_| true)?,
        };
        if self.take(b"]") { Ok(f64::from(u8::from(known))) } else { Err(wrong("has no end: close it with ]")) }
    }

    /// What cannot be read: the letters around it, or all from the letter before it to the next one.
    pub(super) fn unreadable(&self) -> Problem {
        let at = self.at.min(self.code.len());
        let begin = self.code[..at].iter().rposition(u8::is_ascii_alphabetic).unwrap_or(0);
        let is_word = self.peek().is_some_and(|byte| byte.is_ascii_alphabetic());
        let rest = self.code[at..].iter().skip(1);
        let end = at + 1 + rest.take_while(|byte| byte.is_ascii_alphabetic() == is_word).count();
        let text = String::from_utf8_lossy(&self.code[begin..end.min(self.code.len())]).to_ascii_uppercase();
        Problem::Syntax { text: text.chars().take(40).collect() }
    }
}

impl Operator {
    fn strength(self) -> u32 {
        match self {
            Self::And | Self::Or | Self::ExclusiveOr => 0,
            Self::Equal | Self::Different | Self::Greater | Self::GreaterOrEqual | Self::Less | Self::LessOrEqual => 1,
            Self::Plus | Self::Minus => 2,
            Self::Times | Self::Divided | Self::Remainder => 3,
            Self::Power => 4,
        }
    }

    fn of(self, left: f64, right: f64) -> Result<f64, Problem> {
        // LinuxCNC takes numbers so near for equal.
        const NEAR: f64 = 1e-6;
        let near = (left - right).abs() < NEAR;
        let truth = |truth: bool| f64::from(u8::from(truth));
        let value = match self {
            Self::And => truth(left != 0.0 && right != 0.0),
            Self::Or => truth(left != 0.0 || right != 0.0),
            Self::ExclusiveOr => truth((left != 0.0) != (right != 0.0)),
            Self::Equal => truth(near),
            Self::Different => truth(!near),
            Self::Greater => truth(left > right),
            Self::GreaterOrEqual => truth(left >= right),
            Self::Less => truth(left < right),
            Self::LessOrEqual => truth(left <= right),
            Self::Plus => left + right,
            Self::Minus => left - right,
            Self::Times => left * right,
            Self::Divided | Self::Remainder if right == 0.0 => return Err(wrong("divides by 0: correct it")),
            Self::Divided => left / right,
            Self::Remainder => left.rem_euclid(right.abs()),
            Self::Power => left.powf(right),
        };
        finite(value)
    }
}

fn finite(value: f64) -> Result<f64, Problem> {
    if value.is_finite() { Ok(value) } else { Err(wrong("has no value: its argument is outside of what it takes")) }
}

fn wrong(why: &str) -> Problem {
    Problem::Expression { why: why.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Nothing;

    impl Controller for Nothing {
        fn number(&self, number: u32) -> Option<f64> {
            (number == 5420).then_some(7.0)
        }

        fn name(&self, name: &str) -> Option<f64> {
            (name == "x").then_some(3.0)
        }
    }

    fn value(text: &str) -> Result<f64, Problem> {
        let mut parameters = Parameters::new(&[("depth".to_owned(), -2.5), ("2".to_owned(), 5.0)]);
        parameters.set(5, 31.0)?;
        Scanner::new(text.as_bytes(), 0, &parameters, &Nothing).value()
    }

    #[test]
    fn expressions_have_values() {
        // Of LinuxCNC's documentation: strength of operators, degrees, FIX and FUP.
        let cases = [
            ("[1+2*3]", 7.0),
            ("[2.0/3*1.5-5.5/11.0]", 0.5),
            ("[2**3**2]", 64.0),
            ("[1+acos[0]-[#5**[4.0/2]]]", 91.0 - 961.0),
            ("-[2+#<depth>]", 0.5),
            ("##2", 31.0),
            ("#[1+1]", 5.0),
            ("#<_x>", 3.0),
            ("#5420", 7.0),
            ("fix[-2.8]", -3.0),
            ("fup[-2.8]", -2.0),
            ("atan[1]/[-1]", 135.0),
            ("[5mod3]", 2.0),
            ("[-5mod3]", 1.0),
            ("[2gt1and1eq1]", 1.0),
            ("[1or0and0]", 0.0),
            ("exists[#<no>]", 0.0),
            ("exists[#<depth>]", 1.0),
            ("0.1", 0.1),
            ("123456789012345678901234567890.5", 123_456_789_012_345_678_901_234_567_890.5),
            ("5.", 5.0),
            (".5", 0.5),
        ];
        for (text, expected) in cases {
            let found = value(text).unwrap_or_else(|problem| panic!("{text}: {problem}"));
            assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{text}: {found}");
        }
    }

    #[test]
    fn what_has_no_value_is_told() {
        for text in ["[1/0]", "[1", "sqrt[-1]", "#<no>", "1..2", ".", "--5", "foo[1]", "#-1", "[1+]", "asin[2]", ""] {
            assert!(value(text).is_err(), "{text}");
        }
        let deep = "[".repeat(100_000);
        assert!(value(&deep).is_err());
    }
}
