//! Solved kernels put back into what they solve: one test a law and the kernels that it takes,
//! `family::kernel+family::kernel/law`.

/// The laws of a file, in the order in which they stand.
macro_rules! laws {
    ($($law:ident),+ $(,)?) => {
        /// The laws of this file, by name.
        pub const LAWS: &[(&str, fn(&mut $crate::Laws))] = &[$((stringify!($law), $law)),+];
    };
}

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

use std::process::ExitCode;

use closedform_tests::budget::budget;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels::judge_of;
use closedform_tests::laws::chain::{Chain, Claim};
use closedform_tests::laws::motion::Motion;
use closedform_tests::laws::{Law, check_inverse};
use closedform_tests::random::seed;
use libtest_mimic::{Arguments, Trial};

const MAKERS: [Maker; 3] = [Maker::Logarithmic, Maker::NearEqual, Maker::Reals];

/// A kernel and names of its results.
fn kernel(kernel: &str, results: &[&'static str]) -> Chain {
    Chain::new(&judge_of(kernel), results)
}

/// The tests of laws as they are demanded.
struct Laws {
    /// The law that is demanding.
    law: &'static str,
    tests: Vec<Trial>,
}

impl Laws {
    /// One more test of the law, by the kernels that it takes.
    fn ask(&mut self, kernels: &[&str], holds: impl FnOnce() -> Result<(), String> + Send + 'static) {
        let name = format!("{}/{}", kernels.join("+"), self.law);
        self.tests.push(Trial::test(name, || Ok(holds()?)));
    }

    /// Demands laws of a kernel: Maxima text of its inputs and of its results, by these names.
    fn demand(&mut self, name: &str, results: &[&'static str], laws: &[&str]) {
        self.demand_of(&kernel(name, results), laws);
    }

    /// Demands laws of kernels that take each other's results.
    fn demand_of(&mut self, chain: &Chain, laws: &[&str]) {
        self.check(chain, laws.iter().map(|law| Law::new(law)).collect());
    }

    /// Demands that a move, integrated forward from its start, comes to where it says after each of its segments.
    fn demand_motion(&mut self, chain: &Chain, motion: &Motion) {
        self.check(chain, vec![motion.clone()]);
    }

    /// The same of the moves of two axes that share their times.
    fn demand_motions(&mut self, chain: &Chain, one: &Motion, other: &Motion) {
        self.check(chain, vec![one.clone(), other.clone()]);
    }

    fn check<C: Claim + Send + 'static>(&mut self, chain: &Chain, claims: Vec<C>) {
        let chain = chain.clone();
        self.ask(&chain.kernels(), move || {
            let claims: Vec<&dyn Claim> = claims.iter().map(|claim| claim as &dyn Claim).collect();
            MAKERS.into_iter().try_for_each(|maker| {
                let points = chain.points(maker, seed(), budget().laws);
                chain.check(&points, &claims).map(drop)
            })
        });
    }

    /// Demands that the second kernel undoes the first; each comes with the name of its result.
    fn demand_inverse(
        &mut self,
        first: (&'static str, &'static str),
        second: (&'static str, &'static str),
        constants: &'static [(&'static str, &str)],
    ) {
        self.ask(&[first.0, second.0], move || {
            let (one, two) = (judge_of(first.0), judge_of(second.0));
            MAKERS.into_iter().try_for_each(|maker| {
                let points = one.space.inside(maker, seed(), budget().laws);
                check_inverse((&one, first.1), (&two, second.1), constants, &points)
            })
        });
    }
}

fn main() -> ExitCode {
    let files = [
        five_segment::LAWS,
        fly_axis::LAWS,
        look_ahead::LAWS,
        milling_time::LAWS,
        optimum::LAWS,
        overhead::LAWS,
        pvt::LAWS,
        return_path::LAWS,
        s_curve::LAWS,
        step_move::LAWS,
        turnaround::LAWS,
        waypoints::LAWS,
    ];
    let mut laws = Laws { law: "", tests: Vec::new() };
    for (name, law) in files.concat() {
        laws.law = name;
        law(&mut laws);
    }
    libtest_mimic::run(&Arguments::from_args(), laws.tests).exit_code()
}
