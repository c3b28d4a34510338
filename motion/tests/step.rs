//! Steps of one axis: exact integration, what was asked for, limits, scaling, random problems and bad input.

mod support;

use closedform_motion::plan::five_segment::{FiveSegment, FiveSegmentBy};
use closedform_motion::plan::step_move::{Frame, StepMove, StepShape, StepTime};
use closedform_motion::{Limits, Motion, PlanError, Quantity};
use support::{CLOSING, EPS, Random, closing, closing_in_reach, integrates, problems};

fn steps() -> Vec<StepMove> {
    let mut steps = Vec::new();
    for travel in [1e-3, 7.0] {
        for (a3, t1) in [(-0.1, 0.01), (-0.25, 0.015), (-1e-6, 1e-4)] {
            let per = (travel / 1e-3_f64).sqrt();
            steps.push(StepMove::new(travel, StepShape::Quarter { a3, t1: t1 * per }));
        }
        for (ki, ko) in [(0.5, 0.5), (0.34, 0.01), (0.3, 0.25), (0.9, 1.05), (0.01, 1.98)] {
            for time in [StepTime::Total(0.2), StepTime::Middle(0.01)] {
                steps.push(StepMove::new(travel, StepShape::Fractions { ki, ko, time }));
            }
        }
        for ki in [0.34, 0.5, 0.9, 0.999] {
            steps.push(StepMove::new(travel, StepShape::Symmetric { frame: Frame::Ki(ki), t_out: 0.004 }));
        }
        for t in [0.00401, 0.005, 0.1, 50.0] {
            steps.push(StepMove::new(travel, StepShape::Symmetric { frame: Frame::TIESkip(t), t_out: 0.004 }));
        }
    }
    steps
}

fn fives() -> Vec<FiveSegment> {
    let mut fives = Vec::new();
    for (ki, a0, a1, t1) in
        [(0.05, 2.0, 1.0, 0.01), (0.1, 2.0, -0.5, 0.01), (0.1, 2.0, 0.0, 0.01), (0.3, 2.0, -0.4, 0.001)]
    {
        fives.push(FiveSegment::new(1e-3, ki, FiveSegmentBy::Accelerations { a0, a1, t1 }));
    }
    for (ki, t0, t1, t2) in [(0.1, 0.01, 0.01, 0.01), (0.01, 0.01, 0.02, 0.04), (0.9, 1.0, 0.01, 0.01)] {
        fives.push(FiveSegment::new(1e-3, ki, FiveSegmentBy::Times { t0, t1, t2 }));
    }
    fives
}

fn check(motion: &Motion, travel: f64, what: &str) {
    let profile = &motion.axes()[0].profile;
    integrates(profile, what);
    assert_eq!((profile.start().position, profile.end().position), (0.0, travel), "{what}");
    assert_eq!((profile.start().velocity, profile.end().velocity), (0.0, 0.0), "{what}");
    assert_eq!(profile.smoothness().velocity.size, 0.0, "{what}");
    // it never runs backwards
    let least = profile.extremes(Quantity::Velocity);
    assert!(least.least.value >= -CLOSING * EPS * least.largest.value, "{what}: {least:?}");
}

#[test]
fn steps_integrate_and_are_what_was_asked_for() {
    for step in steps() {
        let what = format!("{step:?}");
        let plan = step.plan().unwrap_or_else(|error| panic!("{what}: {error}"));
        check(plan.motion(), step.travel, &what);
        let continuous = plan.motion().axes()[0].profile.smoothness().acceleration.size == 0.0;
        match step.shape {
            StepShape::Quarter { a3, t1 } => {
                assert_eq!((plan.a3, plan.times[1], plan.times[2]), (a3, t1, t1));
                assert_eq!(plan.positions[0], step.travel / 4.0);
                assert!(plan.a0 > 0.0 && !continuous);
            }
            StepShape::Fractions { ki, ko, time } => {
                assert_eq!((plan.ki, plan.ko), (ki, ko));
                match time {
                    StepTime::Middle(t1) => assert_eq!(plan.times[1], t1),
                    // 4 sums and products
                    StepTime::Total(total) => assert!((plan.duration() - total).abs() <= 8.0 * EPS * total),
                }
                assert!(continuous, "{what}");
            }
            StepShape::Symmetric { frame, t_out } => {
                assert_eq!((plan.times[0], plan.times[1]), (plan.times[3], t_out));
                match frame {
                    Frame::Ki(ki) => assert_eq!(plan.ki, ki),
                    Frame::TIESkip(t) => assert_eq!(plan.times[0], t),
                }
                assert!(continuous, "{what}");
            }
        }
    }
}

