//! Assembly as a linker sees it: sections that keep one another alive.
//!
//! A section is everything from one section directive to the next: one function, or one constant. It reaches every symbol
//! that its text mentions. That errs on the side of reaching too much.

use std::collections::{BTreeMap, HashMap, VecDeque};

/// Directives that reach nothing: their operands are text, or symbols that they describe.
const IDLE: [&str; 10] =
    [".ascii", ".asciz", ".string", ".file", ".ident", ".type", ".size", ".globl", ".hidden", ".weak"];

/// The assembly of several crates.
#[derive(Debug, Default)]
pub struct Assembly {
    sections: Vec<Section>,
    /// Where each symbol is defined.
    homes: HashMap<String, usize>,
}

#[derive(Debug, Default)]
struct Section {
    mentions: Vec<Mention>,
}

#[derive(Debug)]
struct Mention {
    symbol: String,
    /// Whether it is an operand that only a symbol can be.
    certain: bool,
}

impl Assembly {
    /// Adds the assembly of a crate; local labels belong to its `file`.
    pub fn read(&mut self, file: &str, text: &str) {
        self.sections.push(Section::default());
        for line in text.lines().map(str::trim) {
            let directive = line.split_whitespace().next().unwrap_or_default();
            if [".section", ".text", ".data", ".bss"].contains(&directive) {
                self.sections.push(Section::default());
            } else if let Some(label) = line.strip_suffix(':') {
                self.homes.insert(global(file, label), self.sections.len() - 1);
            } else if let Some((alias, symbol)) = alias(line) {
                let mention = Mention { symbol: global(file, symbol.trim()), certain: true };
                self.homes.insert(global(file, alias.trim()), self.sections.len());
                self.sections.push(Section { mentions: vec![mention] });
                self.sections.push(Section::default());
            } else if !IDLE.contains(&directive)
                && let Some(section) = self.sections.last_mut()
            {
                section.mentions.extend(mentions(file, line));
            }
        }
    }

    /// Every symbol that is defined.
    pub fn symbols(&self) -> impl Iterator<Item = &str> {
        self.homes.keys().map(String::as_str)
    }

    /// Every symbol that `root` reaches and nothing here defines, with the way there.
    pub fn foreign(&self, root: &str) -> BTreeMap<&str, Vec<&str>> {
        let mut foreign = BTreeMap::new();
        let Some((root, &home)) = self.homes.get_key_value(root) else { return foreign };
        let mut ways: HashMap<usize, Vec<&str>> = HashMap::from([(home, vec![root.as_str()])]);
        let mut queue = VecDeque::from([home]);
        while let Some(section) = queue.pop_front() {
            let way = ways[&section].clone();
            for Mention { symbol, certain } in &self.sections[section].mentions {
                let way = || way.iter().copied().chain([symbol.as_str()]).collect::<Vec<_>>();
                match self.homes.get(symbol) {
                    Some(next) if !ways.contains_key(next) => {
                        ways.insert(*next, way());
                        queue.push_back(*next);
                    }
                    None if *certain => _ = foreign.entry(symbol.as_str()).or_insert_with(way),
                    _ => {}
                }
            }
        }
        foreign
    }
}

/// A symbol that is another one by a second name.
fn alias(line: &str) -> Option<(&str, &str)> {
    line.strip_prefix(".set").map_or_else(|| line.split_once(" = "), |both| both.split_once(','))
}

/// Everything in a line that can be a symbol.
fn mentions(file: &str, line: &str) -> Vec<Mention> {
    let mut mentions = Vec::new();
    let mut rest = line;
    while let Some(start) = rest.find(is_of_symbol) {
        rest = &rest[start..];
        let (symbol, after) = rest.split_at(rest.find(|c| !is_of_symbol(c)).unwrap_or(rest.len()));
        // Rust's names of either kind, and what goes through the tables of a linker.
        let certain = symbol.starts_with("_R") || symbol.starts_with("_ZN") || after.starts_with('@');
        mentions.push(Mention { symbol: global(file, symbol), certain });
        rest = after;
    }
    mentions
}

fn is_of_symbol(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '$')
}

fn global(file: &str, symbol: &str) -> String {
    if symbol.starts_with(".L") { format!("{file}{symbol}") } else { symbol.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_reached_is_found_through_calls_constants_and_aliases() {
        let mut assembly = Assembly::default();
        let code = "\t.section\t.text.f,\"ax\",@progbits\n\t.type\tf,@function\nf:\n\tleaq\t.Lanon.0(%rip), %rdi\n\
                    .LBB0_1:\n\tcallq\tg\n\tjmp\t.LBB0_1\n\
                    \t.type\tidle,@object\n\t.section\t.data.rel.ro..Lanon.0,\"aw\",@progbits\n.Lanon.0:\n\t.quad\th\n\
                    \t.section\t.text.idle,\"ax\",@progbits\nidle:\n\tjmpq\t*_RNvNvC4core9panicking@GOTPCREL(%rip)\n\
                    \t.set g, real2\nreal2 = real\n";
        let more = "\t.section\t.text.h,\"ax\",@progbits\nh:\n\tcallq\t*memcpy@GOTPCREL(%rip)\n\t.ascii\t\"idle\"\n\
                    \t.section\t.text.real,\"ax\",@progbits\nreal:\n\tcallq\t_ZN4core3fmt\n";
        assembly.read("a", code);
        assembly.read("b", more);
        let foreign = assembly.foreign("f");
        assert_eq!(foreign.keys().copied().collect::<Vec<_>>(), ["_ZN4core3fmt", "memcpy"]);
        assert_eq!(foreign["memcpy"], ["f", "a.Lanon.0", "h", "memcpy"]);
        assert_eq!(assembly.foreign("idle").len(), 1);
    }
}
