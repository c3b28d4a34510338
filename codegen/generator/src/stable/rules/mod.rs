//! The rules: named rewrites that keep digits, each with the condition under which it holds.

pub mod certified;
pub mod compensated;
pub mod conjugate;
pub mod differences_first;
pub mod distributed;
pub mod double_double;
pub mod factored;
pub mod falling_newton;
pub mod gathered;
pub mod known_sum;
pub mod merge_roots;
pub mod one_reciprocal;
pub mod same_sign_radicand;
pub mod sign_branch;
pub mod through_result;

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

/// Every rule, in alphabetical order.
pub const ALL: [&Rule; 15] = [
    &certified::RULE,
    &compensated::RULE,
    &conjugate::RULE,
    &differences_first::RULE,
    &distributed::RULE,
    &double_double::RULE,
    &factored::RULE,
    &falling_newton::RULE,
    &gathered::RULE,
    &known_sum::RULE,
    &merge_roots::RULE,
    &one_reciprocal::RULE,
    &same_sign_radicand::RULE,
    &sign_branch::RULE,
    &through_result::RULE,
];
