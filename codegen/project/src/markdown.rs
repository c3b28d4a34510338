//! Texts that people wrote, as Markdown that shows them letter by letter.

/// What makes a comment read in another order than it is compiled in; compilers refuse it.
const TURNING: [char; 9] =
    ['\u{202a}', '\u{202b}', '\u{202c}', '\u{202d}', '\u{202e}', '\u{2066}', '\u{2067}', '\u{2068}', '\u{2069}'];

/// A text in one line that is no Markdown but what it says: `a*b*c` has its stars, `s[1]` is no link.
#[must_use]
pub fn plain(text: &str) -> String {
    let line = one_line(text);
    let mut shown = String::with_capacity(line.len());
    for (at, letter) in line.char_indices() {
        if is_special(&line, at, letter) {
            shown.push('\\');
        }
        shown.push(letter);
    }
    shown
}

/// A text in one line as code.
#[must_use]
pub fn code(text: &str) -> String {
    let line = one_line(text);
    let longest = line.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let (fence, blank) = ("`".repeat(longest + 1), if longest == 0 { "" } else { " " });
    format!("{fence}{blank}{line}{blank}{fence}")
}

/// A text in one line, without letters that no comment may hold.
#[must_use]
pub fn one_line(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    line.replace(|c: char| c.is_control() || TURNING.contains(&c), "\u{fffd}")
}

/// Whether Markdown, or what rustdoc makes of it, would read more than the letter here.
fn is_special(line: &str, at: usize, letter: char) -> bool {
    let (before, after) = (&line[..at], &line[at + letter.len_utf8()..]);
    match letter {
        '*' | '[' | '`' | '\\' | '~' | '|' => true,
        '<' => after.starts_with(|c: char| c.is_ascii_alphabetic() || matches!(c, '/' | '!' | '?')),
        // inside a word it is a letter
        '_' => !(before.ends_with(char::is_alphanumeric) && after.starts_with(char::is_alphanumeric)),
        '&' => after.starts_with(|c: char| c == '#' || c.is_ascii_alphabetic()),
        ':' => after.starts_with("//"), // an address
        '-' => before.is_empty() || before.ends_with('-'),
        '.' => before.ends_with('.') || is_list_number(before, after),
        ')' => is_list_number(before, after),
        '#' | '+' | '=' | '>' => before.is_empty(),
        _ => false,
    }
}

/// Whether a number at the start of a line would begin a list with the letter after it.
fn is_list_number(before: &str, after: &str) -> bool {
    let ends = after.is_empty() || after.starts_with(' ');
    ends && !before.is_empty() && before.len() < 10 && before.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_keep_their_letters() {
        assert_eq!(plain("v0 = kv0*x4/t1 and v3 = kv3*x4/t1"), r"v0 = kv0\*x4/t1 and v3 = kv3\*x4/t1");
        assert_eq!(plain("From s5ST[1], by t_in and _x_"), r"From s5ST\[1], by t_in and \_x\_");
        assert_eq!(plain("if a < b & c > d, Vec<f64>"), r"if a < b & c > d, Vec\<f64>");
        assert_eq!(plain("&lt; `code` C:\\"), r"\&lt; \`code\` C:\\");
        assert_eq!(plain("see https://a.b/c_d, 1...2, a--b ~~c~~"), r"see https\://a.b/c_d, 1.\.\.2, a-\-b \~\~c\~\~");
    }

    #[test]
    fn a_line_begins_with_no_heading_list_or_quote() {
        for line in ["# a", "- a", "+ a", "> a", "=", "* a"] {
            assert_eq!(plain(line), format!("\\{line}"));
        }
        assert_eq!(
            (plain("1. a"), plain("12) a"), plain("2.3.1 %o50")),
            (r"1\. a".into(), r"12\) a".into(), "2.3.1 %o50".into())
        );
    }

    #[test]
    fn a_text_is_one_line_whatever_it_holds() {
        assert_eq!(plain(" a\n\nb\r\n\tc "), "a b c");
        assert_eq!(one_line("a\u{0}b\u{202e}c"), "a\u{fffd}b\u{fffd}c");
        assert_eq!((code("a*b"), code("a`b"), code("``")), ("`a*b`".into(), "`` a`b ``".into(), "``` `` ```".into()));
    }
}
