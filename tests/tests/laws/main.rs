//! Solved kernels put back into what they solve.

mod fly_axis;
mod milling_time;
mod optimum;
mod overhead;
mod pvt;
mod return_path;
mod turnaround;
mod waypoints;

use closedform_tests::budget::budget;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels::{judge_of, judges};
use closedform_tests::laws::{Law, check_inverse};
use closedform_tests::random::seed;
use closedform_tests::scaling::check_scaling;

const MAKERS: [Maker; 3] = [Maker::Logarithmic, Maker::NearEqual, Maker::Reals];

/// Demands laws of a kernel: Maxima text of its inputs and of its results, by these names.
fn demand(kernel: &str, results: &[&str], laws: &[&'static str]) {
    let judge = judge_of(kernel);
    for maker in MAKERS {
        let points = judge.space.inside(maker, seed(), budget().laws);
        for law in laws {
            Law::new(law).check(&judge, results, &points).unwrap_or_else(|broken| panic!("{broken}"));
        }
    }
}

/// Demands that the second kernel undoes the first; each comes with the name of its result.
fn demand_inverse(first: (&str, &str), second: (&str, &str), constants: &[(&str, f64)]) {
    let (one, two) = (judge_of(first.0), judge_of(second.0));
    for maker in MAKERS {
        let points = one.space.inside(maker, seed(), budget().laws);
        check_inverse((&one, first.1), (&two, second.1), constants, &points)
            .unwrap_or_else(|broken| panic!("{broken}"));
    }
}

#[test]
fn units_scale_results_bit_for_bit() {
    for judge in judges() {
        for maker in Maker::ALL {
            let points = judge.space.inside(maker, seed(), budget().laws);
            check_scaling(judge.kernel, &points).unwrap_or_else(|broken| panic!("{broken}"));
        }
    }
}
