//! Laws of segments of position, velocity and time.

use crate::demand;

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
