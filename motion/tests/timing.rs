//! Waypoints under limits: limits are kept and met, a search is no slower, and ends have the velocities that are asked for.

mod support;

use closedform_motion::plan::waypoints::{Freedom, Problem, Timing, WaypointPlan, Waypoints};
use closedform_motion::{Limits, PlanError, Quantity};
use support::{EPS, Random};

const NONE: f64 = f64::INFINITY;

fn random(random: &mut Random) -> (Vec<Vec<f64>>, Vec<Limits>) {
    let dimension = 1 + (random.unit() * 7.0) as usize;
    let count = 4 + (random.unit() * 8.0) as usize;
    let unit = random.decades(-6.0, 6.0);
    let point = |random: &mut Random| (0..dimension).map(|_| unit * random.between(-1.0, 1.0)).collect();
    let points = (0..count).map(|_| point(random)).collect();
    let limit = |random: &mut Random| unit * random.decades(-6.0, 6.0);
    let limits = |random: &mut Random| Limits { velocity: limit(random), acceleration: limit(random), jerk: NONE };
    (points, (0..dimension).map(|_| limits(random)).collect())
}

/// How much of its limits a plan uses: the largest share.
fn share(plan: &WaypointPlan) -> f64 {
    let mut most = 0.0_f64;
    for axis in plan.motion().axes() {
        for (quantity, limit) in [
            (Quantity::Velocity, axis.limits.velocity),
            (Quantity::Acceleration, axis.limits.acceleration),
            (Quantity::Jerk, axis.limits.jerk),
        ] {
            most = most.max(axis.profile.extremes(quantity).peak().value.abs() / limit);
        }
    }
    most
}

#[test]
fn the_fastest_timing_meets_a_limit_and_passes_none() {
    let mut source = Random(1801);
    for _ in 0..2000 {
        let (points, limits) = random(&mut source);
        for problem in [Problem::CubicsAtRest, Problem::QuarticCubicQuarticAtRest, Problem::QuadraticCubicQuadratic] {
            let path = Waypoints {
                limits: limits.clone(),
                ..Waypoints::new(problem, points.clone(), Timing::Fastest(Freedom::Factor))
            };
            let plan = path.plan().unwrap_or_else(|error| panic!("{path:?}: {error}"));
            let share = share(&plan);
            assert!((1.0 - 1e-9..=1.0 + 64.0 * EPS).contains(&share), "{path:?}: {share}");
        }
    }
}

#[test]
fn a_search_is_no_slower_and_keeps_the_points() {
    let mut source = Random(1802);
    let mut sum = (0.0, 0.0);
    for _ in 0..60 {
        let (points, limits) = random(&mut source);
        let path = |freedom| Waypoints {
            limits: limits.clone(),
            ..Waypoints::new(Problem::CubicsAtRest, points.clone(), Timing::Fastest(freedom))
        };
        let plans = [Freedom::Factor, Freedom::Segments].map(|freedom| path(freedom).plan().expect("a plan"));
        let [factor, segments] = [0, 1].map(|index: usize| plans[index].motion().duration());
        assert!(segments <= factor * (1.0 + 1e-12), "{segments} against {factor}");
        assert!(share(&plans[1]) <= 1.0 + 64.0 * EPS);
        for (axis, profile) in plans[1].profiles().iter().enumerate() {
            let ends: Vec<f64> = profile.segments().iter().map(|segment| segment.start.position).collect();
            assert!(ends.iter().zip(&points).all(|(end, point)| *end == point[axis]));
        }
        sum = (sum.0 + factor / factor, sum.1 + segments / factor);
    }
    assert!(sum.1 < 0.95 * sum.0, "{sum:?}");
}

