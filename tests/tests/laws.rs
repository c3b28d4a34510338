//! Solved kernels put back into what they solve.

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

/// Where a segment of position, velocity and time ends.
const SEGMENT: [&str; 2] = ["x1 = x0+v0*t1+(2*a0+a1)*t1^2/6", "v1 = v0+(a0+a1)*t1/2"];

#[test]
fn states_lie_on_their_segment() {
    demand("pvt::acceleration_at", &["a"], &["(a-a0)*t1 = (a1-a0)*t"]);
    demand("pvt::velocity_at", &["v"], &["2*(v-v0-a0*t)*t1 = (a1-a0)*t^2"]);
    demand("pvt::position_at", &["x"], &["6*(x-x0-v0*t-a0*t^2/2)*t1 = (a1-a0)*t^3"]);
}

#[test]
fn boundary_accelerations_close_the_segment() {
    demand("pvt::boundary_accelerations", &["a0", "a1"], &SEGMENT);
}

#[test]
fn arrivals_close_the_segment() {
    demand("pvt::arrival_first", &["t1", "a1"], &SEGMENT);
    demand("pvt::arrival_last", &["t1", "a1"], &SEGMENT);
}

#[test]
fn arrivals_are_on_their_branch() {
    demand(
        "pvt::arrival_first",
        &["t1", "a1"],
        &["not (x1 > x0 and (v1+2*v0 > 0 or a0 > 0)) or t1 > 0", "not (x1 < x0 and v1+2*v0 < 0 and a0 > 0) or t1 > 0"],
    );
    demand(
        "pvt::arrival_last",
        &["t1", "a1"],
        &["not (x1 > x0 and v1+2*v0 > 0 and a0 < 0) or t1 > 0", "not (x1 < x0 and (v1+2*v0 < 0 or a0 < 0)) or t1 > 0"],
    );
}

#[test]
fn turning_out_comes_to_rest() {
    demand(
        "pvt::turn_out",
        &["t_out", "d1_out"],
        &["d1_out = v0*t_out+a1*t_out^2/6", "v0+a1*t_out/2 = 0", "t_out > 0 and d1_out > 0"],
    );
}

#[test]
fn minimal_jerk_closes_the_segment() {
    demand(
        "pvt::min_jerk_segment",
        &["t1", "delta_a"],
        &["x1 = x0+v0*t1+(2*(ai+delta_a)+(af-delta_a))*t1^2/6", "v1 = v0+(ai+af)*t1/2", "t1 > 0"],
    );
}

#[test]
fn constant_acceleration_closes_the_segment() {
    demand("pvt::constant_acceleration", &["a", "d_x"], &["a*t1 = dV", "d_x = v0*t1+a*t1^2/2"]);
}

#[test]
fn outer_and_inner_ramps_close_the_move() {
    let laws = [
        "a0*t0^2/3+2*(a0*t0/2*t3+a0*t3^2/3)+t2*a0*(t0+t3)/2 = DeltaX",
        "v0 = a0*t0/2",
        "k*(t0+t3)*(t0+2*t3) = t0^2",
        "t0 > 0 and t3 > 0 and v0 > 0 and k > 0",
    ];
    demand("turnaround::outer_ramp", &["t0", "v0", "k"], &laws);
    demand("turnaround::inner_ramp", &["t3", "v0", "k"], &laws);
}

#[test]
fn ramps_close_on_the_step() {
    demand(
        "turnaround::t_in",
        &["tIn"],
        &[
            "2*a2Max*tIn^2/6+2*(a2Max*tIn/2*tOut+a2Max*tOut^2/3)+tEdgeTotal*(a2Max*tIn/2+a2Max*tOut/2) = d2Step",
            "tIn > 0",
        ],
    );
    demand(
        "turnaround::ramp_in",
        &["d2_in", "v2_in"],
        &["d2_in = a2Max*tIn^2/6", "v2_in = a2Max*tIn/2", "d2_in > 0 and v2_in > 0"],
    );
    demand(
        "turnaround::ramp_out",
        &["d2_out", "v2_out"],
        &[
            "d2_out = a2Max*tIn/2*tOut+a2Max*tOut^2/2-a2Max*tOut^2/6",
            "v2_out = a2Max*tIn/2+a2Max*tOut/2",
            "d2_out >= 0 and v2_out > 0",
        ],
    );
}

#[test]
fn a_ramp_in_travels_its_distance() {
    demand("turnaround::t_in_of_d2_in", &["tIn"], &["a2Max*tIn^2/6 = d2In", "tIn > 0"]);
    demand("turnaround::a2_max_of_d2_in", &["a2Max"], &["a2Max*tIn^2/6 = d2In", "a2Max > 0"]);
}

