//! Calls whose steps over- or underflow, and whose results do: each number and each refusal is right all the same.

use closedform::{CallError, RangeReason};
use closedform_tests::hex::parse;
use closedform_tests::inputs::Points;
use closedform_tests::kernels::judge_of;
use closedform_tests::shapes::{check_batch, check_domain, check_range};
use closedform_tests::ulp::{self, F64};

fn point(inputs: &[&str]) -> Vec<f64> {
    inputs.iter().map(|input| parse(input).unwrap_or_else(|| panic!("{input}"))).collect()
}

/// Demands of every shape of a call what it promises at a point inside the domain, or outside.
fn demand(kernel: &str, inputs: &[&str], inside: bool) {
    let (judge, inputs) = (judge_of(kernel), point(inputs));
    assert_eq!(judge.space.admits(&inputs), inside, "{kernel} {inputs:?}");
    let points = Points { origin: "known".to_owned(), list: vec![inputs.clone()] };
    let shapes = [check_domain, check_batch].iter().try_for_each(|check| check(&judge, &points));
    shapes.unwrap_or_else(|broken| panic!("{broken}"));
    let mut faithful = judge.actual(&inputs);
    judge.kernel.faithful(&inputs, &mut faithful).expect("as many results as it has");
    if !inside {
        assert!(faithful.iter().all(|result| result.is_nan()), "{kernel} {inputs:?}: {faithful:?}");
        return;
    }
    check_range(&judge, &points).unwrap_or_else(|broken| panic!("{broken}"));
    judge.errors(&inputs, "known").unwrap_or_else(|broken| panic!("{broken}"));
    for (result, value) in faithful.into_iter().enumerate() {
        let error = ulp::distance(value, &judge.exact(result, &inputs), F64);
        assert!(error < 0.5001, "{kernel} {inputs:?}: faithful {value:?}, {error} ulp");
    }
}

fn lost(kernel: &str, inputs: &[&str]) -> Option<RangeReason> {
    let (judge, inputs) = (judge_of(kernel), point(inputs));
    match judge.kernel.checked(&inputs, &mut judge.actual(&inputs)) {
        Ok(()) => None,
        Err(CallError::Range(error)) => Some(error.reason()),
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn conditions_are_decided_where_they_underflow() {
    let [above, below] = [true, false];
    demand("turnaround::t_edge_of_t_in", &["0x1.8p-4", "0x0.0000000000001p-1022", "0x1.8p-9"], below);
    demand("turnaround::tau_without_skip", &["0x1.3988e1409212ep-535", "0x0.0000000000008p-1022"], above);
    let t_in = ["0x1p-519", "0x1.00000000ffeebp-524", "0x1.f43a729f85afdp-512", "0x1.70c30c30ce380p-17"];
    demand("optimum::t_in", &t_in, below);
    // 3 delta against tIn^2 around 2^-1072, where no product is a number of its own: 3 * 2^-1074 < 2^-1072 < 6 * 2^-1074
    demand("turnaround::tau_without_skip", &["0x1p-536", "0x0.0000000000001p-1022"], below);
    demand("turnaround::tau_without_skip", &["0x1p-536", "0x0.0000000000002p-1022"], above);
    // and around 2^1024
    demand("turnaround::tau_without_skip", &["0x1.fffffffffffffp511", "0x1.5555555555555p1022"], above);
    demand("turnaround::tau_without_skip", &["0x1.0000000000001p512", "0x1.5555555555555p1022"], below);
    demand("turnaround::tau_without_skip", &["0x1p1000", "0x1p1000"], below);
}

#[test]
fn an_iterate_keeps_its_digits_below_the_smallest_number() {
    demand("optimum::t_i", &["0x1.ap0", "0x1.6p0", "0x0.0000000000003p-1022", "0x1.fffffffffffffp-4"], true);
    let t_in = ["0x1.ab79efc9e0649p3", "0x0.0000000000002p-1022", "0x1.d160948667c88p2", "0x1.2p3"];
    demand("optimum::t_in", &t_in, true);
    let t_i = ["0x1.fcca825ed4318p-3", "0x1.e02ac15a63773p0", "0x0.0000000000004p-1022", "0x1.efb5c7f98332ep2"];
    demand("optimum::t_i", &t_i, true);
}

#[test]
fn products_that_some_targets_cannot_split_are_right_on_all() {
    demand("pvt::acceleration_at", &["0x1.fffffffffffffp-1", "0x1p1023", "0x1p1023", "0x1p-1"], true);
    demand("turnaround::tau_without_skip", &["0x1.8017dc1cbc481p-765", "0x1.0545baba9c8f7p1015"], true);
    let quartic = ["0x1.573d68f903ea2p-512", "0x1.7e43c8800759cp996", "0x1p1023", "0x1.fffffffffffffp1023"];
    demand("optimum::quartic", &quartic, true);
}

#[test]
fn squares_that_leave_the_range_leave_no_trace() {
    for exponent in [-1073, -900, -511, 0, 511, 700, 1020] {
        let side = |factor: f64| format!("0x{}p{exponent}", if factor > 1.0 { "1.8" } else { "1" });
        demand("milling_time::direction", &[&side(1.0), &side(1.5), &side(1.0)], true);
    }
    demand("milling_time::constant_acceleration", &["0x1p-540", "0x0p0", "0x1p-530", "0x1p0"], true);
}

#[test]
fn what_f64_cannot_hold_is_an_error() {
    let quartic = ["0x0.0000000000001p-1022", "0x0.0000000000001p-1022", "-0x1.fffffffffffffp1023", "0x1p0"];
    assert_eq!(lost("optimum::quartic", &quartic), Some(RangeReason::Overflow));
    demand("optimum::quartic", &quartic, true);
    assert_eq!(lost("milling_time::step_time", &["0x1p600", "0x1p-600"]), Some(RangeReason::Overflow));
    assert_eq!(lost("milling_time::step_time", &["0x1p-600", "0x1p600"]), Some(RangeReason::Underflow));
    assert_eq!(lost("milling_time::step_time", &["0x1.8p-600", "0x1p473"]), None, "exact, though it is subnormal");
    demand("milling_time::step_time", &["0x1.8p-600", "0x1p473"], true);
    assert_eq!(lost("milling_time::step_time", &["0x1p-600", "0x1p400"]), None);
}