#[test]
fn two_points_and_three_and_any_number_of_coordinates() {
    let points =
        |count: usize| (0..count).map(|i| (0..7).map(|axis| (i * i + axis) as f64).collect()).collect::<Vec<_>>();
    for (problem, count) in [
        (Problem::Linear, 2),
        (Problem::CubicsAtRest, 2),
        (Problem::CubicsAtRest, 3),
        (Problem::QuarticCubicQuarticAtRest, 3),
    ] {
        let plan = Waypoints::new(problem, points(count), Timing::Speed(2.0)).plan().expect("a plan");
        assert_eq!(plan.motion().axes().len(), 7);
        for profile in plan.profiles() {
            let smooth = profile.smoothness();
            assert!(smooth.closing.position < 1e-14 && smooth.closing.velocity < 1e-13, "{problem:?} {smooth:?}");
            if problem == Problem::QuarticCubicQuarticAtRest {
                let [start, end] = [profile.start(), profile.end()];
                assert_eq!([start.velocity, start.acceleration, end.velocity, end.acceleration], [0.0; 4]);
                assert_eq!(smooth.order(), 2);
            }
        }
    }
    for problem in [Problem::QuadraticLinearQuadratic, Problem::QuarticCubicQuarticAtRest] {
        assert!(Waypoints::new(problem, points(2), Timing::Speed(1.0)).plan().is_err());
    }
}

#[test]
fn ends_have_the_velocities_that_are_asked_for() {
    let points = [vec![0.0, 0.0], vec![1.0, 2.0], vec![3.0, 1.0], vec![4.0, 0.0], vec![6.0, 6.0]];
    for count in 2..=5 {
        let path = Waypoints::new(Problem::CubicsAtRest, points[..count].to_vec(), Timing::Speed(1.5));
        let path = Waypoints { ends: [vec![0.5, -0.25], vec![1.0, 0.0]], ..path };
        let plan = path.plan().expect("a plan");
        for (axis, profile) in plan.profiles().iter().enumerate() {
            assert_eq!(profile.start().velocity, path.ends[0][axis]);
            assert_eq!(profile.end().velocity, path.ends[1][axis]);
            let smooth = profile.smoothness();
            assert_eq!(smooth.order(), 2);
            assert!(smooth.closing.position < 1e-14 && smooth.closing.velocity < 1e-14, "{smooth:?}");
        }
        let other = Waypoints { problem: Problem::Linear, ..path.clone() };
        assert!(matches!(other.plan(), Err(PlanError::Input { .. })));
    }
}

#[test]
fn limits_that_no_timing_keeps_are_said() {
    let points = vec![vec![0.0], vec![1.0], vec![0.0], vec![2.0]];
    let fastest = |problem, limits| {
        Waypoints { limits: vec![limits], ..Waypoints::new(problem, points.clone(), Timing::Fastest(Freedom::Factor)) }
            .plan()
    };
    let limits = Limits { velocity: 1.0, acceleration: 1.0, jerk: 1.0 };
    assert!(matches!(fastest(Problem::CubicsAtRest, limits), Err(PlanError::Jump { .. })));
    assert!(fastest(Problem::QuarticCubicQuarticAtRest, limits).is_ok());
    assert!(fastest(Problem::Linear, Limits { velocity: 1.0, ..Limits::NONE }).is_ok());
    assert!(fastest(Problem::Linear, limits).is_err() && fastest(Problem::CubicsAtRest, Limits::NONE).is_err());
    let slow = Waypoints { limits: vec![limits], ..Waypoints::new(Problem::CubicsAtRest, points, Timing::Speed(10.0)) };
    assert!(matches!(slow.plan(), Err(PlanError::Limit { .. })));
}

#[test]
fn overshoot_is_what_lies_beyond_the_points() {
    let points = vec![vec![0.0], vec![0.5], vec![1.0], vec![10.0]];
    let path = Waypoints::new(Problem::CubicsAtRest, points.clone(), Timing::Durations(vec![1.0; 3]));
    let [below, above] = path.plan().expect("a plan").overshoot(&points)[0];
    // by the spline's own equations, 1/t = 1: accelerations (-15.9, 33.3, ..)/..; sampled finely here
    let profile = path.plan().expect("a plan").profiles()[0].clone();
    let least = (0..=300_000).map(|i| profile.at(f64::from(i) * 1e-5).position).fold(NONE, f64::min);
    assert!((below + least).abs() < 1e-9 && below > 0.0 && above <= 0.0, "{below} {above}");
}
