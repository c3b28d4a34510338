//! Golden values: numbers that Maxima printed, with the exact inputs it computed them for.

use crate::hex;
use crate::worksheets;

/// Digits of a value that are correct.
pub const DIGITS: u32 = 40;

/// One golden value.
#[derive(Clone, Debug, PartialEq)]
pub struct GoldenValue {
    /// The worksheet name of the function.
    pub worksheet: String,
    /// Maxima names and values of its inputs, in order.
    pub inputs: Vec<(String, f64)>,
    /// The value in decimal.
    pub value: String,
}

/// The golden values of `maxima-ref/FAMILY.tsv`.
pub fn load(family: &str) -> Vec<GoldenValue> {
    parse(&worksheets::read(family, "tsv")).unwrap_or_else(|line| panic!("{family}.tsv: no golden value: {line}"))
}

/// The golden values of a text, or the first line that is none.
pub fn parse(text: &str) -> Result<Vec<GoldenValue>, String> {
    let lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(|line| parse_line(line).ok_or_else(|| line.to_owned())).collect()
}

fn parse_line(line: &str) -> Option<GoldenValue> {
    let [worksheet, inputs, value] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
    let input = |text: &str| {
        let (name, value) = text.split_once('=')?;
        Some((name.to_owned(), hex::parse(value)?))
    };
    let inputs = inputs.split(' ').map(input).collect::<Option<_>>()?;
    Some(GoldenValue { worksheet: worksheet.to_owned(), inputs, value: value.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_exactly() {
        let values = parse("# comment\n\nf\tx=0x1.8p-3 y=-0x1p+0\t1.5e-2\n").unwrap();
        let inputs = vec![("x".to_owned(), 0.1875), ("y".to_owned(), -1.0)];
        assert_eq!(values, [GoldenValue { worksheet: "f".to_owned(), inputs, value: "1.5e-2".to_owned() }]);
    }

    #[test]
    fn other_lines_are_refused() {
        for line in ["f\tx=0x1p+0", "f\tx=0.5\t1", "f\tx\t1", "f x=0x1p+0 1", "f\tx=0x1p+0\t1\t2"] {
            assert_eq!(parse(line), Err(line.to_owned()));
        }
    }
}
