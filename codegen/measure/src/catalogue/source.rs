//! Slices of a source: the exact text of one function.

/// The text of the function `name`, from its `fn` line to the brace that closes it; empty if there is none.
pub fn function_text<'a>(text: &'a str, name: &str) -> &'a str {
    let mut begin = None;
    for (offset, line) in lines(text) {
        match begin {
            None if declares(line, name) => begin = Some((offset, indentation(line))),
            Some((begin, indented)) if line.trim() == "}" && indentation(line) == indented => {
                return &text[begin..offset + line.trim_end().len()];
            }
            _ => {}
        }
    }
    ""
}

/// Every line with its offset.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.split_inclusive('\n').scan(0, |end, line| {
        *end += line.len();
        Some((*end - line.len(), line))
    })
}

fn declares(line: &str, name: &str) -> bool {
    let Some((before, after)) = line.split_once("fn ") else { return false };
    let visible = before.trim().is_empty() || before.trim().starts_with("pub");
    visible && after.strip_prefix(name).is_some_and(|rest| rest.starts_with('('))
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slice_is_the_whole_function() {
        let (short, long) =
            ("pub fn ff(x: f64) -> f64 {\n    x\n}", "pub fn f(\n    x: f64,\n) -> S {\n    S {\n        x,\n    }\n}");
        let text = format!("/// `pub fn f(`\n{short}\n\n{long}\n");
        assert_eq!(function_text(&text, "f"), long);
        assert_eq!(function_text(&text, "ff"), short);
        assert_eq!(function_text(&text, "g"), "");
    }
}
