//! A call of a table, in balls of more and more words until everything is decided.

use super::format::Table;
use super::machine::{End, Machine};
use crate::ball::{Ball, Decisions};
use crate::factored::Stack;
use crate::rounded::Certified;

/// Whether inputs lie in the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// They do.
    Inside,
    /// They violate the condition at this position. It is the first that they violate, unless the largest balls do not tell
    /// of one before it.
    Outside(usize),
    /// The largest balls do not tell.
    Undecided,
}

/// How near results have to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Off by [`CERTIFIED_ULP`](crate::error_model::CERTIFIED_ULP) at most.
    Certified,
    /// The nearest numbers, wherever balls tell which they are; else as certified ones. They do not tell of a result
    /// that lies half-way between two numbers and is not shown to.
    Nearest,
}

/// What a program answers to inputs, which must be finite: whether they lie in the domain, and the results if they do.
///
/// Nothing is allocated; the stack that it takes grows with the registers of the table.
pub fn settle(table: &Table, inputs: &[f64], aim: Aim, results: &mut [Certified]) -> Domain {
    match table.registers {
        0..=16 => in_registers::<16>(table, inputs, aim, results),
        17..=32 => in_registers::<32>(table, inputs, aim, results),
        _ => in_registers::<64>(table, inputs, aim, results),
    }
}

fn in_registers<const R: usize>(table: &Table, inputs: &[f64], aim: Aim, results: &mut [Certified]) -> Domain {
    let found = in_balls::<4, R>(table, inputs, aim, results, cfg!(not(feature = "large-balls")));
    #[cfg(feature = "large-balls")]
    let found = found
        .or_else(|| in_balls::<8, R>(table, inputs, aim, results, false))
        .or_else(|| in_balls::<16, R>(table, inputs, aim, results, false))
        .or_else(|| in_balls::<32, R>(table, inputs, aim, results, true));
    found.unwrap_or(Domain::Undecided)
}

/// The answer in balls of `L` words; `None` where they are too few and not the last.
#[inline(never)]
fn in_balls<const L: usize, const R: usize>(
    table: &Table,
    inputs: &[f64],
    aim: Aim,
    results: &mut [Certified],
    last: bool,
) -> Option<Domain> {
    let decisions = Decisions::default();
    let mut registers: [Ball<L>; R] = core::array::from_fn(|_| Ball::unknown(&decisions));
    run(table, inputs, aim, results, last, &mut registers, &decisions)
}

#[inline(never)]
fn run<'s, const L: usize>(
    table: &Table,
    inputs: &[f64],
    aim: Aim,
    results: &mut [Certified],
    last: bool,
    registers: &mut [Ball<'s, L>],
    decisions: &'s Decisions,
) -> Option<Domain> {
    results.fill(Certified::UNDECIDED);
    let (missing, truths) = (Ball::unknown(decisions), Stack::new());
    let mut machine = Machine { table, inputs, registers, decisions, last, missing, truths, overflows: false };
    let end = machine.run(|position, ball| {
        let nearest = ball.certified(aim == Aim::Nearest);
        let found = if last { nearest.or_else(|| ball.certified(false)) } else { nearest };
        if let (Some(place), Some(found)) = (results.get_mut(position), found) {
            *place = found;
        }
        found.is_some()
    });
    match end {
        End::Results => Some(Domain::Inside),
        End::Outside(condition) => Some(Domain::Outside(condition)),
        End::OpenResults => last.then_some(Domain::Inside),
        End::OpenDomain => last.then_some(Domain::Undecided),
    }
}