#[test]
fn both_ways_to_a_symmetric_frame_agree() {
    for (t, t_out) in [(0.0041, 0.004), (0.01, 0.004), (0.5, 0.004)] {
        let shape = |frame| StepMove::new(1e-3, StepShape::Symmetric { frame, t_out }).plan().expect("a plan");
        let by_time = shape(Frame::TIESkip(t));
        let by_ki = shape(Frame::Ki(by_time.ki));
        // ki is rounded: 1-ki and 3*ki-1, which kernels take from it, carry that
        let lost = 1.0 / (1.0 - by_time.ki) + 1.0 / (3.0 * by_time.ki - 1.0);
        let near = |a: f64, b: f64| assert!((a - b).abs() <= (16.0 + 8.0 * lost) * EPS * a.abs(), "{a} {b}");
        near(by_time.times[0], by_ki.times[0]);
        near(by_time.positions[1], by_ki.positions[1]);
        near(by_time.positions[2], by_ki.positions[2]);
        near(by_time.v0, by_ki.v0);
        near(by_time.v3, by_ki.v3);
        near(by_time.a0, by_ki.a0);
        near(by_time.a3, by_ki.a3);
        near(by_time.ko, by_ki.ko);
    }
}

#[test]
fn five_segments_integrate_and_are_symmetric() {
    for five in fives() {
        let what = format!("{five:?}");
        let plan = five.plan().unwrap_or_else(|error| panic!("{what}: {error}"));
        check(plan.motion(), five.delta_x, &what);
        let profile = &plan.motion().axes()[0].profile;
        assert_eq!(profile.smoothness().order(), 2, "{what}");
        match five.given {
            FiveSegmentBy::Accelerations { a0, a1, t1 } => assert_eq!((plan.a0, plan.a1, plan.t1), (a0, a1, t1)),
            FiveSegmentBy::Times { t0, t1, t2 } => assert_eq!((plan.t0, plan.t1, plan.t2), (t0, t1, t2)),
        }
        for n in 0..=100 {
            let time = plan.duration() * f64::from(n) / 200.0;
            let (there, back) = (profile.at(time), profile.at(plan.duration() - time));
            let peak = profile.extremes(Quantity::Velocity).largest.value;
            // the two times are mirrored but for rounding, and velocity changes by acceleration times that
            let off = 16.0 * EPS * (peak + plan.a0.max(plan.a1.abs()) * plan.duration());
            assert!((there.velocity - back.velocity).abs() <= off, "{what}: {time}");
        }
    }
}

#[test]
fn limits_are_named_with_what_is_needed() {
    let step = steps()[3];
    let peaks = step.plan().expect("a plan").motion().peaks();
    let (v, a, j) = (peaks[0].velocity.at.value, peaks[0].acceleration.at.value, peaks[0].jerk.at.value);
    let with = |limits| StepMove { limits, ..step }.plan();
    let exactly = Limits { velocity: v.abs(), acceleration: a.abs(), jerk: j.abs() };
    assert!(with(exactly).is_ok());
    let fails = |limits, name: &str, needed: f64| match with(limits) {
        Err(PlanError::Limit { name: found, needed: is, .. }) => assert_eq!((found, is), (name, needed.abs())),
        other => panic!("{other:?}"),
    };
    fails(Limits { velocity: v.abs() * 0.999, ..exactly }, "velocity", v);
    fails(Limits { acceleration: a.abs() * 0.999, ..exactly }, "acceleration", a);
    fails(Limits { jerk: j.abs() * 0.999, ..exactly }, "jerk", j);
    assert!(with(Limits { jerk: f64::NAN, ..exactly }).is_err());
    assert!(with(Limits { velocity: 0.0, ..exactly }).is_err());
}

