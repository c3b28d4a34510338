//! Texts as C and Rust write them: comments and strings.

use crate::lines::Lines;

/// Paragraphs as a comment before a declaration.
pub fn comment(lines: &mut Lines, paragraphs: &[Vec<String>]) {
    lines.line("/**");
    for (position, paragraph) in paragraphs.iter().enumerate() {
        if position > 0 {
            lines.line(" *");
        }
        paragraph.iter().for_each(|line| {
            let lead = if line.starts_with(' ') { " *   " } else { " * " };
            lines.wrapped(lead, &harmless(line));
        });
    }
    lines.line(" */");
}

/// A text that neither ends nor begins a comment, and holds no trigraph.
fn harmless(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
}

/// A string of C in letters of ASCII.
pub fn c_string(text: &str) -> String {
    let mut string = String::from("\"");
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' | b'?' => string += &format!("\\{}", char::from(byte)),
            b' '..=b'~' => string.push(char::from(byte)),
            _ => string += &format!("\\{byte:03o}"),
        }
    }
    string + "\""
}

/// A string of Rust that ends with a zero, as C wants it.
pub fn rust_c_string(text: &str) -> String {
    format!("c{:?}", text.replace('\0', "\u{fffd}"))
}

/// A number that both languages read back; `NAN` of none.
pub fn number(value: f64) -> String {
    format!("{value:?}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_and_comments_hold_any_text() {
        assert_eq!(c_string("a\"b\\c\nµ??"), r#""a\"b\\c\012\302\265\?\?""#);
        assert_eq!(rust_c_string("a\"µ\0"), "c\"a\\\"µ\u{fffd}\"");
        let mut lines = Lines::default();
        comment(&mut lines, &[vec!["a*/b".to_owned()], vec!["  x/*y".to_owned()]]);
        assert_eq!(lines.text(), "/**\n * a* /b\n *\n *   x/ *y\n */\n");
    }
}
