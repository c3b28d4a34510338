//! Batches: many points, one slice an input and one a result, by blocks of rows.
//!
//! The first tier runs over all rows of a block, with no branch, so that compilers vectorise it; the rows that escalate are computed
//! again, one by one. Where the processor has wider registers and a fused multiply-add than all of its kind have to have, which is seen
//! when a program runs, blocks use them: with the same bits.

use core::cell::Cell;

#[cfg(all(feature = "std", target_arch = "x86_64"))]
use multiversion::{multiversion, target::target_cfg_f};

use crate::blocks::{BLOCK, Column, block, padded, raised, starts};
use crate::error::LengthError;
use crate::fast::{fast_again, fast_first_tier};
use crate::info::Info;
use crate::program::{Program, positions};
use crate::shape::{decided, first_tier, same_length};

/// What a batch returns of a row.
trait Shape {
    /// The results, unless `escalate` is raised.
    fn first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
        inputs: &[f64; N],
        escalate: &Cell<u64>,
    ) -> [f64; M];

    /// The results of a row that escalates.
    fn again<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M];
}

/// What a default call returns.
struct DefaultCall;

/// What `fast` returns.
struct FastCall;

impl Shape for DefaultCall {
    #[inline(always)]
    fn first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
        inputs: &[f64; N],
        escalate: &Cell<u64>,
    ) -> [f64; M] {
        first_tier::<P, N, K, M, FUSED>(inputs, escalate)
    }

    fn again<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
        decided::<P, N, K, M>(inputs)
    }
}

impl Shape for FastCall {
    /// Its arithmetic knows no products of two numbers.
    #[inline(always)]
    fn first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
        inputs: &[f64; N],
        escalate: &Cell<u64>,
    ) -> [f64; M] {
        fast_first_tier::<P, N, K, M>(inputs, escalate)
    }

    fn again<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
        fast_again::<P, N, K, M>(inputs)
    }
}

/// The values of many points, bit for bit those of single calls.
pub fn batch<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: [&[f64]; N],
    results: [&mut [f64]; M],
) -> Result<(), LengthError> {
    by_blocks::<DefaultCall, P, N, K, M>(inputs, results)
}

/// What `fast` returns of many points.
pub fn fast_batch<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: [&[f64]; N],
    results: [&mut [f64]; M],
) -> Result<(), LengthError> {
    by_blocks::<FastCall, P, N, K, M>(inputs, results)
}

/// A batch, block by block; nothing is written where slices are not of one length.
fn by_blocks<S: Shape, P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: [&[f64]; N],
    mut results: [&mut [f64]; M],
) -> Result<(), LengthError> {
    let length = common_length(P::INFO, &inputs, &results)?;
    let mut computed = [[0.0; BLOCK]; M];
    for start in starts(length) {
        rows::<S, P, N, K, M>(inputs.map(|rows| block(rows, start)), &mut computed);
        results.iter_mut().zip(&computed).for_each(|(rows, column)| store(rows, start, column));
    }
    if 0 < length && length < BLOCK {
        let columns = inputs.map(padded);
        rows::<S, P, N, K, M>(columns.each_ref(), &mut computed);
        results.iter_mut().zip(&computed).for_each(|(rows, column)| store(rows, 0, column));
    }
    Ok(())
}

/// Writes the results of a block.
fn store(rows: &mut [f64], start: usize, column: &Column) {
    rows.iter_mut().skip(start).zip(column).for_each(|(to, from)| *to = *from);
}

/// How many points there are: as many as the first slice has numbers.
fn common_length(info: &'static Info, inputs: &[&[f64]], results: &[&mut [f64]]) -> Result<usize, LengthError> {
    let lengths = inputs.iter().map(|rows| rows.len()).chain(results.iter().map(|rows| rows.len()));
    let names = info.inputs.iter().map(|input| input.name).chain(info.results.iter().map(|result| result.name));
    let length = inputs.first().map_or(0, |rows| rows.len());
    names.zip(lengths).try_for_each(|(name, found)| same_length(info.name, name, length, found))?;
    Ok(length)
}

/// The results of a block.
fn rows<S: Shape, P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: [&Column; N],
    results: &mut [Column; M],
) {
    let mut escalated = [0; BLOCK];
    if first_tier_of_rows::<S, P, N, K, M>(inputs, results, &mut escalated) == 0 {
        return;
    }
    for row in raised(&escalated) {
        let values = S::again::<P, N, K, M>(&inputs.map(|column| column.get(row).copied().unwrap_or(f64::NAN)));
        for (column, value) in results.iter_mut().zip(values) {
            column.iter_mut().skip(row).take(1).for_each(|slot| *slot = value);
        }
    }
}

/// The first tier of all rows, and which of them escalate, with the instructions that the processor has.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[multiversion(targets("x86_64+avx2+fma"))]
fn first_tier_of_rows<S: Shape, P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: [&Column; N],
    results: &mut [Column; M],
    escalated: &mut [u64; BLOCK],
) -> u64 {
    if target_cfg_f!(target_feature = "fma") {
        each_row::<S, P, N, K, M, true>(inputs, results, escalated)
    } else {
        each_row::<S, P, N, K, M, false>(inputs, results, escalated)
    }
}

/// The first tier of all rows, and which of them escalate, with the instructions that all processors of the target have.
#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
#[inline(never)]
fn first_tier_of_rows<S: Shape, P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: [&Column; N],
    results: &mut [Column; M],
    escalated: &mut [u64; BLOCK],
) -> u64 {
    each_row::<S, P, N, K, M, { closedform_arith::FUSED }>(inputs, results, escalated)
}

/// The loop that is vectorised: arrays of a known length need no bounds checks, and results are one argument of their own, which
/// overlaps no other.
#[inline(always)]
fn each_row<S: Shape, P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
    inputs: [&Column; N],
    results: &mut [Column; M],
    escalated: &mut [u64; BLOCK],
) -> u64 {
    let mut any = 0;
    for row in 0..BLOCK {
        let escalate = Cell::new(0);
        let point = P::each_input(const { positions() }, |input| inputs[input][row]);
        let values = S::first_tier::<P, N, K, M, FUSED>(&point, &escalate);
        P::each_result(const { positions() }, |result| results[result][row] = values[result]);
        escalated[row] = escalate.get();
        any |= escalate.get();
    }
    any
}
