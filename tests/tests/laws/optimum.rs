//! Laws of the turn-around in which both axes take the same time.

use closedform_tests::kernels::judge_of;
use closedform_tests::laws::motion::Motion;

use crate::turnaround::turn as step_turn;
use crate::{Laws, fly_axis, kernel};

laws![
    the_optimum_solves_both_axes,
    the_optimum_of_the_seed_is_found,
    the_optimum_in_variables_of_the_worksheet_solves_both_axes,
    the_quartic_is_solved,
    both_axes_close_at_the_optimum,
    both_axes_close_at_the_optimum_in_variables_of_the_worksheet,
];

fn the_optimum_solves_both_axes(laws: &mut Laws) {
    laws.demand(
        "optimum::t_i",
        &["t_i"],
        &[
            "8*t_i^2*(v+Delta)^2+6*t_i^2*(v+Delta)*(a*t_i+Delta)+(t_i^2-3*delta)*(a*t_i+Delta)^2 = 0",
            "(t_i+3*t_i*(v+Delta)/(a*t_i+Delta))^2 = (t_i*(v+Delta)/(a*t_i+Delta))^2+3*delta",
            "t_i > 0",
        ],
    );
    laws.demand("optimum::t_o", &["t_o"], &["t_o*(a*t_i+Delta) = t_i*(v+Delta)", "t_o > 0"]);
}

fn the_optimum_of_the_seed_is_found(laws: &mut Laws) {
    laws.ask(&["optimum::t_i"], || {
        // The printed derivation prints these digits, and not the next ones.
        let t_i = judge_of("optimum::t_i").actual(&[500.0, 0.5, 0.001, 0.001])[0];
        assert!(format!("{t_i:.20}").starts_with("0.0517755356486726"), "{t_i}");
        Ok(())
    });
}

fn the_optimum_in_variables_of_the_worksheet_solves_both_axes(laws: &mut Laws) {
    laws.demand(
        "optimum::t_in",
        &["tIn"],
        &[
            "8*tIn^2*(v1Scan-v1Diff)^2+6*tIn^2*(v1Scan-v1Diff)*(a1Max*tIn+2*v1Diff) \
         +(tIn^2-3*delta)*(a1Max*tIn+2*v1Diff)^2 = 0",
            "(tIn+3*tIn*(v1Scan-v1Diff)/(a1Max*tIn+2*v1Diff))^2 \
         = (tIn*(v1Scan-v1Diff)/(a1Max*tIn+2*v1Diff))^2+3*delta",
            "tIn > 0",
            // It loses 2*v1Diff at no more than a1Max, in less than the ramps in alone would take.
            "a1Max*tIn >= 2*v1Diff",
            "tIn^2 <= 3*delta",
        ],
    );
}

fn the_quartic_is_solved(laws: &mut Laws) {
    // Below the root the quartic is negative, above it is positive.
    laws.demand(
        "optimum::quartic",
        &["x"],
        &[
            "qa*x^4+qb*x^3+qc*x^2 = qd",
            "x > 0",
            "qa*(2*x)^4+qb*(2*x)^3+qc*(2*x)^2 > qd and qa*(x/2)^4+qb*(x/2)^3+qc*(x/2)^2 < qd",
        ],
    );
}

fn both_axes_close_at_the_optimum(laws: &mut Laws) {
    // v1Scan = v+3/2*Delta, v1Diff = Delta/2; the ramps out take 2*t_o.
    let chain = kernel("optimum::t_i", &["t_i"]).then(&judge_of("optimum::t_o"), &["t_o"]).define("tIn", "t_i");
    let scan = Motion::from(["0", "v+3/2*Delta", "0"])
        .jerk("tIn", "-Delta/tIn^2", ["(v+4/3*Delta)*tIn", "v+Delta", "-Delta/tIn"])
        .ramp("2*t_o", ["(v+4/3*Delta)*tIn+2*((v+Delta)*t_o+a*t_o^2)/3", "0", "-a"])
        .ramp("2*t_o", ["(v+4/3*Delta)*tIn", "-v-Delta", "-Delta/tIn"])
        .jerk("tIn", "Delta/tIn^2", ["0", "-v-3/2*Delta", "0"]);
    laws.demand_motions(&chain, &scan, &step_turn("1", "2*t_o", "0", "delta"));
}

fn both_axes_close_at_the_optimum_in_variables_of_the_worksheet(laws: &mut Laws) {
    let chain = fly_axis::with_segments(kernel("optimum::t_in", &["tIn"]));
    laws.demand_motions(&chain, &fly_axis::turn(), &step_turn("1", "tOut", "0", "delta"));
}
