//! Laws of segments of position, velocity and time.

use closedform_tests::budget::budget;
use closedform_tests::inputs::Maker;
use closedform_tests::kernels::judge_of;
use closedform_tests::laws::motion::Motion;
use closedform_tests::random::seed;

use crate::{Laws, kernel};

laws![
    states_lie_on_their_segment,
    boundary_accelerations_close_the_segment,
    arrivals_close_the_segment,
    arrivals_are_on_their_branch,
    turning_out_comes_to_rest,
    minimal_jerk_closes_the_segment,
    constant_acceleration_closes_the_segment,
    segments_close,
    states_follow_each_other,
    turning_out_and_back_closes,
    one_of_the_arrivals_undoes_the_boundary_accelerations,
];

/// Where a segment of position, velocity and time ends.
const SEGMENT: [&str; 2] = ["x1 = x0+v0*t1+(2*a0+a1)*t1^2/6", "v1 = v0+(a0+a1)*t1/2"];

fn states_lie_on_their_segment(laws: &mut Laws) {
    laws.demand("pvt::acceleration_at", &["a"], &["(a-a0)*t1 = (a1-a0)*t"]);
    laws.demand("pvt::velocity_at", &["v"], &["2*(v-v0-a0*t)*t1 = (a1-a0)*t^2"]);
    laws.demand("pvt::position_at", &["x"], &["6*(x-x0-v0*t-a0*t^2/2)*t1 = (a1-a0)*t^3"]);
}

fn boundary_accelerations_close_the_segment(laws: &mut Laws) {
    laws.demand("pvt::boundary_accelerations", &["a0", "a1"], &SEGMENT);
}

fn arrivals_close_the_segment(laws: &mut Laws) {
    laws.demand("pvt::arrival_first", &["t1", "a1"], &SEGMENT);
    laws.demand("pvt::arrival_last", &["t1", "a1"], &SEGMENT);
}

fn arrivals_are_on_their_branch(laws: &mut Laws) {
    laws.demand(
        "pvt::arrival_first",
        &["t1", "a1"],
        &["not (x1 > x0 and (v1+2*v0 > 0 or a0 > 0)) or t1 > 0", "not (x1 < x0 and v1+2*v0 < 0 and a0 > 0) or t1 > 0"],
    );
    laws.demand(
        "pvt::arrival_last",
        &["t1", "a1"],
        &["not (x1 > x0 and v1+2*v0 > 0 and a0 < 0) or t1 > 0", "not (x1 < x0 and (v1+2*v0 < 0 or a0 < 0)) or t1 > 0"],
    );
}

fn turning_out_comes_to_rest(laws: &mut Laws) {
    laws.demand(
        "pvt::turn_out",
        &["t_out", "d1_out"],
        &["d1_out = v0*t_out+a1*t_out^2/6", "v0+a1*t_out/2 = 0", "t_out > 0 and d1_out > 0"],
    );
}

fn minimal_jerk_closes_the_segment(laws: &mut Laws) {
    laws.demand(
        "pvt::min_jerk_segment",
        &["t1", "delta_a"],
        &["x1 = x0+v0*t1+(2*(ai+delta_a)+(af-delta_a))*t1^2/6", "v1 = v0+(ai+af)*t1/2", "t1 > 0"],
    );
}

fn constant_acceleration_closes_the_segment(laws: &mut Laws) {
    laws.demand("pvt::constant_acceleration", &["a", "d_x"], &["a*t1 = dV", "d_x = v0*t1+a*t1^2/2"]);
}

/// From (x0, v0) with the acceleration `a0` to (x1, v1) with `a1`.
fn segment(a0: &str, a1: &str) -> Motion {
    Motion::from(["x0", "v0", a0]).ramp("t1", ["x1", "v1", a1])
}

fn segments_close(laws: &mut Laws) {
    laws.demand_motion(&kernel("pvt::arrival_first", &["t1", "a1"]), &segment("a0", "a1"));
    laws.demand_motion(&kernel("pvt::arrival_last", &["t1", "a1"]), &segment("a0", "a1"));
    laws.demand_motion(&kernel("pvt::boundary_accelerations", &["a0", "a1"]), &segment("a0", "a1"));
    laws.demand_motion(&kernel("pvt::min_jerk_segment", &["t1", "delta_a"]), &segment("ai+delta_a", "af-delta_a"));
    let constant = Motion::from(["0", "v0", "a"]).jerk("t1", "0", ["d_x", "v0+dV", "a"]);
    laws.demand_motion(&kernel("pvt::constant_acceleration", &["a", "d_x"]), &constant);
}

fn states_follow_each_other(laws: &mut Laws) {
    let position = kernel("pvt::position_at", &["x"]).then(&judge_of("pvt::velocity_at"), &["v"]);
    let jerk = "(a1-a0)/t1";
    let there = Motion::from(["x0", "v0", "a0"]).jerk("t", jerk, ["x", "v", &format!("a0+{jerk}*t")]);
    laws.demand_motion(&position, &there);
    // The acceleration only where the segment is.
    let state = position.then(&judge_of("pvt::acceleration_at"), &["a"]);
    laws.ask(&state.kernels(), move || {
        let mut points = state.points(Maker::Logarithmic, seed(), 4 * budget().laws);
        points.list.retain(|inputs| (0.0..=inputs[4]).contains(&inputs[5]));
        assert!(2 * points.list.len() > budget().laws);
        let there = Motion::from(["x0", "v0", "a0"]).jerk("t", jerk, ["x", "v", "a"]);
        state.check(&points, &[&there]).map(drop)
    });
}

fn turning_out_and_back_closes(laws: &mut Laws) {
    let motion = Motion::from(["0", "v0", "0"]).jerk("t_out", "a1/t_out", ["d1_out", "0", "a1"]).jerk(
        "t_out",
        "-a1/t_out",
        ["0", "-v0", "0"],
    );
    laws.demand_motion(&kernel("pvt::turn_out", &["t_out", "d1_out"]), &motion);
}

fn one_of_the_arrivals_undoes_the_boundary_accelerations(laws: &mut Laws) {
    let accelerations = kernel("pvt::boundary_accelerations", &["a0", "a1"]);
    let chain =
        accelerations.then(&judge_of("pvt::arrival_first"), &["first"]).then(&judge_of("pvt::arrival_last"), &["last"]);
    laws.demand_of(&chain, &["(first-t1)*(last-t1) = 0"]);
}
