//! Mistakes by name: the step of a kernel, the kind of mistake, and which one of that kind in the step.

use std::fmt;

/// Something with one mistake, and what kind of mistake it is.
#[derive(Clone, Debug)]
pub struct Wrong<T> {
    /// The kind, in words.
    pub kind: String,
    /// What has the mistake.
    pub value: T,
}

impl<T> Wrong<T> {
    /// A value with a mistake of this kind.
    pub fn new(kind: impl Into<String>, value: T) -> Self {
        Wrong { kind: kind.into(), value }
    }

    /// What is made of the value has the mistake, too.
    pub fn map<U>(self, make: impl FnOnce(T) -> U) -> Wrong<U> {
        Wrong { kind: self.kind, value: make(self.value) }
    }

    /// The same where something can be made of the value.
    pub fn filter_map<U>(self, make: impl FnOnce(T) -> Option<U>) -> Option<Wrong<U>> {
        Some(Wrong { kind: self.kind, value: make(self.value)? })
    }
}

/// A mistake of a kernel; other statements and their names do not matter to it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Mistake {
    /// The step: `condition 2`, `let root`, `result`, `result t1`; or `inputs`, `results`, `bounds`.
    pub step: String,
    /// The kind and which one of its kind in the step.
    pub kind: Nth,
}

/// A kind of mistake, and which one of them, from 1: `>= as >`, and the second one `>= as > #2`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Nth {
    kind: String,
    nth: usize,
}

impl Nth {
    /// The `nth` mistake of a kind.
    pub fn new(kind: &str, nth: usize) -> Self {
        Nth { kind: kind.to_owned(), nth }
    }

    /// What `text` names.
    pub fn parse(text: &str) -> Self {
        let counted = text.rsplit_once(" #").and_then(|(kind, nth)| Some(Self::new(kind, nth.parse().ok()?)));
        counted.unwrap_or_else(|| Self::new(text, 1))
    }

    /// Which one each of these mistakes is of its kind, in their order.
    pub fn count<T>(wrong: &[Wrong<T>]) -> Vec<Nth> {
        let before = |at: usize| wrong[..at].iter().filter(|other| other.kind == wrong[at].kind).count();
        (0..wrong.len()).map(|at| Self::new(&wrong[at].kind, before(at) + 1)).collect()
    }
}

impl fmt::Display for Nth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.nth {
            1 => f.write_str(&self.kind),
            nth => write!(f, "{} #{nth}", self.kind),
        }
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.step, self.kind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mistakes_are_counted_by_their_kind() {
        let wrong = ["a", "b", "a", "a"].map(|kind| Wrong::new(kind, ()));
        let texts: Vec<String> = Nth::count(&wrong).iter().map(Nth::to_string).collect();
        assert_eq!(texts, ["a", "b", "a #2", "a #3"]);
    }

    #[test]
    fn what_is_printed_is_read() {
        for nth in [Nth::new(">= as >", 1), Nth::new("> as >=", 12), Nth::new("#", 2)] {
            assert_eq!(Nth::parse(&nth.to_string()), nth);
        }
    }
}
