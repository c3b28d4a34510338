//! Units: which texts are one, and the dimension that each has.
//!
//! A unit is a product of powers such as `kg*m/s^2`, `N`, `V/um`, `m^(1/2)` or `1/(kg*K)`; `1` is a number. Every symbol
//! is one of [`SYMBOLS`], with a prefix where it takes one. What stands behind a `/` is one factor or stands in
//! parentheses, because `J/kg*K` is read in two ways.

use std::fmt;
use std::ops::Range;

/// The base dimensions: length, mass, time, current, temperature, amount, luminous intensity.
pub const BASES: usize = 7;

/// A symbol of [`SYMBOLS`].
struct Symbol {
    text: &'static str,
    /// Its English name.
    name: &'static str,
    /// Powers of the base dimensions.
    powers: [i32; BASES],
    /// Whether prefixes go before it.
    prefixed: bool,
}

const fn si(text: &'static str, name: &'static str, powers: [i32; BASES]) -> Symbol {
    Symbol { text, name, powers, prefixed: true }
}

const fn other(text: &'static str, name: &'static str, powers: [i32; BASES]) -> Symbol {
    Symbol { text, name, powers, prefixed: false }
}

/// Every symbol: the base and derived units of the SI, and what is used beside them.
#[rustfmt::skip]
const SYMBOLS: [Symbol; 52] = [
    //                      m  kg   s   A   K mol  cd
    si("m", "metre",      [ 1,  0,  0,  0,  0,  0,  0]),
    si("g", "gram",       [ 0,  1,  0,  0,  0,  0,  0]),
    si("s", "second",     [ 0,  0,  1,  0,  0,  0,  0]),
    si("A", "ampere",     [ 0,  0,  0,  1,  0,  0,  0]),
    si("K", "kelvin",     [ 0,  0,  0,  0,  1,  0,  0]),
    si("mol", "mole",     [ 0,  0,  0,  0,  0,  1,  0]),
    si("cd", "candela",   [ 0,  0,  0,  0,  0,  0,  1]),
    si("rad", "radian",   [ 0,  0,  0,  0,  0,  0,  0]),
    si("sr", "steradian", [ 0,  0,  0,  0,  0,  0,  0]),
    si("Hz", "hertz",     [ 0,  0, -1,  0,  0,  0,  0]),
    si("N", "newton",     [ 1,  1, -2,  0,  0,  0,  0]),
    si("Pa", "pascal",    [-1,  1, -2,  0,  0,  0,  0]),
    si("J", "joule",      [ 2,  1, -2,  0,  0,  0,  0]),
    si("W", "watt",       [ 2,  1, -3,  0,  0,  0,  0]),
    si("C", "coulomb",    [ 0,  0,  1,  1,  0,  0,  0]),
    si("V", "volt",       [ 2,  1, -3, -1,  0,  0,  0]),
    si("F", "farad",      [-2, -1,  4,  2,  0,  0,  0]),
    si("ohm", "ohm",      [ 2,  1, -3, -2,  0,  0,  0]),
    si("Ω", "ohm",        [ 2,  1, -3, -2,  0,  0,  0]),
    si("S", "siemens",    [-2, -1,  3,  2,  0,  0,  0]),
    si("Wb", "weber",     [ 2,  1, -2, -1,  0,  0,  0]),
    si("T", "tesla",      [ 0,  1, -2, -1,  0,  0,  0]),
    si("H", "henry",      [ 2,  1, -2, -2,  0,  0,  0]),
    si("lm", "lumen",     [ 0,  0,  0,  0,  0,  0,  1]),
    si("lx", "lux",       [-2,  0,  0,  0,  0,  0,  1]),
    si("Bq", "becquerel", [ 0,  0, -1,  0,  0,  0,  0]),
    si("Gy", "gray",      [ 2,  0, -2,  0,  0,  0,  0]),
    si("Sv", "sievert",   [ 2,  0, -2,  0,  0,  0,  0]),
    si("kat", "katal",    [ 0,  0, -1,  0,  0,  1,  0]),
    si("L", "litre",      [ 3,  0,  0,  0,  0,  0,  0]),
    si("l", "litre",      [ 3,  0,  0,  0,  0,  0,  0]),
    si("t", "tonne",      [ 0,  1,  0,  0,  0,  0,  0]),
    si("eV", "electronvolt", [2, 1, -2,  0,  0,  0,  0]),
    si("bar", "bar",      [-1,  1, -2,  0,  0,  0,  0]),
    si("Da", "dalton",    [ 0,  1,  0,  0,  0,  0,  0]),
    other("min", "minute", [0,  0,  1,  0,  0,  0,  0]),
    other("h", "hour",    [ 0,  0,  1,  0,  0,  0,  0]),
    other("d", "day",     [ 0,  0,  1,  0,  0,  0,  0]),
    other("rpm", "revolution per minute", [0, 0, -1, 0, 0, 0, 0]),
    other("rev", "revolution", [0, 0, 0, 0,  0,  0,  0]),
    other("deg", "degree", [0,  0,  0,  0,  0,  0,  0]),
    other("°", "degree",  [ 0,  0,  0,  0,  0,  0,  0]),
    other("arcmin", "minute of arc", [0, 0, 0, 0, 0, 0, 0]),
    other("arcsec", "second of arc", [0, 0, 0, 0, 0, 0, 0]),
    other("in", "inch",   [ 1,  0,  0,  0,  0,  0,  0]),
    other("ft", "foot",   [ 1,  0,  0,  0,  0,  0,  0]),
    other("au", "astronomical unit", [1, 0, 0, 0, 0, 0, 0]),
    other("ha", "hectare", [2,  0,  0,  0,  0,  0,  0]),
    other("px", "pixel",  [ 0,  0,  0,  0,  0,  0,  0]),
    other("%", "percent", [ 0,  0,  0,  0,  0,  0,  0]),
    other("ppm", "part per million", [0, 0, 0, 0, 0, 0, 0]),
    other("1", "number",  [ 0,  0,  0,  0,  0,  0,  0]),
];

