//! Rules: named rewrites that keep digits, each with the condition under which it holds.

/// A named rewrite.
#[derive(Debug, PartialEq, Eq)]
pub struct Rule {
    /// The name, as it stands in contracts, comments and ledgers.
    pub name: &'static str,
    /// What it does, as an equation where there is one.
    pub statement: &'static str,
    /// When it may be used.
    pub condition: &'static str,
}
