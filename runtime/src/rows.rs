//! Batches by rows, one record a point: computed by columns, of few rows at a time.

use crate::blocks::BLOCK;
use crate::error::LengthError;
use crate::record::Record;
use crate::shape::same_length;

/// Rows whose columns stand on the stack together, in 256 bytes an input and a result: a block of a batch.
const ROWS: usize = BLOCK;

/// The results of `rows`, by a `batch` of columns; `result` makes one of its numbers.
#[inline]
pub fn rows<I: Record<N>, R, const N: usize, const M: usize>(
    kernel: &'static str,
    rows: &[I],
    results: &mut [R],
    result: impl Fn([f64; M]) -> R,
    batch: impl Fn([&[f64]; N], [&mut [f64]; M]) -> Result<(), LengthError>,
) -> Result<(), LengthError> {
    same_length(kernel, "results", rows.len(), results.len())?;
    for (rows, results) in rows.chunks(ROWS).zip(results.chunks_mut(ROWS)) {
        let (mut inputs, mut outputs) = ([[0.0; ROWS]; N], [[0.0; ROWS]; M]);
        for (position, row) in rows.iter().enumerate() {
            for (column, number) in inputs.iter_mut().zip(row.numbers()) {
                column.iter_mut().skip(position).take(1).for_each(|slot| *slot = number);
            }
        }
        let columns = inputs.each_ref().map(|column| column.get(..rows.len()).unwrap_or_default());
        batch(columns, outputs.each_mut().map(|column| column.get_mut(..rows.len()).unwrap_or_default()))?;
        for (position, slot) in results.iter_mut().enumerate() {
            *slot = result(outputs.each_ref().map(|column| column.get(position).copied().unwrap_or(f64::NAN)));
        }
    }
    Ok(())
}
