//! Why a plan cannot be made: the number that fails, by how much, and what to change.

/// Why a plan cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// An input that no plan can use.
    #[error("{name} is {value}: {remedy}")]
    Input {
        /// Which, as the field or flag is called.
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it must be.
        remedy: &'static str,
    },
    /// A limit that every plan of these inputs would exceed.
    #[error("{name} is limited to {}, and this move needs {}: {remedy}", with(*.limit, .unit), with(*.needed, .unit))]
    Limit {
        /// Which, as the field or flag is called.
        name: &'static str,
        /// What it may be.
        limit: f64,
        /// What it would have to be.
        needed: f64,
        /// Of both; empty where there is none.
        unit: &'static str,
        /// What to change.
        remedy: &'static str,
    },
    /// A jump of the acceleration, where the jerk is limited.
    #[error("jerk is limited to {limit:?} m/s^3, and the acceleration jumps by {jump:?} m/s^2 at {time:?} s: {remedy}")]
    Jump {
        /// Of the jerk, in m/s³.
        limit: f64,
        /// Of the acceleration, in m/s².
        jump: f64,
        /// When, in s.
        time: f64,
        /// What to change.
        remedy: &'static str,
    },
    /// One of several inputs that no plan can use.
    #[error("{item} {index}: {name} is {value}: {remedy}")]
    Item {
        /// What there are several of: a point, a segment.
        item: &'static str,
        /// Which, counted from 0.
        index: usize,
        /// What of it.
        name: &'static str,
        /// What that is.
        value: f64,
        /// What it must be.
        remedy: &'static str,
    },
    /// Points that cannot be joined.
    #[error("points {first} and {second} {why}: {remedy}")]
    Points {
        /// Counted from 0.
        first: usize,
        /// Counted from 0.
        second: usize,
        /// What is the matter with them.
        why: &'static str,
        /// What to change.
        remedy: &'static str,
    },
    /// The numbers are so large or so small that the plan is not representable.
    #[error("{what} is beyond the range of 64-bit numbers: scale lengths or times")]
    Range {
        /// What was computed.
        what: &'static str,
    },
}

/// A number and its unit, if it has one.
fn with(number: f64, unit: &str) -> String {
    // Debug prints the shortest digits that round-trip, and an exponent where that is shorter.
    if unit.is_empty() { format!("{number:?}") } else { format!("{number:?} {unit}") }
}