/// The prefixes of the SI, and the letter u for micro.
const PREFIXES: [&str; 26] = [
    "q", "r", "y", "z", "a", "f", "p", "n", "u", "\u{b5}", "\u{3bc}", "m", "c", "d", "da", "h", "k", "M", "G", "T",
    "P", "E", "Z", "Y", "R", "Q",
];

/// The largest power, counted in halves; no formula comes near, and sums of such powers do not overflow.
const MOST_HALVES: i32 = 1 << 12;

/// What a unit measures: powers of the base dimensions, counted in halves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dimension {
    /// Twice the power of each base dimension.
    pub halves: [i32; BASES],
}

/// Why a text is no unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    /// What is wrong.
    pub what: String,
    /// What to write instead.
    pub remedy: String,
    /// Where in the text.
    pub span: Range<usize>,
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)
    }
}

impl std::error::Error for UnitError {}

impl Dimension {
    /// The dimension of a unit.
    ///
    /// # Errors
    ///
    /// The first thing in the text that makes it none.
    pub fn of_unit(unit: &str) -> Result<Self, UnitError> {
        let mut reader = Reader { text: unit, at: 0, depth: 0 };
        let dimension = reader.product()?;
        match reader.peek() {
            None => Ok(dimension),
            Some(_) => Err(reader.unexpected()),
        }
    }

    fn times(self, other: Self, sign: i32) -> Option<Self> {
        let mut halves = self.halves;
        for (mine, others) in halves.iter_mut().zip(other.halves) {
            *mine = mine.checked_add(sign * others).filter(|power| power.abs() <= MOST_HALVES)?;
        }
        Some(Self { halves })
    }

    /// To a power counted in halves, if the result is a whole number of halves.
    fn power(self, halves: i32) -> Option<Self> {
        let mut powers = self.halves;
        for power in &mut powers {
            let twice = power.checked_mul(halves).filter(|twice| twice % 2 == 0)?;
            *power = Some(twice / 2).filter(|power| power.abs() <= MOST_HALVES)?;
        }
        Some(Self { halves: powers })
    }
}

/// A place in the text of a unit.
struct Reader<'a> {
    text: &'a str,
    at: usize,
    /// How many parentheses are open.
    depth: usize,
}

/// How deep parentheses may stand inside each other.
const DEEPEST: usize = 16;

