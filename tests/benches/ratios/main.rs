//! What calls cost, in one run: for each kernel the formula as written, compiled with the same flags, and how many times as long the
//! default, the fast and the faithful call take, and rows of batches.
//!
//! Names of kernels, or parts of names, choose some: `cargo bench -p closedform-tests --bench ratios -- t_in`.

use std::hint::black_box;
use std::time::Instant;

use closedform::LengthError;
use closedform_tests::check::Judge;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels;

/// Rows that are computed together, as in batches of kernels: compilers vectorise loops over arrays of a known length.
const BLOCK: usize = 32;

/// A number of each row of a block.
type Column = [f64; BLOCK];

/// The formula as written, with all its results.
struct AsWritten {
    call: fn(&[f64], &mut [f64]),
    rows: fn(&[&[f64]], &mut [&mut [f64]]),
}

/// The function `as_written`, which finds a formula by the name of its kernel.
macro_rules! formulas {
    ($($name:literal [$($input:ident),*] => [$($result:expr,)*];)*) => {
        pub fn as_written(name: &str) -> Option<crate::AsWritten> {
            match name {
                $($name => {
                    const RESULTS: usize = [$(stringify!($result)),*].len();
                    #[inline(always)]
                    fn one($($input: f64),*) -> [f64; RESULTS] {
                        [$($result),*]
                    }
                    #[inline(never)]
                    fn block($($input: &crate::Column,)* results: &mut [crate::Column; RESULTS]) {
                        for row in 0..crate::BLOCK {
                            let values = one($($input[row]),*);
                            results.iter_mut().zip(values).for_each(|(column, value)| column[row] = value);
                        }
                    }
                    Some(crate::AsWritten {
                        call: |inputs, results| {
                            let [$($input),*] = inputs else { panic!("as many inputs as the kernel has") };
                            results.copy_from_slice(&one($(*$input),*));
                        },
                        rows: |inputs, results| {
                            let [$($input),*] = inputs else { panic!("as many inputs as the kernel has") };
                            let mut columns = [[0.0; crate::BLOCK]; RESULTS];
                            for start in (0..results[0].len()).step_by(crate::BLOCK) {
                                block($($input[start..].first_chunk().expect("whole blocks"),)* &mut columns);
                                for (result, column) in results.iter_mut().zip(&columns) {
                                    result[start..][..crate::BLOCK].copy_from_slice(column);
                                }
                            }
                        },
                    })
                })*
                _ => None,
            }
        }
    };
}

#[allow(unused_parens, clippy::all, reason = "printed, so that operations are taken in the order of the text")]
mod as_written;

/// Points of each kernel: whole blocks.
const POINTS: usize = 32 * BLOCK;

/// How often they are gone through; the fastest round counts.
const ROUNDS: usize = 50;

/// What is timed beside the formula as written.
const HEADS: [&str; 5] = ["call: default", "fast", "faithful", "row: default", "fast"];

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let heads = HEADS.map(|head| format!("{head:>15}")).concat();
    println!("{:<52}{:>9}{:>9}{heads}", "kernel: ns of a call and a row as written, ratios", "call", "row");
    let mut logarithms = [0.0; HEADS.len()];
    let mut count = 0.0;
    for judge in &kernels::judges() {
        let name = judge.kernel.info.name;
        let Some(formula) = as_written::as_written(name) else { continue };
        if !chosen.is_empty() && !chosen.iter().any(|part| name.contains(part.as_str())) {
            continue;
        }
        let Times { as_written: [call, row], ratios } = times(judge, &formula);
        println!("{name:<52}{call:>9.1}{row:>9.1}{}", ratios.map(|ratio| format!("{ratio:>15.2}")).concat());
        logarithms.iter_mut().zip(ratios).for_each(|(sum, ratio)| *sum += ratio.ln());
        count += 1.0;
    }
    let means = logarithms.map(|sum: f64| format!("{:>15.2}", (sum / count).exp()));
    println!("{:<70}{}", "geometric means", means.concat());
}

/// Nanoseconds of the formula as written, a call and a row, and the ratios of [`HEADS`].
struct Times {
    as_written: [f64; 2],
    ratios: [f64; HEADS.len()],
}

fn times(judge: &Judge, formula: &AsWritten) -> Times {
    let kernel = judge.kernel;
    let points = judge.space.inside(Maker::Logarithmic, 1, POINTS).list;
    let mut results = vec![0.0; kernel.info.results.len()];
    let columns: Vec<Vec<f64>> =
        (0..kernel.info.inputs.len()).map(|input| points.iter().map(|point| point[input]).collect()).collect();
    let inputs: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let mut rows = vec![vec![0.0; points.len()]; results.len()];
    let mut rows: Vec<&mut [f64]> = rows.iter_mut().map(Vec::as_mut_slice).collect();
    let call = fastest(&points, |point| {
        (formula.call)(point, &mut results);
        Ok(())
    });
    let calls = [
        fastest(&points, |point| kernel.eval(point, &mut results)),
        fastest(&points, |point| kernel.fast(point, &mut results)),
        fastest(&points, |point| kernel.faithful(point, &mut results)),
    ];
    let a_row =
        |batch: &mut dyn FnMut() -> Result<(), LengthError>| fastest(&[Vec::new()], |_| batch()) / points.len() as f64;
    let row = a_row(&mut || {
        (formula.rows)(black_box(&inputs), &mut rows);
        Ok(())
    });
    let batches = [
        a_row(&mut || kernel.batch(black_box(&inputs), &mut rows)),
        a_row(&mut || kernel.fast_batch(black_box(&inputs), &mut rows)),
    ];
    let [default, fast, faithful] = calls.map(|time| time / call);
    let [default_row, fast_row] = batches.map(|time| time / row);
    Times { as_written: [call, row], ratios: [default, fast, faithful, default_row, fast_row] }
}

/// Nanoseconds a call in the fastest round.
fn fastest(points: &[Vec<f64>], mut call: impl FnMut(&[f64]) -> Result<(), LengthError>) -> f64 {
    let round = |_| {
        let begin = Instant::now();
        points.iter().for_each(|point| {
            black_box(call(black_box(point))).expect("as many inputs and results as the kernel has");
        });
        begin.elapsed().as_nanos() as f64 / points.len() as f64
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}
