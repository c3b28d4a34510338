//! What calls cost: for each kernel the time of the plain and of the faithful call, and their ratio, measured in one run.

use std::hint::black_box;
use std::time::Instant;

use closedform::LengthError;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels;

/// Points of each kernel.
const POINTS: usize = 256;

/// How often they are gone through; the fastest round counts.
const ROUNDS: usize = 50;

fn main() {
    println!("{:<44} {:>9} {:>9} {:>6}", "kernel", "plain/ns", "faithful", "ratio");
    let mut logarithms = Vec::new();
    for judge in kernels::judges() {
        let kernel = judge.kernel;
        let points = judge.space.inside(Maker::Octaves, 1, POINTS).list;
        let mut results = vec![0.0; kernel.info.results.len()];
        let plain = fastest(&points, |point| kernel.eval(point, &mut results));
        let faithful = fastest(&points, |point| kernel.faithful(point, &mut results));
        println!("{:<44} {plain:>9.1} {faithful:>9.1} {:>6.2}", kernel.info.name, faithful / plain);
        logarithms.push((faithful / plain).ln());
    }
    let mean = logarithms.iter().sum::<f64>() / logarithms.len() as f64;
    println!("{:<44} {:>26.2}", "geometric mean", mean.exp());
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
