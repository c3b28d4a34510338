//! Points whose steps over- or underflow, or whose results do: each number and each refusal is right all the same.

use closedform::{CallError, Info, RangeReason};
use closedform_project::hexfloat::parse;

use crate::check::Judge;
use crate::failure::{list, replay};
use crate::harness::Said;
use crate::inputs::Points;
use crate::shapes::{check_batch, check_domain, check_range};
use crate::ulp::{self, F64};

/// What a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Is {
    /// Inside the domain.
    Inside,
    /// Outside.
    Outside,
    /// Inside, with results that `f64` holds: exact ones, where they are subnormal.
    Held,
    /// Inside, with a result that `f64` cannot hold.
    Lost(RangeReason),
}

use Is::{Held, Inside, Lost, Outside};

/// Points of a kernel, and why they are looked at.
type Known = (&'static str, &'static str, &'static [(Is, &'static [&'static str])]);

/// All of them.
const KNOWN: [Known; 9] = [
    (
        "turnaround::t_edge_of_t_in",
        "a condition is decided where it underflows",
        &[(Outside, &["0x1.8p-4", "0x0.0000000000001p-1022", "0x1.8p-9"])],
    ),
    (
        "turnaround::tau_without_skip",
        "a condition is decided where it underflows, 3 delta against tIn^2 around 2^-1072, and around 2^1024",
        &[
            (Inside, &["0x1.3988e1409212ep-535", "0x0.0000000000008p-1022"]),
            (Outside, &["0x1p-536", "0x0.0000000000001p-1022"]),
            (Inside, &["0x1p-536", "0x0.0000000000002p-1022"]),
            (Inside, &["0x1.fffffffffffffp511", "0x1.5555555555555p1022"]),
            (Outside, &["0x1.0000000000001p512", "0x1.5555555555555p1022"]),
            (Outside, &["0x1p1000", "0x1p1000"]),
            // a product that some targets cannot split
            (Inside, &["0x1.8017dc1cbc481p-765", "0x1.0545baba9c8f7p1015"]),
        ],
    ),
    (
        "optimum::t_in",
        "a condition underflows, and an iterate keeps its digits below the smallest number",
        &[
            (Outside, &["0x1p-519", "0x1.00000000ffeebp-524", "0x1.f43a729f85afdp-512", "0x1.70c30c30ce380p-17"]),
            (Inside, &["0x1.ab79efc9e0649p3", "0x0.0000000000002p-1022", "0x1.d160948667c88p2", "0x1.2p3"]),
        ],
    ),
    (
        "optimum::t_i",
        "an iterate keeps its digits below the smallest number, and where 8*v^2 cancels against 3*a^2*delta",
        &[
            (Inside, &["0x1.ap0", "0x1.6p0", "0x0.0000000000003p-1022", "0x1.fffffffffffffp-4"]),
            (
                Inside,
                &["0x1.fcca825ed4318p-3", "0x1.e02ac15a63773p0", "0x0.0000000000004p-1022", "0x1.efb5c7f98332ep2"],
            ),
            (
                Inside,
                &["0x1.9755d4de3fa85p+0", "0x1.1a2b8f1cd87e6p+0", "0x1.a95a5b7f87a0fp-117", "0x1.47964c2d6d9ffp+0"],
            ),
            (
                Inside,
                &["0x1.6ec9d2937021cp+0", "0x1.c324c9988c8e2p+0", "0x1.9b604aaaca626p-200", "0x1.0231da7a68879p+2"],
            ),
        ],
    ),
    (
        "pvt::acceleration_at",
        "a product that some targets cannot split",
        &[(Inside, &["0x1.fffffffffffffp-1", "0x1p1023", "0x1p1023", "0x1p-1"])],
    ),
    (
        "optimum::quartic",
        "a product that some targets cannot split, and a root that f64 cannot hold",
        &[
            (Inside, &["0x1.573d68f903ea2p-512", "0x1.7e43c8800759cp996", "0x1p1023", "0x1.fffffffffffffp1023"]),
            (
                Lost(RangeReason::Overflow),
                &["0x0.0000000000001p-1022", "0x0.0000000000001p-1022", "-0x1.fffffffffffffp1023", "0x1p0"],
            ),
        ],
    ),
    (
        "milling_time::direction",
        "squares that leave the range leave no trace",
        &[
            (Inside, &["0x1p-1073", "0x1.8p-1073", "0x1p-1073"]),
            (Inside, &["0x1p-900", "0x1.8p-900", "0x1p-900"]),
            (Inside, &["0x1p-511", "0x1.8p-511", "0x1p-511"]),
            (Inside, &["0x1p0", "0x1.8p0", "0x1p0"]),
            (Inside, &["0x1p511", "0x1.8p511", "0x1p511"]),
            (Inside, &["0x1p700", "0x1.8p700", "0x1p700"]),
            (Inside, &["0x1p1020", "0x1.8p1020", "0x1p1020"]),
        ],
    ),
    (
        "milling_time::constant_acceleration",
        "squares that leave the range leave no trace",
        &[(Inside, &["0x1p-540", "0x0p0", "0x1p-530", "0x1p0"])],
    ),
    (
        "milling_time::step_time",
        "what f64 cannot hold is an error",
        &[
            (Lost(RangeReason::Overflow), &["0x1p600", "0x1p-600"]),
            (Lost(RangeReason::Underflow), &["0x1p-600", "0x1p600"]),
            (Held, &["0x1.8p-600", "0x1p473"]),
            (Held, &["0x1p-600", "0x1p400"]),
        ],
    ),
];

fn known(info: &Info) -> Option<&'static Known> {
    KNOWN.iter().find(|(kernel, ..)| *kernel == info.name)
}

/// Whether points of the kernel are known.
pub fn concerns(info: &Info) -> bool {
    known(info).is_some()
}

/// Every shape of a call keeps its promise at the known points.
pub fn answer(judge: &Judge) -> Said {
    let (_, why, points) = known(judge.kernel.info).ok_or("no points are known")?;
    for (is, inputs) in *points {
        let inputs: Vec<f64> =
            inputs.iter().map(|input| parse(input).unwrap_or_else(|error| panic!("{error}"))).collect();
        check(judge, *is, &inputs).map_err(|broken| {
            let info = judge.kernel.info;
            format!("{}: {why}: {broken}\n{}  {}", info.name, list(info, &inputs), replay(info, &inputs))
        })?;
    }
    Ok(format!("{} points: {why}", points.len()))
}

fn check(judge: &Judge, is: Is, inputs: &[f64]) -> Result<(), String> {
    let inside = is != Outside;
    if judge.space.admits(inputs) != inside {
        return Err(format!("the contract says that the point is not {is:?}"));
    }
    let points = Points { origin: "known".to_owned(), list: vec![inputs.to_vec()] };
    [check_domain, check_batch].iter().try_for_each(|check| check(judge, &points))?;
    let mut faithful = judge.actual(inputs);
    judge.kernel.faithful(inputs, &mut faithful).map_err(|error| error.to_string())?;
    if !inside {
        let refused = faithful.iter().all(|result| result.is_nan());
        return refused.then_some(()).ok_or_else(|| format!("faithful {faithful:?} outside"));
    }
    check_range(judge, &points)?;
    judge.errors(inputs, "known").map_err(|broken| broken.to_string())?;
    for (result, value) in faithful.into_iter().enumerate() {
        let error = ulp::distance(value, &judge.exact(result, inputs), F64);
        if error >= 0.5001 {
            return Err(format!("faithful {value:?}, {error} ulp"));
        }
    }
    let expected = match is {
        Lost(reason) => Some(reason),
        Held => None,
        Inside | Outside => return Ok(()),
    };
    let lost = lost(judge, inputs)?;
    if lost == expected { Ok(()) } else { Err(format!("lost by {lost:?}, not by {expected:?}")) }
}

/// Why `f64` cannot hold a result, as `checked` says.
fn lost(judge: &Judge, inputs: &[f64]) -> Result<Option<RangeReason>, String> {
    match judge.kernel.checked(inputs, &mut judge.actual(inputs)) {
        Ok(()) => Ok(None),
        Err(CallError::Range(error)) => Ok(Some(error.reason())),
        Err(other) => Err(other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels;

    #[test]
    fn every_known_point_is_one_of_a_kernel() {
        for (name, _, points) in KNOWN {
            let judge = kernels::judge_of(name);
            let wanted = judge.kernel.info.inputs.len();
            let fit = |inputs: &[&str]| inputs.len() == wanted && inputs.iter().all(|input| parse(input).is_ok());
            assert!(!points.is_empty() && points.iter().all(|(_, inputs)| fit(inputs)), "{name}");
        }
    }

    #[test]
    fn a_point_that_is_something_else_is_told() {
        let judge = kernels::judge_of("milling_time::step_time");
        let point = [600.0_f64.exp2(), (-600.0_f64).exp2()];
        assert_eq!(check(&judge, Lost(RangeReason::Overflow), &point), Ok(()));
        for other in [Outside, Held, Lost(RangeReason::Underflow)] {
            assert!(check(&judge, other, &point).is_err(), "{other:?}");
        }
    }
}
