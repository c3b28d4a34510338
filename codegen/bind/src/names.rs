//! Names in another language: letters that it knows, none of its keywords, none twice.

use crate::error::BindError;
use std::collections::{BTreeMap, BTreeSet};

/// Names of one scope, each once: arguments of a function, fields of a struct.
pub struct Scope<'a> {
    keywords: &'a [&'a str],
    taken: BTreeSet<String>,
}

impl<'a> Scope<'a> {
    /// A scope of a language with these keywords.
    pub fn new(keywords: &'a [&'a str]) -> Self {
        Self { keywords, taken: BTreeSet::new() }
    }

    /// The name as the language takes it; as many `_` behind it as it needs to be none that is taken.
    pub fn name(&mut self, name: &str) -> String {
        let mut name = identifier(name);
        while self.keywords.contains(&name.as_str()) || self.taken.contains(&name) {
            name.push('_');
        }
        self.taken.insert(name.clone());
        name
    }
}

/// A Rust name in letters that every language knows. What is none becomes its number.
pub fn identifier(name: &str) -> String {
    let name = name.strip_prefix("r#").unwrap_or(name);
    let mut letters = String::with_capacity(name.len());
    for letter in name.chars() {
        match letter {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '_' => letters.push(letter),
            '-' => letters.push('_'),
            _ => letters += &format!("u{:04x}", u32::from(letter)),
        }
    }
    if letters.starts_with(|first: char| first.is_ascii_digit()) { format!("_{letters}") } else { letters }
}

/// Names that a whole program shares, and what each stands for.
#[derive(Default)]
pub struct Symbols {
    owners: BTreeMap<String, String>,
}

impl Symbols {
    /// Takes a name for `owner`.
    ///
    /// # Errors
    ///
    /// When it is taken already.
    pub fn take(&mut self, name: &str, owner: &str) -> Result<(), BindError> {
        match self.owners.insert(name.to_owned(), owner.to_owned()) {
            None => Ok(()),
            Some(first) => Err(BindError::Clash { name: name.to_owned(), first, second: owner.to_owned() }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_no_keywords_and_none_occurs_twice() {
        let mut scope = Scope::new(&["int", "double"]);
        let names = ["r#type", "int", "int_", "double", "größe", "int"].map(|name| scope.name(name));
        assert_eq!(names, ["type", "int_", "int__", "double_", "gru00f6u00dfe", "int___"]);
        assert_eq!(identifier("my-crate"), "my_crate");
    }

    #[test]
    fn a_clash_names_both() {
        let mut symbols = Symbols::default();
        symbols.take("p_a_batch", "a::batch").unwrap();
        let said = symbols.take("p_a_batch", "the batch of a").unwrap_err().to_string();
        assert_eq!(said, "`a::batch` and `the batch of a` would both be called `p_a_batch`");
    }
}