#[test]
fn random_steps_over_twelve_decades_plan() {
    let mut random = Random(5);
    let mut worst = 0.0_f64;
    for n in 0..problems() {
        let (travel, time) = (random.decades(-6.0, 6.0), random.decades(-6.0, 6.0));
        let motion = match n % 5 {
            0 => {
                // t1*sqrt(-a3/travel) < (sqrt(114)-3*sqrt(6))/10 = 0.33286
                let a3 = -travel * (0.33286 * random.between(1e-3, 1.0) / time).powi(2);
                StepMove::new(travel, StepShape::Quarter { a3, t1: time }).plan().map(|plan| plan.motion().clone())
            }
            1 => {
                let ki = random.between(1e-3, 1.999);
                let (low, high) = ((2.0 - 6.0 * ki).max(0.0), 2.0 - ki);
                let ko = low + (high - low) * random.between(1e-6, 1.0 - 1e-6);
                let shape = StepShape::Fractions { ki, ko, time: StepTime::Total(time) };
                StepMove::new(travel, shape).plan().map(|plan| plan.motion().clone())
            }
            2 => {
                let frame = Frame::TIESkip(time * (1.0 + random.decades(-6.0, 6.0)));
                StepMove::new(travel, StepShape::Symmetric { frame, t_out: time })
                    .plan()
                    .map(|plan| plan.motion().clone())
            }
            3 => {
                let (t0, t1, t2) = (time, time * random.decades(-3.0, 3.0), time * random.decades(-3.0, 3.0));
                let most = 2.0 * t0 * t0 / ((t0 + t1) * (2.0 * t0 + 2.0 * t1 + t2));
                let given = FiveSegmentBy::Times { t0, t1, t2 };
                FiveSegment::new(travel, most * random.unit().max(1e-9), given).plan().map(|plan| plan.motion().clone())
            }
            _ => {
                // below the ki that leaves no time in the middle
                let a0 = travel / time / time * random.decades(-3.0, 3.0);
                let a1 = a0 * random.decades(-3.0, 1.0);
                let t1 = (3.0 * travel / (2.0 * a0 + a1)).sqrt() * random.unit().max(1e-6);
                let most = closedform_kernels::five_segment::ki_without_middle(travel, a0, a1, t1);
                let ki = most * random.between(1e-3, 0.999);
                let given = FiveSegmentBy::Accelerations { a0, a1, t1 };
                FiveSegment::new(travel, ki, given).plan().map(|plan| plan.motion().clone())
            }
        };
        let motion = motion.unwrap_or_else(|error| panic!("problem {n}: {travel} {time}: {error}"));
        let off = closing(&motion.axes()[0].profile);
        worst = worst.max(off);
        assert!(off <= CLOSING, "problem {n}: {travel} {time}: {off}: {motion:?}");
    }
    println!("worst closing: {worst} units");
}

