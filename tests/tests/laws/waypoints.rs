//! Laws of three polynomials through four points.
//!
//! Segment i is `c<i>0+c<i>1*t+c<i>2*t^2+..` from t = 0 to t<i>.

use closedform_tests::kernels::judge_of;
use closedform_tests::laws::motion::Motion;
use closedform_tests::random::{Random, seed};
use closedform_tests::ulp::{self, F64};
use rug::Float;

use crate::{Laws, kernel};

laws![
    a_segment_is_as_long_as_pythagoras_says,
    linear_segments_meet_the_points,
    velocity_is_continuous,
    velocity_is_continuous_from_rest_to_rest,
    acceleration_is_continuous,
    acceleration_is_continuous_from_rest_to_rest,
    acceleration_is_continuous_and_none_at_both_ends,
    uniform_motion_is_reproduced,
    moves_of_lines_and_parabolas_close,
    the_move_from_rest_to_rest_closes,
    the_move_of_continuous_acceleration_closes,
    the_move_of_cubics_closes,
    the_move_of_quartics_closes,
];

fn a_segment_is_as_long_as_pythagoras_says(laws: &mut Laws) {
    laws.demand(
        "waypoints::segment_2d",
        &["length", "time"],
        &["length^2 = (x1-x0)^2+(y1-y0)^2", "time*v = length", "length >= 0 and time >= 0"],
    );
    laws.demand(
        "waypoints::segment_3d",
        &["length", "time"],
        &["length^2 = (x1-x0)^2+(y1-y0)^2+(z1-z0)^2", "time*v = length", "length >= 0 and time >= 0"],
    );
}

/// That each segment starts at its point.
const STARTS: [&str; 3] = ["c00 = P0", "c10 = P1", "c20 = P2"];

/// Problem (a).
fn linear_segments_meet_the_points(laws: &mut Laws) {
    let kernel = "waypoints::linear";
    let results = ["c00", "c10", "c20", "c01", "c11", "c21"];
    laws.demand(kernel, &results, &STARTS);
    laws.demand(kernel, &results, &["c00+c01*t0 = P1", "c10+c11*t1 = P2", "c20+c21*t2 = P3"]);
}

/// Problem (b).
fn velocity_is_continuous(laws: &mut Laws) {
    let kernel = "waypoints::quadratic_linear_quadratic";
    let results = ["c00", "c10", "c20", "c11", "c21", "c01", "c02", "c22"];
    laws.demand(kernel, &results, &STARTS);
    laws.demand(kernel, &results, &["c00+c01*t0+c02*t0^2 = P1", "c10+c11*t1 = P2", "c20+c21*t2+c22*t2^2 = P3"]);
    laws.demand(kernel, &results, &["c01+2*c02*t0 = c11", "c11 = c21"]);
}

/// Problem (c).
fn velocity_is_continuous_from_rest_to_rest(laws: &mut Laws) {
    let kernel = "waypoints::quadratic_cubic_quadratic_at_rest";
    let results = ["c00", "c10", "c20", "c01", "c02", "c11", "c21", "c22", "c12", "c13"];
    laws.demand(kernel, &results, &STARTS);
    laws.demand(
        kernel,
        &results,
        &["c00+c01*t0+c02*t0^2 = P1", "c10+c11*t1+c12*t1^2+c13*t1^3 = P2", "c20+c21*t2+c22*t2^2 = P3"],
    );
    laws.demand(kernel, &results, &["c01+2*c02*t0 = c11", "c11+2*c12*t1+3*c13*t1^2 = c21"]);
    laws.demand(kernel, &results, &["c01 = 0", "c21+2*c22*t2 = 0"]);
}

/// Problem (d).
fn acceleration_is_continuous(laws: &mut Laws) {
    let kernel = "waypoints::quadratic_cubic_quadratic";
    let results = ["c00", "c10", "c20", "c02", "c12", "c22", "c01", "c11", "c21", "c13"];
    laws.demand(kernel, &results, &STARTS);
    laws.demand(
        kernel,
        &results,
        &["c00+c01*t0+c02*t0^2 = P1", "c10+c11*t1+c12*t1^2+c13*t1^3 = P2", "c20+c21*t2+c22*t2^2 = P3"],
    );
    laws.demand(
        kernel,
        &results,
        &["c01+2*c02*t0 = c11", "c11+2*c12*t1+3*c13*t1^2 = c21", "2*c02 = 2*c12", "2*c12+6*c13*t1 = 2*c22"],
    );
}

