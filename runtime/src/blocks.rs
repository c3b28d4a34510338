//! Blocks of rows of a batch: arrays of one length, which loops over them know, cut from slices without a way to panic.

/// Rows that are computed together.
pub const BLOCK: usize = 32;

/// A number of each row of a block.
pub type Column = [f64; BLOCK];

/// Where the blocks of so many rows begin: one after another, and the last one so that it ends with the rows. It may overlap the one
/// before: what it computes twice is the same. None where there are fewer rows than a block has.
#[inline]
pub fn starts(rows: usize) -> impl Iterator<Item = usize> {
    let last = rows.checked_sub(BLOCK);
    let whole = (0..rows / BLOCK).map(|block| block * BLOCK);
    whole.chain(last.filter(|last| last % BLOCK != 0))
}

/// The block that begins at a row; NaN where none does.
#[inline]
pub fn block(rows: &[f64], start: usize) -> &Column {
    const NONE: Column = [f64::NAN; BLOCK];
    rows.get(start..).and_then(<[f64]>::first_chunk).unwrap_or(&NONE)
}

/// Fewer rows than a block has, and the first one again behind them.
#[inline]
pub fn padded(rows: &[f64]) -> Column {
    let mut column = [rows.first().copied().unwrap_or_default(); BLOCK];
    column.iter_mut().zip(rows).for_each(|(to, from)| *to = *from);
    column
}

/// Where flags are raised.
#[inline]
pub fn raised(flags: &[u64; BLOCK]) -> impl Iterator<Item = usize> {
    flags.iter().enumerate().filter(|(_, flag)| **flag != 0).map(|(row, _)| row)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    #[test]
    fn blocks_cover_all_rows_and_no_others() {
        for rows in 0..5 * BLOCK {
            let starts: Vec<usize> = starts(rows).collect();
            let covered = |row| starts.iter().any(|start| (*start..*start + BLOCK).contains(&row));
            assert_eq!((0..rows).all(covered), rows == 0 || rows >= BLOCK, "{rows}");
            assert!(!covered(rows) && starts.len() == if rows < BLOCK { 0 } else { rows.div_ceil(BLOCK) }, "{rows}");
        }
    }
}