#[test]
fn tau_and_delta_solve_the_turn_around() {
    let squared = "(tIn+3*tau-3*tEFSkip/2)^2 = tau^2+3*delta";
    demand(
        "turnaround::t_in_of_tau",
        &["tIn"],
        &["(tIn+3*tau-3*tEFSkip/2)^2 = tau^2+3*delta", "tIn > 0 and 2*tIn+6*tau-3*tEFSkip >= 0"],
    );
    demand("turnaround::tau_of_t_in", &["tau"], &[squared, "tau > 0 and 2*tIn+6*tau-3*tEFSkip >= 0"]);
    demand("turnaround::tau_without_skip", &["tau"], &["(tIn+3*tau)^2 = tau^2+3*delta", "tau > 0"]);
    demand("turnaround::delta_of_tau", &["delta"], &[squared, "delta > 0"]);
    demand(
        "turnaround::delta_of_t_edge",
        &["delta"],
        &["tIn^2/3+tIn*(tOut+tEdge/2)+2*(tOut+tEdge/2)^2/3+tEFSkip*(tIn+tOut+tEdge/2)/2 = delta", "delta > 0"],
    );
    demand(
        "turnaround::t_edge_of_t_in",
        &["tEdge"],
        &["tIn^2/3+tIn*(tOut+tEdge/2)+2*(tOut+tEdge/2)^2/3 = delta", "tEdge >= 0"],
    );
}

#[test]
fn largest_acceleration_makes_the_step() {
    demand("turnaround::a2_max_of_tau", &["a2Max"], &["a2Max*((tIn+3*tau)^2-tau^2) = 3*d2Step", "a2Max > 0"]);
    demand(
        "turnaround::da2_max_dtau",
        &["slope"],
        &["slope*((tIn+3*tau)^2-tau^2)^2 = -3*d2Step*(6*(tIn+3*tau)-2*tau)", "slope < 0"],
    );
    demand(
        "turnaround::dtau_da2_max",
        &["slope"],
        &[
            "-3*slope*d2Step*(6*(tIn+3*(tOut/2+tEdge/4))-2*(tOut/2+tEdge/4)) \
         = ((tIn+3*(tOut/2+tEdge/4))^2-(tOut/2+tEdge/4)^2)^2",
            "slope < 0",
        ],
    );
}

#[test]
fn the_share_of_the_ramps_in_is_by_their_times() {
    demand(
        "turnaround::k_of_t_in",
        &["K"],
        &[
            "K*(tIn+positive_root(2*T^2/3+(tIn+tEFSkip/2)*T+tIn^2/3+tEFSkip*tIn/2-delta,T)) \
         *(tIn+2*positive_root(2*T^2/3+(tIn+tEFSkip/2)*T+tIn^2/3+tEFSkip*tIn/2-delta,T)) = tIn^2",
            "K > 0",
        ],
    );
}

#[test]
fn tau_and_delta_undo_each_other() {
    demand_inverse(("turnaround::tau_of_t_in", "tau"), ("turnaround::delta_of_tau", "delta"), &[]);
    demand_inverse(("turnaround::tau_of_t_in", "tau"), ("turnaround::t_in_of_tau", "tIn"), &[]);
    demand_inverse(("turnaround::delta_of_tau", "delta"), ("turnaround::tau_of_t_in", "tau"), &[]);
    demand_inverse(("turnaround::tau_without_skip", "tau"), ("turnaround::delta_of_tau", "delta"), &[("tEFSkip", 0.0)]);
    demand_inverse(
        ("turnaround::t_edge_of_t_in", "tEdge"),
        ("turnaround::delta_of_t_edge", "delta"),
        &[("tEFSkip", 0.0)],
    );
    demand_inverse(("turnaround::t_in_of_d2_in", "tIn"), ("turnaround::a2_max_of_d2_in", "a2Max"), &[]);
    demand_inverse(("turnaround::a2_max_of_d2_in", "a2Max"), ("turnaround::t_in_of_d2_in", "tIn"), &[]);
}

#[test]
fn the_optimum_solves_both_axes() {
    demand(
        "optimum::t_i",
        &["t_i"],
        &[
            "8*t_i^2*(v+Delta)^2+6*t_i^2*(v+Delta)*(a*t_i+Delta)+(t_i^2-3*delta)*(a*t_i+Delta)^2 = 0",
            "(t_i+3*t_i*(v+Delta)/(a*t_i+Delta))^2 = (t_i*(v+Delta)/(a*t_i+Delta))^2+3*delta",
            "t_i > 0",
        ],
    );
    demand("optimum::t_o", &["t_o"], &["t_o*(a*t_i+Delta) = t_i*(v+Delta)", "t_o > 0"]);
}

#[test]
fn the_optimum_of_the_seed_is_found() {
    // The seed prints these digits, and not the next ones.
    let t_i = judge_of("optimum::t_i").actual(&[500.0, 0.5, 0.001, 0.001])[0];
    assert!(format!("{t_i:.20}").starts_with("0.0517755356486726"), "{t_i}");
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