impl Reader<'_> {
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(' ').len();
        self.text[self.at..].chars().next()
    }

    fn take(&mut self, wanted: &[char]) -> bool {
        match self.peek().filter(|found| wanted.contains(found)) {
            Some(found) => {
                self.at += found.len_utf8();
                true
            }
            None => false,
        }
    }

    fn product(&mut self) -> Result<Dimension, UnitError> {
        let mut all = self.factor()?;
        let mut divided = false;
        loop {
            let before = self.at;
            let sign = if self.take(&['*', '\u{b7}']) {
                1
            } else if self.take(&['/']) {
                -1
            } else {
                return Ok(all);
            };
            if divided && sign == 1 {
                let what = "`*` behind `/` is read in two ways";
                let remedy = "put what is divided by into parentheses, as in J/(kg*K)";
                return Err(error(what, remedy, before..self.at));
            }
            divided |= sign == -1;
            let factor = self.factor()?;
            all = all.times(factor, sign).ok_or_else(|| too_large(before..self.at))?;
        }
    }

    fn factor(&mut self) -> Result<Dimension, UnitError> {
        let dimension = if self.take(&['(']) { self.parentheses()? } else { self.symbol()? };
        if !self.take(&['^']) {
            return Ok(dimension);
        }
        let start = self.at;
        let power = self.power();
        let letter = self.text[start..].chars().next().map_or(0, char::len_utf8);
        let span = start..self.at.max(start + letter);
        let remedy = "write a whole power as in s^2 or s^-2, or a half one as in m^(1/2)";
        let power = power.ok_or_else(|| error("this is no power of a unit", remedy, span.clone()))?;
        let raised = dimension.power(power);
        raised.ok_or_else(|| error("a power that is neither whole nor half, or too large", remedy, span))
    }

    fn parentheses(&mut self) -> Result<Dimension, UnitError> {
        let open = self.at.saturating_sub(1);
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(error("too many parentheses", "write fewer", open..open + 1));
        }
        let inner = self.product()?;
        self.depth -= 1;
        if self.take(&[')']) { Ok(inner) } else { Err(error("`(` without its `)`", "close it", open..open + 1)) }
    }

    fn symbol(&mut self) -> Result<Dimension, UnitError> {
        _ = self.peek();
        let start = self.at;
        let rest = &self.text[start..];
        let ends = |c: char| c != '1' && !c.is_alphabetic() && !matches!(c, '%' | '°' | '_');
        let length = if rest.starts_with('1') { 1 } else { rest.find(ends).unwrap_or(rest.len()) };
        if length == 0 {
            return Err(self.unexpected());
        }
        self.at += length;
        let symbol = &rest[..length];
        let powers = dimension_of(symbol).ok_or_else(|| unknown(symbol, start..start + length))?;
        Ok(Dimension { halves: powers.map(|power| 2 * power) })
    }

    /// The power here, counted in halves: `2`, `-2`, `0.5`, `(1/2)`, `(-3/2)`.
    fn power(&mut self) -> Option<i32> {
        let in_parentheses = self.take(&['(']);
        let negative = self.take(&['-']);
        let whole = self.integer()?;
        let halves = if self.take(&['.']) {
            let digits = self.integer_text();
            let more = match digits.trim_end_matches('0') {
                "" if !digits.is_empty() => 0,
                "5" => 1,
                _ => return None,
            };
            2 * whole + more
        } else if in_parentheses && self.take(&['/']) {
            match self.integer()? {
                1 => 2 * whole,
                2 => whole,
                _ => return None,
            }
        } else {
            2 * whole
        };
        (!in_parentheses || self.take(&[')'])).then_some(if negative { -halves } else { halves })
    }

    fn integer(&mut self) -> Option<i32> {
        self.integer_text().parse().ok().filter(|value| *value <= MOST_HALVES)
    }

    fn integer_text(&mut self) -> &str {
        let rest = &self.text[self.at..];
        let length = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    fn unexpected(&mut self) -> UnitError {
        let remedy = "write a product of powers such as kg*m/s^2, or 1 where there is no unit";
        match self.peek() {
            None => error("a unit is missing here", remedy, self.at..self.at),
            Some(found) if found.is_alphabetic() => {
                error("an operator is missing here", "write `*` between factors, as in N*m", self.span_of(found))
            }
            Some(found) => error(format!("`{found}` has no place here"), remedy, self.span_of(found)),
        }
    }

    fn span_of(&self, found: char) -> Range<usize> {
        self.at..self.at + found.len_utf8()
    }
}

fn error(what: impl Into<String>, remedy: impl Into<String>, span: Range<usize>) -> UnitError {
    UnitError { what: what.into(), remedy: remedy.into(), span }
}

fn too_large(span: Range<usize>) -> UnitError {
    error("a power beyond all measure", "write smaller powers", span)
}

/// The powers of a symbol, as it stands or behind a prefix.
fn dimension_of(symbol: &str) -> Option<[i32; BASES]> {
    let whole = SYMBOLS.iter().find(|known| known.text == symbol);
    let behind = |prefix: &&str| {
        let rest = symbol.strip_prefix(prefix)?;
        SYMBOLS.iter().find(|known| known.prefixed && known.text == rest)
    };
    whole.or_else(|| PREFIXES.iter().find_map(behind)).map(|known| known.powers)
}

fn unknown(symbol: &str, span: Range<usize>) -> UnitError {
    let remedy = match meant(symbol) {
        Some(known) => format!("did you mean `{}`, {}?", known.text, known.name),
        None => "known are the units of the SI with their prefixes, and a few beside them such as min, deg and %; \
                 write 1 for what is counted"
            .to_owned(),
    };
    error(format!("`{symbol}` is no known unit"), remedy, span)
}

