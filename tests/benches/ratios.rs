//! What calls cost, in one run: for each kernel the time of the default, the faithful and the fast call, and of a row of both
//! batches, and their ratios.

use std::hint::black_box;
use std::time::Instant;

use closedform::LengthError;
use closedform_tests::check::Judge;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels;

/// Points of each kernel.
const POINTS: usize = 256;

/// How often they are gone through; the fastest round counts.
const ROUNDS: usize = 50;

fn main() {
    let heads = ["default", "faithful", "fast", "row", "fast row"];
    println!(
        "{:<44}{}{:>11}{:>7}{:>7}",
        "kernel, ns",
        heads.map(|head| format!("{head:>10}")).concat(),
        "faithful/",
        "fast/",
        "rows/"
    );
    let mut logarithms = [0.0; 3];
    let judges = kernels::judges();
    for judge in &judges {
        let times = times(judge);
        let [default, faithful, fast, row, fast_row] = times;
        let ratios = [faithful / default, fast / default, fast_row / row];
        let columns = times.map(|time| format!("{time:>10.1}")).concat();
        println!("{:<44}{columns}{:>11.2}{:>7.2}{:>7.2}", judge.kernel.info.name, ratios[0], ratios[1], ratios[2]);
        logarithms = [0, 1, 2].map(|at| logarithms[at] + ratios[at].ln());
    }
    let means = logarithms.map(|sum: f64| (sum / judges.len() as f64).exp());
    println!("{:<94}{:>11.2}{:>7.2}{:>7.2}", "geometric mean", means[0], means[1], means[2]);
}

/// Nanoseconds of a default, a faithful and a fast call, and of a row of a batch and of a fast one.
fn times(judge: &Judge) -> [f64; 5] {
    let kernel = judge.kernel;
    let points = judge.space.inside(Maker::Octaves, 1, POINTS).list;
    let mut results = vec![0.0; kernel.info.results.len()];
    let columns: Vec<Vec<f64>> =
        (0..kernel.info.inputs.len()).map(|input| points.iter().map(|point| point[input]).collect()).collect();
    let inputs: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let mut rows = vec![vec![0.0; points.len()]; results.len()];
    let mut rows: Vec<&mut [f64]> = rows.iter_mut().map(Vec::as_mut_slice).collect();
    let a_row =
        |batch: &mut dyn FnMut() -> Result<(), LengthError>| fastest(&[Vec::new()], |_| batch()) / points.len() as f64;
    [
        fastest(&points, |point| kernel.eval(point, &mut results)),
        fastest(&points, |point| kernel.faithful(point, &mut results)),
        fastest(&points, |point| kernel.fast(point, &mut results)),
        a_row(&mut || kernel.batch(black_box(&inputs), &mut rows)),
        a_row(&mut || kernel.fast_batch(black_box(&inputs), &mut rows)),
    ]
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
