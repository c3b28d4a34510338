//! Laws of the time of a straight cut.

use closedform_tests::check::Judge;
use closedform_tests::kernels::judge_of;
use closedform_tests::laws::motion::Motion;

use crate::{Laws, kernel};

laws![
    a_direction_has_norm_one_and_points_along_the_cut,
    a_step_takes_the_whole_acceleration,
    constant_acceleration_travels_the_length,
    short_steps_tend_to_constant_acceleration,
    a_cut_is_twice_constant_acceleration_from_rest_to_its_middle,
    axes_close_on_their_cut,
];

fn a_direction_has_norm_one_and_points_along_the_cut(laws: &mut Laws) {
    laws.demand(
        "milling_time::direction",
        &["s", "nx", "ny", "nz"],
        &[
            "s^2 = x^2+y^2+z^2",
            "nx^2+ny^2+nz^2 = 1",
            "s*nx = x",
            "s*ny = y",
            "s*nz = z",
            "nx*x+ny*y+nz*z = s",
            "s > 0",
            "x*nx >= 0 and y*ny >= 0 and z*nz >= 0",
        ],
    );
}

fn a_step_takes_the_whole_acceleration(laws: &mut Laws) {
    // In the time L/X the axis travels n*L at the speed of the end: u+a*L/X.
    laws.demand(
        "milling_time::step_speed",
        &["X"],
        &["a = (n*X-u)*X/L", "n*X = u+a*(L/X)", "n*L = u*(L/X)+a*(L/X)^2", "X > 0"],
    );
    laws.demand("milling_time::step_time", &["T"], &["T*X = L", "T > 0"]);
}

fn constant_acceleration_travels_the_length(laws: &mut Laws) {
    laws.demand(
        "milling_time::constant_acceleration",
        &["X", "T"],
        &["n*L = u*T+a*T^2/2", "n*X = u+a*T", "(n*X)^2 = u^2+2*a*n*L", "2*n*L = (u+n*X)*T", "X > 0 and T > 0"],
    );
    laws.demand("milling_time::cut_time", &["T"], &["n*s/2 = a*(T/2)^2/2", "T > 0"]);
}

/// Component, acceleration limit and length of cuts.
const CUTS: [[f64; 3]; 4] = [[1.0, 1000.0, 100.0], [0.6, 1000.0, 100.0], [0.01, 10.0, 1.0], [0.36, 10_000.0, 1000.0]];

/// The time of a cut from rest to rest in steps: those to its middle, doubled.
fn time_of_steps(step_speed: &Judge, step_time: &Judge, [n, a, s]: [f64; 3], steps: u32) -> f64 {
    let length = s / f64::from(2 * steps);
    let (mut axis, mut time) = (0.0, 0.0);
    for _ in 0..steps {
        let speed = step_speed.actual(&[n, axis, a, length])[0];
        time += step_time.actual(&[length, speed])[0];
        axis = n * speed;
    }
    2.0 * time
}

fn short_steps_tend_to_constant_acceleration(laws: &mut Laws) {
    let kernels = ["milling_time::step_speed", "milling_time::step_time", "milling_time::cut_time"];
    laws.ask(&kernels, move || {
        let [step_speed, step_time, cut_time] = kernels.map(judge_of);
        for cut in CUTS {
            let whole = cut_time.actual(&cut)[0];
            let missing = [1, 10, 100, 1_000, 10_000].map(|steps| {
                let time = time_of_steps(&step_speed, &step_time, cut, steps);
                1.0 - time / whole
            });
            assert!(missing.is_sorted_by(|one, next| one > next), "{cut:?}: {missing:?}");
            assert!(missing[4] > 0.0 && missing[4] < 5e-4, "{cut:?}: {missing:?}");
            // One step: the factor sqrt(2) of the worksheet.
            assert!((missing[0] - (1.0 - 0.5_f64.sqrt())).abs() < 1e-14, "{cut:?}: {missing:?}");
        }
        Ok(())
    });
}

fn a_cut_is_twice_constant_acceleration_from_rest_to_its_middle(laws: &mut Laws) {
    let kernels = ["milling_time::cut_time", "milling_time::constant_acceleration"];
    laws.ask(&kernels, move || {
        let [cut_time, half] = kernels.map(judge_of);
        // An ulp is at most EPSILON of its number.
        let bounds = (cut_time.bound(0) + half.bound(1)) * f64::EPSILON;
        for [n, a, s] in CUTS {
            let (whole, half) = (cut_time.actual(&[n, a, s])[0], half.actual(&[n, 0.0, a, s / 2.0])[1]);
            assert!((whole - 2.0 * half).abs() <= bounds * whole, "{n} {a} {s}: {whole}, {half}");
        }
        Ok(())
    });
}

fn axes_close_on_their_cut(laws: &mut Laws) {
    let constant = Motion::from(["0", "u", "a"]).jerk("T", "0", ["n*L", "n*X", "a"]);
    laws.demand_motion(&kernel("milling_time::constant_acceleration", &["X", "T"]), &constant);
    let cut = Motion::from(["0", "0", "a"])
        .jerk("T/2", "0", ["n*s/2", "a*T/2", "a"])
        .jerk("T/2", "0", ["n*s", "0", "-a"])
        .after_jump_to("-a");
    laws.demand_motion(&kernel("milling_time::cut_time", &["T"]), &cut);
    // A step is driven at the speed of its end; the acceleration takes the axis there in its time.
    let chain = kernel("milling_time::step_speed", &["X"]).then(&judge_of("milling_time::step_time"), &["T"]);
    let driven = Motion::from(["0", "n*X", "0"]).jerk("T", "0", ["n*L", "n*X", "0"]);
    let reached = Motion::from(["0", "u", "a"]).jerk("T", "0", ["n*L-a*T^2/2", "n*X", "a"]);
    laws.demand_motions(&chain, &driven, &reached);
}