/// The symbol that a word may have meant: by its name, or but for capitals.
fn meant(word: &str) -> Option<&'static Symbol> {
    let lower = word.to_lowercase();
    let singular = lower.strip_suffix('s').filter(|rest| rest.len() > 2).unwrap_or(&lower);
    let american = singular.replace("meter", "metre").replace("liter", "litre");
    let celsius = ["degc", "°c", "celsius"].contains(&lower.as_str()).then_some("kelvin");
    let named = |symbol: &&Symbol| {
        let name = celsius.unwrap_or(&american);
        name.len() > 2 && (symbol.name.starts_with(name) || (celsius.is_none() && name.ends_with(symbol.name)))
    };
    let capitals = |symbol: &&Symbol| symbol.text.to_lowercase() == lower;
    SYMBOLS.iter().find(named).or_else(|| SYMBOLS.iter().find(capitals))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn is(unit: &str, halves: [i32; BASES]) {
        assert_eq!(Dimension::of_unit(unit), Ok(Dimension { halves }), "{unit}");
    }

    #[test]
    fn units_are_products_of_powers() {
        let force = [2, 2, -4, 0, 0, 0, 0];
        for unit in
            ["N", "kN", "mN", "kg*m/s^2", "kg * m / s^2", "kg\u{b7}m/s^2", "kg*m*s^-2", "(kg*m)/(s*s)", "kg*m/s/s"]
        {
            is(unit, force);
        }
        for unit in ["1", "%", "deg", "rad", "mrad", "rad/deg", "m/mm", "ppm", "1/1"] {
            is(unit, [0; BASES]);
        }
        is("V/um", [2, 2, -6, -2, 0, 0, 0]);
        is("V/\u{b5}m", [2, 2, -6, -2, 0, 0, 0]);
        is("J/(kg*K)", [4, 0, -4, 0, -2, 0, 0]);
        is("1/s", [0, 0, -2, 0, 0, 0, 0]);
        is("s^3/m", [-2, 0, 6, 0, 0, 0, 0]);
    }

    #[test]
    fn powers_may_be_halves() {
        for unit in ["m^(1/2)", "m^0.5", "m^(0.5)", "(m^3)^(1/2)/m"] {
            is(unit, [1, 0, 0, 0, 0, 0, 0]);
        }
        is("V/Hz^(1/2)", [4, 2, -5, -2, 0, 0, 0]);
        is("m^(-3/2)", [-3, 0, 0, 0, 0, 0, 0]);
        is("(m/s)^2", [4, 0, -4, 0, 0, 0, 0]);
        assert!(Dimension::of_unit("(m^(1/2))^(1/2)").is_err(), "a quarter");
        assert!(Dimension::of_unit("m^(1/3)").is_err(), "a third");
    }

    #[test]
    fn a_symbol_comes_before_a_prefix() {
        is("min", [0, 0, 2, 0, 0, 0, 0]);
        is("Pa", [-2, 2, -4, 0, 0, 0, 0]);
        is("cd", [0, 0, 0, 0, 0, 0, 2]);
        is("mT", [0, 2, -4, -2, 0, 0, 0]);
        is("dam", [2, 0, 0, 0, 0, 0, 0]);
        assert!(Dimension::of_unit("kmin").is_err() && Dimension::of_unit("k").is_err());
    }

    #[track_caller]
    fn says(unit: &str, place: &str, words: &[&str]) {
        let error = Dimension::of_unit(unit).expect_err(unit);
        assert_eq!(&unit[error.span.clone()], place, "{error:?}");
        let said = format!("{error}: {}", error.remedy);
        words.iter().for_each(|word| assert!(said.contains(word), "`{word}` is not in {said}"));
    }

    #[test]
    fn what_is_none_says_what_is_near() {
        says("m/sec", "sec", &["`sec` is no known unit", "`s`, second"]);
        says("Newtons", "Newtons", &["`N`, newton"]);
        says("meter", "meter", &["`m`, metre"]);
        says("millimetre", "millimetre", &["`m`, metre"]);
        says("KG", "KG", &["no known unit"]);
        says("hz", "hz", &["`Hz`, hertz"]);
        says("degC", "degC", &["`K`, kelvin"]);
        says("furlong", "furlong", &["units of the SI", "1 for what is counted"]);
        says("J/kg*K", "*", &["two ways", "J/(kg*K)"]);
        says("N m", "m", &["write `*`"]);
        says("", "", &["missing"]);
        says("m/", "", &["missing"]);
        says("m^x", "x", &["no power"]);
        says("(m", "(", &["without its `)`"]);
        says("m)", ")", &["has no place here"]);
        says("2*m", "2", &["has no place here"]);
    }

    #[test]
    fn nothing_overflows() {
        for unit in ["m^999999999999", "m^2000*m^2000*m^2000", "((m^2000)^2000)^2000", "m^-", "m^", "m^(", "m^(1/0)"] {
            assert!(Dimension::of_unit(unit).is_err(), "{unit}");
        }
        assert!(Dimension::of_unit(&"(".repeat(100_000)).is_err());
        assert!(Dimension::of_unit(&"m*".repeat(100_000)).is_err());
    }
}