#[test]
fn powers_of_two_scale_exactly() {
    let (l, t) = (2_f64.powi(-9), 2_f64.powi(14));
    for step in steps() {
        let shape = match step.shape {
            StepShape::Quarter { a3, t1 } => StepShape::Quarter { a3: a3 * l / t / t, t1: t1 * t },
            StepShape::Fractions { ki, ko, time: StepTime::Total(s) } => {
                StepShape::Fractions { ki, ko, time: StepTime::Total(s * t) }
            }
            StepShape::Fractions { ki, ko, time: StepTime::Middle(s) } => {
                StepShape::Fractions { ki, ko, time: StepTime::Middle(s * t) }
            }
            StepShape::Symmetric { frame: Frame::TIESkip(s), t_out } => {
                StepShape::Symmetric { frame: Frame::TIESkip(s * t), t_out: t_out * t }
            }
            StepShape::Symmetric { frame, t_out } => StepShape::Symmetric { frame, t_out: t_out * t },
        };
        let scaled = StepMove { travel: step.travel * l, shape, ..step };
        same(step.plan().expect("a plan").motion(), scaled.plan().expect("a plan").motion(), l, t);
    }
    for five in fives() {
        let given = match five.given {
            FiveSegmentBy::Accelerations { a0, a1, t1 } => {
                FiveSegmentBy::Accelerations { a0: a0 * l / t / t, a1: a1 * l / t / t, t1: t1 * t }
            }
            FiveSegmentBy::Times { t0, t1, t2 } => FiveSegmentBy::Times { t0: t0 * t, t1: t1 * t, t2: t2 * t },
        };
        let scaled = FiveSegment { delta_x: five.delta_x * l, given, ..five };
        same(five.plan().expect("a plan").motion(), scaled.plan().expect("a plan").motion(), l, t);
    }
}

fn same(one: &Motion, two: &Motion, l: f64, t: f64) {
    let [one, two] = [one, two].map(|motion| motion.axes()[0].profile.segments());
    for (a, b) in one.iter().zip(two) {
        assert_eq!(a.duration * t, b.duration);
        assert_eq!(a.end.position * l, b.end.position);
        assert_eq!(a.end.velocity * (l / t), b.end.velocity);
        assert_eq!(a.end.acceleration * (l / t / t), b.end.acceleration);
        assert_eq!(a.jerk * (l / t / t / t), b.jerk);
    }
}

#[test]
fn what_no_step_can_do_is_refused() {
    let refused = |shape, name: &str| {
        let error = StepMove::new(1e-3, shape).plan().expect_err(name).to_string();
        assert!(error.contains(name), "{error}");
    };
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0];
    let fractions = |ki, ko, time| StepShape::Fractions { ki, ko, time };
    let middle = StepTime::Middle(0.01);
    for x in bad {
        assert!(StepMove::new(x, fractions(0.5, 0.5, middle)).plan().is_err());
        refused(fractions(x, 0.5, middle), "ki");
        refused(fractions(0.5, x, middle), "ko");
        refused(fractions(0.5, 0.5, StepTime::Total(x)), "time");
        refused(fractions(0.5, 0.5, StepTime::Middle(x)), "time");
        refused(StepShape::Quarter { a3: -0.1, t1: x }, "t1");
        refused(StepShape::Quarter { a3: if x == -1.0 { 1.0 } else { x }, t1: 0.01 }, "a3");
        refused(StepShape::Symmetric { frame: Frame::Ki(x), t_out: 0.01 }, "ki");
        refused(StepShape::Symmetric { frame: Frame::Ki(0.5), t_out: x }, "t_out");
        refused(StepShape::Symmetric { frame: Frame::TIESkip(x), t_out: 0.01 }, "t_ie_skip");
        refused(StepShape::Symmetric { frame: Frame::TIESkip(0.02), t_out: x }, "t_out");
    }
    refused(fractions(0.2, 0.7, middle), "ko");
    refused(fractions(1.5, 0.6, middle), "ki");
    refused(StepShape::Symmetric { frame: Frame::Ki(0.33), t_out: 0.01 }, "ki");
    refused(StepShape::Symmetric { frame: Frame::Ki(1.0), t_out: 0.01 }, "ki");
    refused(StepShape::Symmetric { frame: Frame::TIESkip(0.01), t_out: 0.01 }, "t_ie_skip");
    // t1*sqrt(-a3/travel) < 0.33286
    refused(StepShape::Quarter { a3: -0.1, t1: 0.03329 }, "t1");
    assert!(StepMove::new(1e-3, StepShape::Quarter { a3: -0.1, t1: 0.033285 }).plan().is_ok());
    let overflow = StepMove::new(1e300, fractions(0.5, 0.5, StepTime::Total(1e-300))).plan();
    assert!(matches!(overflow, Err(PlanError::Range { .. })), "{overflow:?}");
}

