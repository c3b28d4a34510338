//! Numbers as text that reads back to the same bits.

/// The shortest decimal that reads back to this number, with an exponent where it is very large or small.
pub(super) fn decimal(number: f64) -> String {
    format!("{number:?}")
}

/// The number that a decimal is nearest to.
pub(super) fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok()
}

/// JSON with its numbers in quotation marks: `serde_json` rounds a decimal to the nearest number only by a feature that
/// would change it for everything else that is built with it, so they are handed through as text.
pub(super) fn quote_numbers(json: &str) -> String {
    let mut quoted = String::with_capacity(json.len() * 5 / 4);
    let (mut in_string, mut escaped, mut in_number) = (false, false, false);
    for character in json.chars() {
        let is_number = !in_string
            && matches!(character, '0'..='9' | '+' | '-' | '.' | 'e' | 'E')
            && (in_number || !matches!(character, 'e' | 'E'));
        if is_number != in_number {
            quoted.push('"');
            in_number = is_number;
        }
        if character == '"' && !escaped {
            in_string = !in_string;
        }
        escaped = in_string && character == '\\' && !escaped;
        quoted.push(character);
    }
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_quoted_and_strings_left_alone() {
        let json = r#"{"a 1\"2":[1.5,-2e-3 , true,false,"3"],"b":7}"#;
        assert_eq!(quote_numbers(json), r#"{"a 1\"2":["1.5","-2e-3" , true,false,"3"],"b":"7"}"#);
    }
}
