//! Text in lines, with indentation: what all printers write to.

/// How wide a line of documentation may be.
const WIDTH: usize = 110;

/// Lines as they are printed.
#[derive(Clone, Debug, Default)]
pub struct Lines {
    text: String,
    depth: usize,
}

impl Lines {
    /// One line; an empty one has no indentation.
    pub fn line(&mut self, line: impl AsRef<str>) -> &mut Self {
        let line = line.as_ref();
        if !line.is_empty() {
            self.text.push_str(&"    ".repeat(self.depth));
            self.text.push_str(line);
        }
        self.text.push('\n');
        self
    }

    /// What `write` writes, one step further in.
    pub fn indented(&mut self, write: impl FnOnce(&mut Self)) -> &mut Self {
        self.depth += 1;
        write(self);
        self.depth -= 1;
        self
    }

    /// Words in as many lines as they need, each behind `lead`.
    pub fn wrapped(&mut self, lead: &str, text: &str) -> &mut Self {
        let mut line = String::new();
        for word in text.split_whitespace() {
            if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > WIDTH {
                self.line(format!("{lead}{line}"));
                line.clear();
            }
            line += if line.is_empty() { "" } else { " " };
            line += word;
        }
        self.line(format!("{lead}{line}").trim_end())
    }

    /// All of it.
    pub fn text(self) -> String {
        self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_wrapped_and_blocks_indented() {
        let mut lines = Lines::default();
        lines.line("{").indented(|lines| {
            lines.wrapped("* ", &"word ".repeat(30)).line("");
        });
        lines.line("}");
        let text = lines.text();
        let all: Vec<&str> = text.lines().collect();
        assert_eq!((all[0], all[3], all[4]), ("{", "", "}"));
        assert!(all[1..3].iter().all(|line| line.starts_with("    * word") && line.len() <= 6 + WIDTH), "{text}");
    }
}
