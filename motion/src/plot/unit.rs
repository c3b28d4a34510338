//! Units and their prefixes, by the size of what is shown, and numbers as people write them.

/// What to divide by, and what the unit is then called.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unit {
    pub size: f64,
    pub name: String,
}

const PREFIXES: [(f64, &str); 5] = [(1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")];

/// The unit in which the largest value is from 1 to 1000, as far as there are prefixes in use: a thousand seconds are not
/// kiloseconds, and a thousand m/s² and m/s³ are just that. Beyond them a power of ten stands before the unit.
pub(super) fn unit(base: &str, largest: f64) -> Unit {
    let highest = match base {
        "s" | "m/s²" | "m/s³" => 1.0,
        _ => 1e3,
    };
    let prefixes = || PREFIXES.iter().filter(|(size, _)| *size <= highest);
    let fits = |(size, _): &&(f64, &str)| largest >= *size;
    if largest <= 0.0 {
        return Unit { size: 1.0, name: base.to_owned() };
    }
    match prefixes().find(fits) {
        Some((size, prefix)) if largest < size * if base == "s" { 1e7 } else { 1e4 } => {
            Unit { size: *size, name: format!("{prefix}{base}") }
        }
        _ => power(base, largest),
    }
}

/// The unit of an axis: half of a unit is still told in it, 0.5 m and not 500 mm.
pub(super) fn axis_unit(base: &str, largest: f64) -> Unit {
    unit(base, if base == "s" { largest } else { 2.0 * largest })
}

/// The power of a thousand by which the largest value is from 1 to 1000.
fn power(base: &str, largest: f64) -> Unit {
    let exponent = (-103..=102).rev().map(|third| 3 * third).find(|exponent| ten_to(*exponent) <= largest);
    let exponent = exponent.unwrap_or(-306);
    Unit { size: ten_to(exponent), name: format!("10{} {base}", superscript(exponent)) }
}

/// The number nearest to a power of ten.
fn ten_to(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}

/// An exponent as it is set.
fn superscript(exponent: i32) -> String {
    let raise = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        _ => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    exponent.to_string().chars().map(raise).collect()
}

/// A power of ten as it is set.
pub(super) fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10{}", superscript(exponent)),
    }
}

/// A number with so many decimals and a minus as wide as a plus.
pub(super) fn fixed(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text.replace('-', "−") }
}

/// A quantity with four digits and a prefix, such as 12.5 mm/s.
#[must_use]
pub fn with_unit(value: f64, base: &str) -> String {
    if !value.is_finite() {
        return format!("{value} {base}");
    }
    unit(base, value.abs()).say(value)
}

impl Unit {
    /// A value with four digits and this unit.
    pub(super) fn say(&self, value: f64) -> String {
        let number = value / self.size;
        let digits = [1.0, 10.0, 100.0, 1000.0].iter().filter(|limit| number.abs() >= **limit * (1.0 - 5e-5)).count();
        let text = fixed(number, 4_usize.saturating_sub(digits.max(1)));
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        let space = if self.name.starts_with("10") { "·" } else { " " };
        format!("{text}{space}{}", self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_follow_the_size() {
        let said = [
            (0.0125, "m/s", "12.5 mm/s"),
            (-3e-7, "m", "−300 nm"),
            (4250.0, "s", "4250 s"),
            (37_912.0, "s", "37912 s"),
            (2.5e7, "m/s³", "25·10⁶ m/s³"),
            (0.0, "m", "0 m"),
            (5e-324, "s", "0·10⁻³⁰⁶ s"),
            (1.7e308, "m", "170·10³⁰⁶ m"),
            (9.99999, "m", "10 m"),
            (1234.0, "m", "1.234 km"),
        ];
        for (value, base, text) in said {
            assert_eq!(with_unit(value, base), text);
        }
    }
}