/// Problem (e).
fn acceleration_is_continuous_from_rest_to_rest(laws: &mut Laws) {
    let kernel = "waypoints::cubics_at_rest";
    let results = ["c00", "c10", "c20", "c01", "c11", "c21", "c02", "c12", "c22", "c03", "c13", "c23"];
    laws.demand(kernel, &results, &STARTS);
    laws.demand(
        kernel,
        &results,
        &[
            "c00+c01*t0+c02*t0^2+c03*t0^3 = P1",
            "c10+c11*t1+c12*t1^2+c13*t1^3 = P2",
            "c20+c21*t2+c22*t2^2+c23*t2^3 = P3",
        ],
    );
    laws.demand(
        kernel,
        &results,
        &[
            "c01+2*c02*t0+3*c03*t0^2 = c11",
            "c11+2*c12*t1+3*c13*t1^2 = c21",
            "2*c02+6*c03*t0 = 2*c12",
            "2*c12+6*c13*t1 = 2*c22",
        ],
    );
    laws.demand(kernel, &results, &["c01 = 0", "c21+2*c22*t2+3*c23*t2^2 = 0"]);
}

/// Problem (f).
fn acceleration_is_continuous_and_none_at_both_ends(laws: &mut Laws) {
    let kernel = "waypoints::quartic_cubic_quartic_at_rest";
    let results = ["c00", "c10", "c20", "c01", "c02", "c11", "c21", "c12", "c22", "c03", "c13", "c23", "c04", "c24"];
    laws.demand(kernel, &results, &STARTS);
    laws.demand(
        kernel,
        &results,
        &[
            "c00+c01*t0+c02*t0^2+c03*t0^3+c04*t0^4 = P1",
            "c10+c11*t1+c12*t1^2+c13*t1^3 = P2",
            "c20+c21*t2+c22*t2^2+c23*t2^3+c24*t2^4 = P3",
        ],
    );
    laws.demand(
        kernel,
        &results,
        &[
            "c01+2*c02*t0+3*c03*t0^2+4*c04*t0^3 = c11",
            "c11+2*c12*t1+3*c13*t1^2 = c21",
            "2*c02+6*c03*t0+12*c04*t0^2 = 2*c12",
            "2*c12+6*c13*t1 = 2*c22",
        ],
    );
    laws.demand(
        kernel,
        &results,
        &["c01 = 0", "c21+2*c22*t2+3*c23*t2^2+4*c24*t2^3 = 0", "2*c02 = 0", "2*c22+6*c23*t2+12*c24*t2^2 = 0"],
    );
}

/// Points of uniform motion, all of them and their differences exact: the inputs and the velocity.
fn uniform(random: &mut Random) -> ([f64; 7], f64) {
    let mut whole = |below: usize| random.below(below) as f64;
    let (start, velocity) = (whole(2_000) - 1_000.0, (whole(2_000) - 1_000.0) / 16.0);
    let times = [1.0 + whole(500), 1.0 + whole(500), 1.0 + whole(500)].map(|time| time / 8.0);
    let [one, two, three] =
        [times[0], times[0] + times[1], times[0] + times[1] + times[2]].map(|t| start + velocity * t);
    ([start, one, two, three, times[0], times[1], times[2]], velocity)
}

fn uniform_motion_is_reproduced(laws: &mut Laws) {
    for kernel in ["waypoints::linear", "waypoints::quadratic_linear_quadratic", "waypoints::quadratic_cubic_quadratic"]
    {
        laws.ask(&[kernel], move || {
            reproduces_uniform_motion(kernel);
            Ok(())
        });
    }
}

fn reproduces_uniform_motion(kernel: &str) {
    let judge = judge_of(kernel);
    let mut random = Random::new(seed(), kernel);
    for _ in 0..1_000 {
        let (inputs, velocity) = uniform(&mut random);
        let results = judge.kernel.info.results.iter().zip(judge.actual(&inputs)).enumerate();
        for (position, (result, actual)) in results {
            let expected = match result.name {
                "c00" => inputs[0],
                "c10" => inputs[1],
                "c20" => inputs[2],
                "c01" | "c11" | "c21" => velocity,
                _ => 0.0,
            };
            let off = ulp::distance(actual, &Float::with_val(53, expected), F64);
            assert!(off <= judge.bound(position), "{kernel}, {}: {actual}, not {expected}: {inputs:?}", result.name);
        }
    }
}

