//! Laws of the speed at corners and on arcs, and of the ramps between them.

use crate::{Laws, kernel};
use closedform_tests::laws::motion::Motion;

laws![
    half_a_turn_is_that_of_sum_and_difference,
    a_corner_has_its_acceleration_on_its_circle,
    a_chord_is_as_far_from_its_arc_as_asked,
    ramps_travel_their_way,
    ramps_with_a_jerk_limit_travel_their_way,
    a_short_ramp_integrates_its_jerk,
];

fn half_a_turn_is_that_of_sum_and_difference(laws: &mut Laws) {
    laws.demand(
        "look_ahead::half_turn",
        &["c", "s"],
        &[
            "4*c^2 = (ux+wx)^2+(uy+wy)^2+(uz+wz)^2",
            "4*s^2 = (ux-wx)^2+(uy-wy)^2+(uz-wz)^2",
            // The law of the parallelogram.
            "2*(c^2+s^2) = ux^2+uy^2+uz^2+wx^2+wy^2+wz^2",
            "c >= 0 and s >= 0",
        ],
    );
}

fn a_corner_has_its_acceleration_on_its_circle(laws: &mut Laws) {
    laws.demand("look_ahead::corner_radius", &["R"], &["R*s^2 = d*c*(1+c)", "R >= 0"]);
    laws.demand("look_ahead::junction_speed", &["v"], &["v^2*s^2 = a*d*c*(1+c)", "v >= 0"]);
    laws.demand("look_ahead::centripetal_speed", &["v"], &["v^2 = a*r", "v >= 0"]);
    laws.demand("look_ahead::deviation", &["d"], &["d*a = v^2*(sqrt(2)-1)", "d >= 0"]);
}

fn a_chord_is_as_far_from_its_arc_as_asked(laws: &mut Laws) {
    laws.demand("look_ahead::chord", &["l"], &["(r-e)^2 = r^2-(l/2)^2", "l >= 0"]);
}

fn ramps_travel_their_way(laws: &mut Laws) {
    laws.demand("look_ahead::reachable_speed", &["V"], &["V^2-v^2 = 2*a*l", "V >= 0"]);
    laws.demand("look_ahead::ramp", &["T", "w"], &["a*T = abs(v1-v0)", "2*w = (v0+v1)*T", "T >= 0 and w >= 0"]);
    laws.demand("look_ahead::peak_speed", &["p"], &["p^2 = min(F^2, (v0^2+v1^2)/2+a*l)", "p > 0 or l = 0"]);
    laws.demand("look_ahead::block_time", &["T"], &["2*a*p*T = 2*a*l+(p-v0)^2+(p-v1)^2", "T >= 0"]);
}

fn ramps_with_a_jerk_limit_travel_their_way(laws: &mut Laws) {
    laws.demand(
        "look_ahead::jerk_ramp_long",
        &["T", "w"],
        &["a*j*T = j*abs(v1-v0)+a^2", "2*w = (v0+v1)*T", "T > 0 and w >= 0"],
    );
    laws.demand(
        "look_ahead::jerk_ramp_short",
        &["T", "w"],
        &["j*T^2 = 4*abs(v1-v0)", "2*w = (v0+v1)*T", "T >= 0 and w >= 0"],
    );
    laws.demand("look_ahead::jerk_reachable_long", &["V"], &["2*a*j*l = (v+V)*((V-v)*j+a^2)", "V > 0"]);
    laws.demand("look_ahead::jerk_reachable_short", &["t"], &["l = (2*v+j*t^2)*t", "t > 0"]);
}

fn a_short_ramp_integrates_its_jerk(laws: &mut Laws) {
    let ramp = Motion::from(["0", "v", "0"]).jerk("t", "j", ["v*t+j*t^3/6", "v+j*t^2/2", "j*t"]).jerk(
        "t",
        "-j",
        ["l", "v+j*t^2", "0"],
    );
    laws.demand_motion(&kernel("look_ahead::jerk_reachable_short", &["t"]), &ramp);
}
