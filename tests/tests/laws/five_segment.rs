//! Laws of the symmetric step in five segments.
//!
//! It is at DeltaX*Ki/2 with v0 and a0 after t0, at DeltaX*Ko/2 with v1 and a1 after t1, has lost 2*a1 after t2, and
//! goes on as it began, mirrored in time.

use closedform_tests::budget::budget;
use closedform_tests::kernels::judge_of;
use closedform_tests::laws::Law;
use closedform_tests::laws::chain::{Chain, Claim};
use closedform_tests::laws::motion::Motion;
use closedform_tests::random::seed;

use crate::{Laws, MAKERS, kernel};

laws![
    the_equations_are_solved,
    the_move_closes,
    the_move_without_middle_closes,
    times_and_accelerations_undo_each_other,
    with_the_fraction_without_middle_the_move_by_accelerations_ends,
    without_acceleration_the_middle_is_at_constant_velocity,
];

/// The results of each kernel, in order.
const BY_ACCELERATIONS: [&str; 5] = ["t0", "Ko", "t2", "v0", "v1"];
const BY_TIMES: [&str; 5] = ["a0", "a1", "v0", "v1", "Ko"];

/// The ten equations of the worksheet, times their t^2: the accelerations at both ends of each segment. And what the two
/// of a segment make of its velocities.
const EQUATIONS: [&str; 12] = [
    "0 = 6*(DeltaX*Ki/2)-2*v0*t0",
    "a0*t0^2 = 4*v0*t0-6*(DeltaX*Ki/2)",
    "a0*t1^2 = 6*DeltaX*(Ko-Ki)/2-(2*v1+4*v0)*t1",
    "a1*t1^2 = (4*v1+2*v0)*t1-6*DeltaX*(Ko-Ki)/2",
    "a1*t2^2 = 6*DeltaX*(1-Ko)-(2*v1+4*v1)*t2",
    "-a1*t2^2 = (4*v1+2*v1)*t2-6*DeltaX*(1-Ko)",
    "-a1*t1^2 = 6*DeltaX*(Ko-Ki)/2-(2*v0+4*v1)*t1",
    "-a0*t1^2 = (4*v0+2*v1)*t1-6*DeltaX*(Ko-Ki)/2",
    "-a0*t0^2 = 6*(DeltaX*Ki/2)-(2*0+4*v0)*t0",
    "0 = (4*0+2*v0)*t0-6*(DeltaX*Ki/2)",
    "v0 = a0*t0/2",
    "v1 = v0+(a0+a1)*t1/2",
];

/// What makes it a move that never runs backward.
const ORDER: [&str; 5] = [
    "t0 > 0 and t1 > 0 and t2 > 0",
    "v0 > 0 and v1 > 0 and a0 > 0",
    "Ki <= Ko",
    "Ko <= 1",
    // In the middle, where the acceleration changes its sign, the velocity is v1+a1*t2/4.
    "4*v1+a1*t2 >= 0",
];

fn the_equations_are_solved(laws: &mut Laws) {
    for (name, results) in [("by_accelerations", BY_ACCELERATIONS), ("by_times", BY_TIMES)] {
        laws.demand(&format!("five_segment::{name}"), &results, &EQUATIONS);
        laws.demand(&format!("five_segment::{name}"), &results, &ORDER);
    }
}

fn the_move_closes(laws: &mut Laws) {
    let motion = Motion::from(["0", "0", "0"])
        .jerk("t0", "2*v0/t0^2", ["DeltaX*Ki/2", "v0", "a0"])
        .ramp("t1", ["DeltaX*Ko/2", "v1", "a1"])
        .jerk("t2", "-2*a1/t2", ["DeltaX*(1-Ko/2)", "v1", "-a1"])
        .ramp("t1", ["DeltaX*(1-Ki/2)", "v0", "-a0"])
        .jerk("t0", "2*v0/t0^2", ["DeltaX", "0", "0"]);
    laws.demand_motion(&kernel("five_segment::by_accelerations", &BY_ACCELERATIONS), &motion);
    laws.demand_motion(&kernel("five_segment::by_times", &BY_TIMES), &motion);
}