/// Problems (a) and (b): the velocity of (a) jumps at the points, so each segment of it is a move of its own.
fn moves_of_lines_and_parabolas_close(laws: &mut Laws) {
    let linear = kernel("waypoints::linear", &["c00", "c10", "c20", "c01", "c11", "c21"]);
    for [from, velocity, time, to] in
        [["c00", "c01", "t0", "c10"], ["c10", "c11", "t1", "c20"], ["c20", "c21", "t2", "P3"]]
    {
        laws.demand_motion(&linear, &Motion::from([from, velocity, "0"]).jerk(time, "0", [to, velocity, "0"]));
    }
    let results = ["c00", "c10", "c20", "c11", "c21", "c01", "c02", "c22"];
    let motion = Motion::from(["c00", "c01", "2*c02"])
        .jerk("t0", "0", ["c10", "c11", "2*c02"])
        .jerk("t1", "0", ["c20", "c21", "0"])
        .after_jump_to("0")
        .jerk("t2", "0", ["P3", "c21+2*c22*t2", "2*c22"])
        .after_jump_to("2*c22");
    laws.demand_motion(&kernel("waypoints::quadratic_linear_quadratic", &results), &motion);
}

/// Problem (c): the acceleration jumps at the inner points.
fn the_move_from_rest_to_rest_closes(laws: &mut Laws) {
    let results = ["c00", "c10", "c20", "c01", "c02", "c11", "c21", "c22", "c12", "c13"];
    let motion = Motion::from(["c00", "c01", "2*c02"])
        .jerk("t0", "0", ["c10", "c11", "2*c02"])
        .jerk("t1", "6*c13", ["c20", "c21", "2*c12+6*c13*t1"])
        .after_jump_to("2*c12")
        .jerk("t2", "0", ["P3", "0", "2*c22"])
        .after_jump_to("2*c22");
    laws.demand_motion(&kernel("waypoints::quadratic_cubic_quadratic_at_rest", &results), &motion);
}

/// Problem (d).
fn the_move_of_continuous_acceleration_closes(laws: &mut Laws) {
    let results = ["c00", "c10", "c20", "c02", "c12", "c22", "c01", "c11", "c21", "c13"];
    let motion = Motion::from(["c00", "c01", "2*c02"])
        .jerk("t0", "0", ["c10", "c11", "2*c12"])
        .jerk("t1", "6*c13", ["c20", "c21", "2*c22"])
        .jerk("t2", "0", ["P3", "c21+2*c22*t2", "2*c22"]);
    laws.demand_motion(&kernel("waypoints::quadratic_cubic_quadratic", &results), &motion);
}

/// Problem (e).
fn the_move_of_cubics_closes(laws: &mut Laws) {
    let results = ["c00", "c10", "c20", "c01", "c11", "c21", "c02", "c12", "c22", "c03", "c13", "c23"];
    let motion = Motion::from(["c00", "c01", "2*c02"])
        .jerk("t0", "6*c03", ["c10", "c11", "2*c12"])
        .jerk("t1", "6*c13", ["c20", "c21", "2*c22"])
        .jerk("t2", "6*c23", ["P3", "0", "2*c22+6*c23*t2"]);
    laws.demand_motion(&kernel("waypoints::cubics_at_rest", &results), &motion);
}

/// Problem (f): the snap of the outer segments is constant.
fn the_move_of_quartics_closes(laws: &mut Laws) {
    let results = ["c00", "c10", "c20", "c01", "c02", "c11", "c21", "c12", "c22", "c03", "c13", "c23", "c04", "c24"];
    let motion = Motion::from(["c00", "c01", "2*c02"])
        .snap("t0", "6*c03", "24*c04", ["c10", "c11", "2*c12"])
        .jerk("t1", "6*c13", ["c20", "c21", "2*c22"])
        .snap("t2", "6*c23", "24*c24", ["P3", "0", "0"]);
    laws.demand_motion(&kernel("waypoints::quartic_cubic_quartic_at_rest", &results), &motion);
}
