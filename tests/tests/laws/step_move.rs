//! Laws of the step in four segments with a late settling.
//!
//! It ramps from rest to x0 with v0 in t0, goes from a0 over -a0 at x1 to a3 at x3, in t1 each, and settles in t4 at x4.

use closedform_tests::inputs::Points;
use closedform_tests::kernels::judge_of;
use closedform_tests::laws::Law;
use closedform_tests::laws::chain::{Chain, Claim};
use closedform_tests::laws::motion::Motion;

use crate::{Laws, kernel};

laws![
    the_equations_are_solved,
    at_its_edges_the_move_degenerates,
    the_ramp_closes,
    the_move_over_the_quarters_closes,
    the_continuous_move_closes,
    the_move_in_a_symmetric_frame_closes,
    the_symmetric_frame_is_a_continuous_move,
    at_the_quarters_the_continuous_move_is_that_of_its_settling,
    fractions_and_times_undo_each_other,
    the_ramp_from_rest_undoes_the_ramp_in,
];

const QUARTERS: [&str; 5] = ["v3", "v0", "a0", "x1", "t4"];
const CONTINUOUS: [&str; 6] = ["kv0", "kv3", "kt4", "ka0", "ka3", "kx1"];
const FRAME: [&str; 7] = ["kt4", "kx1", "kv0", "kv3", "ka0", "ka3", "Ko"];
const STEP: [&str; 8] = ["tIESkip", "d2In", "d2Out", "ax2Entry", "v2In", "v2Out", "a2Max", "A3"];

/// The equations of the worksheet, times their t^2: the accelerations at both ends of the ramp.
const RAMP: [&str; 2] = ["0 = 6*x0-2*v0*t0", "a00*t0^2 = 4*v0*t0-6*x0"];

/// The same of the three other segments, by the whole travel, the time of the two in the middle and the end of each.
fn equations(x0: &str, x3: &str, x4: &str, t1: &str) -> [String; 6] {
    let ends = |from: &str, to: &str, velocities: [&str; 2], time: &str| {
        let [v, w] = velocities;
        [format!("6*(({to})-({from}))-(2*{w}+4*{v})*{time}"), format!("(4*{w}+2*{v})*{time}-6*(({to})-({from}))")]
    };
    let [rise, fall, settle] =
        [ends(x0, "x1", ["v0", "v0"], t1), ends("x1", x3, ["v0", "v3"], t1), ends(x3, x4, ["v3", "0"], "t4")];
    [
        format!("a0*{t1}^2 = {}", rise[0]),
        format!("-a0*{t1}^2 = {}", rise[1]),
        format!("-a0*{t1}^2 = {}", fall[0]),
        format!("a3*{t1}^2 = {}", fall[1]),
        format!("a3*t4^2 = {}", settle[0]),
        format!("0 = {}", settle[1]),
    ]
}

/// Demands the equations, and the order of the move: it only goes forward, in positive times.
fn demand_equations(laws: &mut Laws, chain: &Chain, [x0, x3, x4, t1]: [&str; 4]) {
    laws.demand_of(chain, &equations(x0, x3, x4, t1).each_ref().map(String::as_str));
    laws.demand_of(chain, &["t4 > 0 and v0 > 0 and v3 > 0 and a0 > 0 and a3 < 0", "v3 <= v0"]);
    laws.demand_of(chain, &[&format!("{x0} <= x1"), &format!("x1 <= {x3}"), &format!("{x3} <= {x4}")]);
}