fn the_move_without_middle_closes(laws: &mut Laws) {
    // The acceleration jumps from a1 to -a1 in the middle.
    let chain = kernel("five_segment::ki_without_middle", &["Ki"])
        .define("t0", "sqrt(3*DeltaX*Ki/a0)")
        .define("x0", "a0*t0^2/6")
        .define("v0", "a0*t0/2");
    let v1 = "v0+(a0+a1)*t1/2";
    let motion = Motion::from(["0", "0", "0"])
        .jerk("t0", "a0/t0", ["x0", "v0", "a0"])
        .ramp("t1", ["DeltaX/2", v1, "a1"])
        .ramp("t1", ["DeltaX-x0", "v0", "-a0"])
        .after_jump_to("-a1")
        .jerk("t0", "a0/t0", ["DeltaX", "0", "0"]);
    laws.demand_motion(&chain, &motion);
    laws.demand_of(&chain, &["Ki > 0", "Ki <= 1", &format!("{v1} >= 0")]);
}

fn times_and_accelerations_undo_each_other(laws: &mut Laws) {
    let (accelerations, times) = (judge_of("five_segment::by_accelerations"), judge_of("five_segment::by_times"));
    let back = Chain::new(&accelerations, &BY_ACCELERATIONS).then(&times, &["A0", "A1", "V0", "V1", "KO"]);
    laws.demand_of(&back, &["A0 = a0", "A1 = a1", "V0 = v0", "V1 = v1", "KO = Ko"]);
    // Of the two times in the middle that have these accelerations, the shorter one comes back.
    let back = Chain::new(&times, &BY_TIMES).then(&accelerations, &["T0", "KO", "T2", "V0", "V1"]);
    laws.demand_of(
        &back,
        &["T0 = t0", "KO = Ko", "V0 = v0", "V1 = v1", "T2 <= t2", "(T2-t2)*(a1*(T2+t2)+6*v1) = 0", "T2 > 0"],
    );
}

/// How far from the edge of a domain a kernel that computes the edge is judged.
const NEAR: f64 = 1e-12;

fn with_the_fraction_without_middle_the_move_by_accelerations_ends(laws: &mut Laws) {
    laws.ask(&["five_segment::ki_without_middle", "five_segment::by_accelerations"], || {
        let (without, accelerations) =
            (judge_of("five_segment::ki_without_middle"), judge_of("five_segment::by_accelerations"));
        for maker in MAKERS {
            for inputs in without.space.inside(maker, seed(), budget().laws).list {
                let ki = without.actual(&inputs)[0];
                let admits = |ki| accelerations.space.admits(&[inputs[0], ki, inputs[1], inputs[2], inputs[3]]);
                assert!(admits(ki * (1.0 - NEAR)) && !admits(ki * (1.0 + NEAR)), "{inputs:?}: {ki}");
            }
        }
        Ok(())
    });
}

fn without_acceleration_the_middle_is_at_constant_velocity(laws: &mut Laws) {
    laws.ask(&["five_segment::by_accelerations"], || {
        let chain = kernel("five_segment::by_accelerations", &BY_ACCELERATIONS);
        let judge = judge_of("five_segment::by_accelerations");
        let mut points = chain.points(MAKERS[0], seed(), budget().laws);
        points.list.iter_mut().for_each(|inputs| inputs[3] = 0.0);
        points.list.retain(|inputs| judge.space.admits(inputs));
        assert!(2 * points.list.len() > budget().laws);
        let laws = ["v1*t2 = DeltaX*(1-Ko)", "a1 = 0"].map(Law::new);
        chain.check(&points, &laws.each_ref().map(|law| law as &dyn Claim)).map(drop)
    });
}
