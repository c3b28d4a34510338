//! Rule `certified`: a formula for which no stable form is found is left as it is, and every call bounds its own error.

use crate::stable::rule::Rule;

/// The rule.
pub const RULE: Rule = Rule {
    name: "certified",
    statement: "the formula as it is written, in balls of 256, 1,024 or 4,096 bits: a call takes as many as it needs",
    condition: "no other form is found and proved within the limits of the generator's work",
};
