//! Solved kernels put back into what they solve.

mod five_segment;
mod fly_axis;
mod look_ahead;
mod milling_time;
mod optimum;
mod overhead;
mod pvt;
mod return_path;
mod s_curve;
mod step_move;
mod turnaround;
mod waypoints;

use closedform_tests::budget::budget;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels::judge_of;
use closedform_tests::laws::chain::{Chain, Claim};
use closedform_tests::laws::motion::Motion;
use closedform_tests::laws::{Law, check_inverse};
use closedform_tests::random::seed;

const MAKERS: [Maker; 3] = [Maker::Logarithmic, Maker::NearEqual, Maker::Reals];

/// A kernel and names of its results.
fn kernel(kernel: &str, results: &[&'static str]) -> Chain {
    Chain::new(&judge_of(kernel), results)
}

/// Demands laws of a kernel: Maxima text of its inputs and of its results, by these names.
fn demand(name: &str, results: &[&'static str], laws: &[&str]) {
    demand_of(&kernel(name, results), laws);
}

/// Demands laws of kernels that take each other's results.
fn demand_of(chain: &Chain, laws: &[&str]) {
    let laws: Vec<Law> = laws.iter().map(|law| Law::new(law)).collect();
    let claims: Vec<&dyn Claim> = laws.iter().map(|law| law as &dyn Claim).collect();
    check(chain, &claims);
}

/// Demands that a move, integrated forward from its start, comes to where it says after each of its segments.
fn demand_motion(chain: &Chain, motion: &Motion) {
    check(chain, &[motion]);
}

/// The same of the moves of two axes that share their times.
fn demand_motions(chain: &Chain, one: &Motion, other: &Motion) {
    check(chain, &[one, other]);
}

fn check(chain: &Chain, claims: &[&dyn Claim]) {
    for maker in MAKERS {
        let points = chain.points(maker, seed(), budget().laws);
        chain.check(&points, claims).unwrap_or_else(|broken| panic!("{broken}"));
    }
}

/// Demands that the second kernel undoes the first; each comes with the name of its result.
fn demand_inverse(first: (&str, &'static str), second: (&str, &'static str), constants: &[(&'static str, &str)]) {
    let (one, two) = (judge_of(first.0), judge_of(second.0));
    for maker in MAKERS {
        let points = one.space.inside(maker, seed(), budget().laws);
        check_inverse((&one, first.1), (&two, second.1), constants, &points)
            .unwrap_or_else(|broken| panic!("{broken}"));
    }
}