#[test]
fn what_no_five_segments_can_do_is_refused() {
    let refused = |ki, given, name: &str| {
        let error = FiveSegment::new(1e-3, ki, given).plan().expect_err(name);
        assert!(error.to_string().contains(name), "{error}");
        error
    };
    let by = |a0, a1, t1| FiveSegmentBy::Accelerations { a0, a1, t1 };
    let times = |t0, t1, t2| FiveSegmentBy::Times { t0, t1, t2 };
    for x in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        assert!(FiveSegment::new(x, 0.1, times(0.01, 0.01, 0.01)).plan().is_err());
        refused(x, times(0.01, 0.01, 0.01), "ki");
        refused(0.1, times(x, 0.01, 0.01), "t0");
        refused(0.1, times(0.01, x, 0.01), "t1");
        refused(0.1, times(0.01, 0.01, x), "t2");
        refused(0.1, by(x, 1.0, 0.01), "a0");
        refused(0.1, by(2.0, 1.0, x), "t1");
    }
    refused(0.1, by(2.0, f64::NAN, 0.01), "a1");
    // at rest before the middle; backwards; too far
    refused(0.2, by(2.0, -60.0, 0.001), "a1");
    refused(0.01, by(2.0, -10.0, 0.01), "a1");
    refused(0.9, by(20.0, 1.0, 0.01), "delta_x");
    let error = refused(0.3, times(0.01, 0.01, 0.01), "ki");
    // 2*t0^2/((t0+t1)*(2*t0+2*t1+t2)) = 1/5
    assert!(matches!(error, PlanError::Limit { limit, .. } if (limit - 0.2).abs() <= 4.0 * EPS), "{error}");
}

#[test]
fn odd_numbers_give_a_sound_step_or_an_error() {
    let odd = [
        f64::NAN,
        -1.0,
        0.0,
        5e-324,
        1e-300,
        1e-160,
        1e-9,
        0.1,
        0.3,
        0.5,
        0.9,
        1.0,
        7.0,
        1e12,
        1e155,
        1e300,
        f64::INFINITY,
    ];
    let mut random = Random(11);
    let mut planned = 0;
    for n in 0..problems() {
        let mut one = || odd[(random.unit() * odd.len() as f64) as usize];
        let travel = one();
        let step = |shape| StepMove::new(travel, shape).plan().map(|plan| plan.motion().clone());
        let motion = match n % 6 {
            0 => step(StepShape::Quarter { a3: -one(), t1: one() }),
            1 => step(StepShape::Fractions { ki: one(), ko: one(), time: StepTime::Total(one()) }),
            2 => step(StepShape::Symmetric { frame: Frame::Ki(one()), t_out: one() }),
            3 => step(StepShape::Symmetric { frame: Frame::TIESkip(one()), t_out: one() }),
            4 => {
                let given = FiveSegmentBy::Accelerations { a0: one(), a1: one(), t1: one() };
                FiveSegment::new(travel, one(), given).plan().map(|plan| plan.motion().clone())
            }
            _ => {
                let given = FiveSegmentBy::Times { t0: one(), t1: one(), t2: one() };
                FiveSegment::new(travel, one(), given).plan().map(|plan| plan.motion().clone())
            }
        };
        let Ok(motion) = motion else { continue };
        planned += 1;
        let off = closing_in_reach(&motion.axes()[0].profile);
        assert!(off <= CLOSING, "{off}: {motion:?}");
    }
    println!("{planned} planned");
}