fn the_equations_are_solved(laws: &mut Laws) {
    laws.demand("step_move::ramp_from_rest", &["t0", "a00"], &RAMP);
    laws.demand("step_move::ramp_from_rest", &["t0", "a00"], &["t0 > 0 and a00 > 0"]);
    demand_equations(laws, &kernel("step_move::quarter_move", &QUARTERS), ["x4/4", "3*x4/4", "x4", "t1"]);
    let results = ["v0", "v3", "t4", "a0", "ka3", "x1"];
    let continuous = kernel("step_move::continuous_move", &results).define("a3", "-ka3");
    demand_equations(laws, &continuous, ["Ki/2", "1-Ko/2", "1", "1"]);
    laws.demand_of(&continuous, &["3*Ki*a0 = 4*v0^2"]);
    let results = ["t4", "x1", "v0", "v3", "a0", "ka3", "Ko"];
    let frame = kernel("step_move::symmetric_frame", &results).define("a3", "-ka3");
    demand_equations(laws, &frame, ["Ki/2", "1-Ko/2", "1", "1"]);
    laws.demand_of(&frame, &["3*Ki*a0 = 4*v0^2", "2*v0*t4 = 3*Ki", "t4 >= 1", "Ko > 0", "Ki+Ko <= 2"]);
    let results = ["t4", "x0", "x1", "x3", "v0", "v3", "a0", "a3"];
    let step = kernel("step_move::symmetric_frame_step", &results);
    demand_equations(laws, &step, ["x0", "x3", "d2Step", "tOut"]);
    laws.demand_of(&step, &["0 = 6*x0-2*v0*t4", "a0*t4^2 = 4*v0*t4-6*x0", "2*x0 = Ki*d2Step", "t4 >= tOut", "x0 > 0"]);
}

fn at_its_edges_the_move_degenerates(laws: &mut Laws) {
    // Of the + root, with R >= 0 left out: nothing is left to settle where Ko+6*Ki = 2, nor where Ki+Ko = 2.
    let settles = "2*kv3*(Ko+16*Ki-2) <= 3*(2-Ki-Ko)*(Ko+6*Ki-2)";
    let slows = "2*kv0*(10-5*Ki-2*Ko) <= 3*(2-Ki)*(2-Ki-Ko)";
    laws.demand("step_move::continuous_move", &CONTINUOUS, &[settles, slows]);
    let frame = ["8*kv3 <= 3*(3*Ki-1)", "2*Ko <= 3*Ki-1", "4*kv0 = 3*(1-Ki)", "kt4*(1-Ki) <= 2"];
    laws.demand("step_move::symmetric_frame", &FRAME, &frame);
}

fn the_ramp_closes(laws: &mut Laws) {
    let ramp = Motion::from(["0", "0", "0"]).jerk("t0", "a00/t0", ["x0", "v0", "a00"]);
    laws.demand_motion(&kernel("step_move::ramp_from_rest", &["t0", "a00"]), &ramp);
}

fn the_move_over_the_quarters_closes(laws: &mut Laws) {
    // The acceleration jumps from a00 to a0 at x0.
    let chain = kernel("step_move::quarter_move", &QUARTERS)
        .define("x0", "x4/4")
        .then(&judge_of("step_move::ramp_from_rest"), &["t0", "a00"]);
    let motion = Motion::from(["0", "0", "0"])
        .jerk("t0", "a00/t0", ["x4/4", "v0", "a00"])
        .jerk("t1", "-2*a0/t1", ["x1", "v0", "-a0"])
        .after_jump_to("a0")
        .ramp("t1", ["3*x4/4", "v3", "a3"])
        .jerk("t4", "-a3/t4", ["x4", "0", "0"]);
    laws.demand_motion(&chain, &motion);
}

/// A move in the units x4 and t1 with the ramp of the time `t0`, whose end has the acceleration of the next segment.
fn move_in_units(t0: &str, jerk: &str) -> Motion {
    Motion::from(["0", "0", "0"])
        .jerk(t0, jerk, ["Ki/2", "kv0", "ka0"])
        .jerk("1", "-2*ka0", ["kx1", "kv0", "-ka0"])
        .jerk("1", "ka0-ka3", ["1-Ko/2", "kv3", "-ka3"])
        .jerk("kt4", "ka3/kt4", ["1", "0", "0"])
}

fn the_continuous_move_closes(laws: &mut Laws) {
    let chain = kernel("step_move::continuous_move", &CONTINUOUS)
        .define("x0", "Ki/2")
        .define("v0", "kv0")
        .then(&judge_of("step_move::ramp_from_rest"), &["t0", "a00"]);
    laws.demand_motion(&chain, &move_in_units("t0", "a00/t0"));
}

fn the_move_in_a_symmetric_frame_closes(laws: &mut Laws) {
    laws.demand_motion(&kernel("step_move::symmetric_frame", &FRAME), &move_in_units("kt4", "2*kv0/kt4^2"));
    let motion = Motion::from(["0", "0", "0"])
        .jerk("tIESkip", "2*v2In/tIESkip^2", ["d2In", "v2In", "a2Max"])
        .jerk("tOut", "-2*a2Max/tOut", ["d2Out", "v2In", "-a2Max"])
        .ramp("tOut", ["ax2Entry", "v2Out", "A3"])
        .jerk("tIESkip", "2*v2Out/tIESkip^2", ["d2Step", "0", "0"]);
    laws.demand_motion(&kernel("step_move::symmetric_frame_step", &STEP), &motion);
}

fn the_symmetric_frame_is_a_continuous_move(laws: &mut Laws) {
    let chain = kernel("step_move::symmetric_frame", &FRAME)
        .then(&judge_of("step_move::continuous_move"), &["v0", "v3", "t4", "a0", "a3", "x1"]);
    laws.demand_of(&chain, &["v0 = kv0", "v3 = kv3", "t4 = kt4", "a0 = ka0", "a3 = ka3", "x1 = kx1"]);
    let unit = kernel("step_move::symmetric_frame", &FRAME)
        .define("tOut", "1")
        .define("d2Step", "1")
        .then(&judge_of("step_move::symmetric_frame_step"), &STEP);
    laws.demand_of(&unit, &["tIESkip = kt4", "d2Out = kx1", "v2In = kv0", "v2Out = kv3", "a2Max = ka0", "A3 = -ka3"]);
    laws.demand_of(&unit, &["2*d2In = Ki", "2*ax2Entry = 2-Ko"]);
}

fn at_the_quarters_the_continuous_move_is_that_of_its_settling(laws: &mut Laws) {
    laws.ask(&["step_move::continuous_move", "step_move::quarter_move"], || {
        let chain = kernel("step_move::continuous_move", &CONTINUOUS)
            .define("x4", "1")
            .define("t1", "1")
            .define("a3", "-ka3")
            .then(&judge_of("step_move::quarter_move"), &QUARTERS);
        let laws = ["v0 = kv0", "v3 = kv3", "t4 = kt4", "a0 = ka0", "x1 = kx1"].map(Law::new);
        let quarters = Points { origin: "the quarters".to_owned(), list: vec![vec![0.5, 0.5]] };
        chain.check(&quarters, &laws.each_ref().map(|law| law as &dyn Claim)).map(drop)
    });
}

fn fractions_and_times_undo_each_other(laws: &mut Laws) {
    let (frame, fraction) = ("step_move::symmetric_frame_step", "step_move::ki_of_t_ie_skip");
    laws.demand_inverse((frame, "tIESkip"), (fraction, "Ki"), &[]);
    laws.demand_inverse((fraction, "Ki"), (frame, "tIESkip"), &[("d2Step", "1")]);
    laws.demand("step_move::ki_of_v1_diff", &["Ki"], &["3*Ki >= 1", "Ki <= 1"]);
    let chain = kernel("step_move::ki_of_v1_diff", &["Ki"]).then(&judge_of("step_move::symmetric_frame"), &FRAME);
    laws.demand_of(&chain, &["kt4*v1Out = v1Diff"]);
}

fn the_ramp_from_rest_undoes_the_ramp_in(laws: &mut Laws) {
    let chain =
        kernel("turnaround::ramp_in", &["x0", "v0"]).then(&judge_of("step_move::ramp_from_rest"), &["t0", "a00"]);
    laws.demand_of(&chain, &["t0 = tIn", "a00 = a2Max"]);
}
