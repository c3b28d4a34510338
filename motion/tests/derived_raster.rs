//! Raster scans: exact integration, limits, brute force, scaling, ticks, random problems and bad input.

mod support;

use closedform_motion::PlanError;
use closedform_motion::Quantity;
use closedform_motion::plan::derived_raster::{Choice, DerivedRaster, DerivedRasterPlan, Limiting, Ramps, Raster};
use support::{CLOSING, EPS, Random, closing, closing_in_reach, integrates, keeps_limits, problems};

/// The example of the audit: v1_scan = 0.1, a1_max = 50, delta = 1e-4.
fn example() -> DerivedRaster {
    DerivedRaster::new(0.1, 50.0, 2e-4, 2.0, 0.01, 5)
}

fn rasters() -> [Raster; 4] {
    let back = |v1_return| Raster::OneWay { v1_return };
    [Raster::Snake, back(None), back(Some(0.25)), back(Some(0.04))]
}

fn check(plan: &DerivedRasterPlan, what: &str) {
    let motion = plan.motion().expect(what);
    for axis in motion.axes() {
        integrates(&axis.profile, &format!("{what}: {}", axis.name));
        assert_eq!(axis.profile.smoothness().velocity.size, 0.0, "{what}");
    }
    keeps_limits(&motion, 3000, what);
    let [fly, step] = [&motion.axes()[0].profile, &motion.axes()[1].profile];
    assert_eq!((fly.start().velocity, fly.end().velocity), (0.0, 0.0), "{what}");
    assert_eq!(step.end().position, (plan.scan.lines - 1) as f64 * plan.scan.d2_step, "{what}");
    // one rounding for each of the sums that lead to them
    assert!((motion.duration() - plan.duration).abs() <= 16.0 * EPS * plan.duration, "{what}");
}

#[test]
fn the_audits_example_is_found() {
    let plan = example().plan().expect("a plan");
    // mpmath, 30 digits, by the equations of motion; the audit looked at multiples of 1 mm/s, and gives 18
    assert!((plan.turn.leaving.t_in - 0.012_709_37).abs() < 5e-9, "{}", plan.turn.leaving.t_in);
    assert!((plan.overhead - 3.868_405_243_693e-3).abs() < 5e-16, "{}", plan.overhead);
    assert!((plan.turn.leaving.v1_diff - 0.018).abs() < 1e-3, "{}", plan.turn.leaving.v1_diff);
    let audit = DerivedRaster { choice: Choice::V1Diff(0.018), ..example() }.plan().expect("a plan");
    assert!((audit.turn.leaving.t_in - 0.012_73).abs() < 5e-6, "{}", audit.turn.leaving.t_in);
    assert!((audit.overhead - 3.868e-3).abs() < 5e-7 && plan.overhead < audit.overhead);
    assert_eq!(plan.limiting, Limiting::Both);
    assert_eq!(plan.turn.t_edge, 0.0);
}

#[test]
fn every_kind_of_raster_integrates_and_keeps_its_limits() {
    let choices = [
        Choice::Fastest,
        Choice::V1Diff(0.0),
        Choice::V1Diff(0.01),
        Choice::V1Diff(0.07),
        Choice::V1Diff(0.099),
        Choice::TOut(0.003),
        Choice::TOut(0.004),
        Choice::TOut(0.0005),
        Choice::Ramp { v1_diff: 0.01, t_in: 0.001 },
        Choice::Ramp { v1_diff: 0.01, t_in: 0.02 },
        Choice::Ramp { v1_diff: 0.05, t_in: 0.002 },
    ];
    for ramps in [Ramps::Outside, Ramps::Inside] {
        for raster in rasters() {
            for choice in choices {
                for tick in [None, Some(1e-3), Some(2e-4), Some(1e-7)] {
                    let scan = DerivedRaster { ramps, raster, choice, tick, line_length: 0.02, ..example() };
                    let what = format!("{scan:?}");
                    check(&scan.plan().expect(&what), &what);
                }
            }
        }
    }
}

#[test]
fn knots_are_the_boundaries_of_the_motion() {
    for raster in rasters() {
        for tick in [None, Some(1e-4)] {
            let plan = DerivedRaster { raster, tick, ..example() }.plan().expect("a plan");
            let motion = plan.motion().expect("a motion");
            let knots: Vec<_> = plan.knots().collect();
            assert_eq!(knots.len() as u64, plan.knot_count());
            let segments = motion.axes()[0].profile.segments();
            assert_eq!(knots.len(), segments.len() + 1);
            for (n, axis) in motion.axes().iter().enumerate() {
                for (knot, segment) in knots.iter().zip(axis.profile.segments()) {
                    assert_eq!(knot.states[n], segment.start);
                }
                assert_eq!(knots[knots.len() - 1].states[n], axis.profile.end());
                for (knot, time) in knots.iter().zip(axis.profile.times()) {
                    assert!((knot.time - time).abs() <= 16.0 * EPS * plan.duration, "{} {time}", knot.time);
                }
            }
        }
    }
}

#[test]
fn a_raster_of_a_million_lines_streams() {
    let plan = DerivedRaster { lines: 1_000_000, tick: Some(1e-4), ..example() }.plan().expect("a plan");
    let (mut count, mut before) = (0, -1.0);
    for knot in plan.knots() {
        assert!(knot.time > before, "{} after {before}", knot.time);
        let nearest: f64 = format!("{}e-4", (knot.time / 1e-4).round()).parse().expect("a number");
        assert_eq!(knot.time, nearest);
        (count, before) = (count + 1, knot.time);
    }
    assert_eq!(count, plan.knot_count());
}

/// Overhead by the equations of motion: fly axis to rest with a1_max, step axis by bisection.
fn overhead(scan: &DerivedRaster, v1_diff: f64, t_in: f64) -> f64 {
    let (v, a) = (scan.v1_scan, scan.a1_max);
    let t_out = 2.0 * (v - v1_diff) / (2.0 * v1_diff / t_in + a);
    // the step axis: a2_max*(t_in+x)*(t_in+2*x)/3 = d2_step with the ramp out x
    let delta = scan.d2_step / scan.a2_max;
    let (mut low, mut high) = (0.0, (3.0 * delta).sqrt());
    for _ in 0..80 {
        let x = (low + high) / 2.0;
        if (t_in + x) * (t_in + 2.0 * x) < 3.0 * delta { low = x } else { high = x }
    }
    t_out + (high - t_out).max(0.0) + t_in * v1_diff / (3.0 * v)
}

/// The least overhead over `t_in`: on a grid, and by thirds around its best point.
fn brute_t_in(scan: &DerivedRaster, u: f64) -> f64 {
    let (v, a) = (scan.v1_scan, scan.a1_max);
    let shortest = 2.0 * u * v / a;
    let longest = shortest + (3.0 * scan.d2_step / scan.a2_max).sqrt() + v / a;
    let cost = |t: f64| if t > 0.0 { overhead(scan, u * v, t) } else { f64::INFINITY };
    let grid = |n: u32| shortest + (longest - shortest) * f64::from(n) / 30.0;
    let best = (0..=30).min_by(|a, b| cost(grid(*a)).total_cmp(&cost(grid(*b)))).unwrap_or(0);
    let (mut low, mut high) = (grid(best.saturating_sub(1)), grid(best + 1));
    for _ in 0..90 {
        let (one, two) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if cost(one) < cost(two) { high = two } else { low = one }
    }
    cost(grid(best)).min(cost(high)).min(cost(shortest))
}

/// The least overhead over both: a grid, then finer and finer ones around its best point.
fn brute(scan: &DerivedRaster) -> f64 {
    let (mut best, mut at, mut width) = (f64::INFINITY, 0.5, 0.5);
    for _ in 0..12 {
        let centre = at;
        for n in -20..=20 {
            let u = centre + width * f64::from(n) / 20.0;
            if (0.0..1.0).contains(&u) && brute_t_in(scan, u) < best {
                (best, at) = (brute_t_in(scan, u), u);
            }
        }
        width *= 0.2;
    }
    best
}

#[test]
fn brute_force_does_not_beat_the_fastest() {
    // q = 3*a1_max^2*delta/v1_scan^2 decides: both sides of all edges between its regions, and far away
    let mut random = Random(1);
    let edges = [3.5, 3.74, 8.0, 110.99];
    let beside = edges.iter().flat_map(|q| [q * 0.97, q * 1.03]);
    let anywhere: Vec<f64> = (0..20).map(|_| random.decades(-1.0, 3.0)).collect();
    for q in beside.chain([1e-6, 3.6, 4.0, 75.0, 1e6]).chain(anywhere) {
        let (v, a, a2) = (random.decades(-3.0, 1.0), random.decades(0.0, 3.0), random.decades(-1.0, 2.0));
        let scan = DerivedRaster::new(v, a, q * v * v / (3.0 * a * a) * a2, a2, 1.0, 2);
        let plan = scan.plan().expect("a plan");
        let best = brute(&scan);
        // both evaluate the overhead to less than 20 ulp
        assert!(plan.overhead <= best * (1.0 + 40.0 * EPS), "q = {q}: {} > {best}", plan.overhead);
        // and the search, whose grid ends 10^-9 wide, comes as close, or closer where the slope is 0
        assert!(best <= plan.overhead * (1.0 + 1e-8), "q = {q}: {} << {best}", plan.overhead);
        let own = overhead(&scan, plan.turn.leaving.v1_diff, plan.turn.leaving.t_in);
        assert!((own - plan.overhead).abs() <= 40.0 * EPS * own, "q = {q}: {own} {}", plan.overhead);
    }
}

#[test]
fn brute_force_does_not_beat_what_is_given() {
    let scan = example();
    for u in [0.01, 0.2, 0.5, 0.8, 0.99] {
        let v1_diff = u * scan.v1_scan;
        let plan = DerivedRaster { choice: Choice::V1Diff(v1_diff), ..scan }.plan().expect("a plan");
        assert_eq!(plan.turn.leaving.v1_diff, v1_diff);
        let shortest = 2.0 * v1_diff / scan.a1_max;
        for n in 0..20_000 {
            let t_in = shortest + f64::from(n) * 1e-6;
            if t_in > 0.0 {
                assert!(plan.overhead <= overhead(&scan, v1_diff, t_in) * (1.0 + 40.0 * EPS), "{u} {t_in}");
            }
        }
    }
    for t_out in [1e-4, 1e-3, 1.9e-3, 2.5e-3, 3.9e-3] {
        let plan = DerivedRaster { choice: Choice::TOut(t_out), ..scan }.plan().expect("a plan");
        assert_eq!(plan.turn.leaving.t_out, t_out);
        for n in 1..20_000 {
            let t_in = f64::from(n) * 1e-6;
            let v1_diff = t_in * (2.0 * scan.v1_scan - scan.a1_max * t_out) / (2.0 * (t_in + t_out));
            if 2.0 * v1_diff <= scan.a1_max * t_in {
                assert!(plan.overhead <= overhead(&scan, v1_diff, t_in) * (1.0 + 40.0 * EPS), "{t_out} {t_in}");
            }
        }
    }
}

/// The same scan with lengths times 2^length and times times 2^time.
fn scaled(scan: &DerivedRaster, length: i32, time: i32) -> DerivedRaster {
    let by = |x: f64, length: i32, time: i32| x * 2_f64.powi(length) * 2_f64.powi(time);
    let velocity = |v| by(v, length, -time);
    DerivedRaster {
        v1_scan: velocity(scan.v1_scan),
        a1_max: by(scan.a1_max, length, -2 * time),
        d2_step: by(scan.d2_step, length, 0),
        a2_max: by(scan.a2_max, length, -2 * time),
        line_length: by(scan.line_length, length, 0),
        raster: match scan.raster {
            Raster::OneWay { v1_return } => Raster::OneWay { v1_return: v1_return.map(velocity) },
            snake => snake,
        },
        choice: match scan.choice {
            Choice::Fastest => Choice::Fastest,
            Choice::V1Diff(v) => Choice::V1Diff(velocity(v)),
            Choice::TOut(t) => Choice::TOut(by(t, 0, time)),
            Choice::Ramp { v1_diff, t_in } => Choice::Ramp { v1_diff: velocity(v1_diff), t_in: by(t_in, 0, time) },
        },
        tick: scan.tick.map(|tick| by(tick, 0, time)),
        ..*scan
    }
}

#[test]
fn powers_of_two_scale_exactly() {
    let choices =
        [Choice::Fastest, Choice::V1Diff(0.03), Choice::TOut(0.001), Choice::Ramp { v1_diff: 0.01, t_in: 0.001 }];
    let steps = [1e-7, 9e-6, 2e-4, 1e-2];
    for (length, time) in [(1, 0), (0, 1), (-20, 7), (33, -15), (-300, 150), (310, -140)] {
        for choice in choices {
            for raster in rasters() {
                for (tick, d2_step) in [None, Some(2_f64.powi(-12))].into_iter().flat_map(|t| steps.map(|d| (t, d))) {
                    let scan = DerivedRaster { choice, raster, tick, d2_step, ..example() };
                    let (Ok(one), Ok(two)) = (scan.plan(), scaled(&scan, length, time).plan()) else {
                        assert!(scan.plan().is_err() && scaled(&scan, length, time).plan().is_err());
                        continue;
                    };
                    let (l, t) = (2_f64.powi(length), 2_f64.powi(time));
                    assert_eq!(one.overhead * t, two.overhead);
                    assert_eq!(one.overhead_share, two.overhead_share);
                    assert_eq!(one.tick_cost * t, two.tick_cost);
                    for (a, b) in one.knots().zip(two.knots()) {
                        assert_eq!(a.time * t, b.time);
                        for (a, b) in a.states.iter().zip(&b.states) {
                            assert_eq!(a.position * l, b.position);
                            assert_eq!(a.velocity * (l / t), b.velocity);
                            assert_eq!(a.acceleration * (l / t / t), b.acceleration);
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn ticks_cost_time_and_pass_no_limit() {
    let mut random = Random(2);
    for _ in 0..2000 {
        let raster = rasters()[(random.unit() * 4.0) as usize];
        let ramps = if random.unit() < 0.5 { Ramps::Inside } else { Ramps::Outside };
        let tick = random.decades(-6.0, -1.5);
        let d2_step = random.decades(-7.0, -2.0);
        let scan = DerivedRaster { raster, ramps, d2_step, line_length: 0.1, ..example() };
        let (Ok(free), Ok(plan)) = (scan.plan(), DerivedRaster { tick: Some(tick), ..scan }.plan()) else {
            assert!(scan.plan().is_err(), "{scan:?} {tick}");
            continue;
        };
        let what = format!("{scan:?} {tick}");
        let whole = |time: f64| assert_eq!((time / tick).round() * tick, time, "{what}");
        let back = plan.back.map(|back| back.turn);
        for turn in [Some(plan.turn), back].into_iter().flatten() {
            for half in [turn.leaving, turn.entering] {
                [half.t_in, half.t_out].into_iter().for_each(whole);
                assert!(half.a1_in <= scan.a1_max && half.a1_peak <= scan.a1_max, "{what}");
            }
            whole(turn.t_edge);
            assert!(turn.a2_leaving <= scan.a2_max && turn.a2_entering <= scan.a2_max, "{what}");
        }
        whole(plan.line_time);
        // the multiple of the tick as a decimal, which may be the neighbour of the product
        let near = |time: f64| assert!(((time / tick).round() * tick - time).abs() <= EPS * time, "{what}: {time}");
        plan.knots().for_each(|knot| near(knot.time));
        assert!(plan.v1_scan <= scan.v1_scan, "{what}");
        let cost = plan.duration - free.duration;
        if ramps == Ramps::Outside && matches!(raster, Raster::Snake | Raster::OneWay { v1_return: None }) {
            assert!(cost >= -16.0 * EPS * plan.duration, "{what}: {cost}");
        }
        assert_eq!(cost, plan.tick_cost);
        let motion = plan.motion().expect("a motion");
        for axis in motion.axes() {
            let off = closing(&axis.profile);
            assert!(off <= CLOSING, "{what}: {}: {off}", axis.name);
        }
        keeps_limits(&motion, 300, &what);
    }
}

#[test]
fn random_problems_over_twelve_decades_plan() {
    let mut random = Random(3);
    let (mut worst, mut planned) = (0.0_f64, 0);
    for n in 0..problems() {
        let mut wide = || random.decades(-6.0, 6.0);
        let mut scan = DerivedRaster::new(wide(), wide(), wide(), wide(), wide(), 3);
        // what may be refused, and for which input
        let mut allowed = "";
        match n % 7 {
            0 => {}
            1 => scan.choice = Choice::V1Diff(scan.v1_scan * (1.0 - random.unit()).min(1.0 - EPS)),
            2 => scan.raster = Raster::OneWay { v1_return: None },
            3 => {
                let v1_diff = scan.v1_scan * random.unit();
                let t_in = 2.0 * v1_diff / scan.a1_max * random.decades(0.01, 4.0);
                scan.choice = Choice::Ramp { v1_diff, t_in: t_in.max(1e-9 * scan.v1_scan / scan.a1_max) };
            }
            4 => {
                let t_out = scan.v1_scan / scan.a1_max * random.decades(-6.0, 0.3);
                scan.choice = Choice::TOut(t_out);
                // the ramps out alone make the step
                if t_out * t_out * scan.a2_max * 2.0 >= 3.0 * scan.d2_step {
                    allowed = "d2_step"
                }
            }
            5 => {
                scan.raster = Raster::OneWay { v1_return: Some(scan.v1_scan * random.decades(-3.0, 3.0)) };
                allowed = "line_length";
            }
            _ => {
                scan.ramps = Ramps::Inside;
                allowed = "line_length";
            }
        }
        let what = format!("problem {n}: {scan:?}");
        let plan = match scan.plan() {
            Ok(plan) => plan,
            Err(PlanError::Limit { name, limit, needed, .. }) if name == allowed && needed >= limit => continue,
            Err(error) => panic!("{what}: {error}"),
        };
        planned += 1;
        let half = plan.turn.leaving;
        assert!(half.a1_in <= scan.a1_max && half.a1_peak <= scan.a1_max, "{what}");
        assert!(plan.turn.a2_leaving <= scan.a2_max && plan.turn.t_edge >= 0.0, "{what}");
        assert!(half.t_in > 0.0 && half.t_out > 0.0 && half.v1_diff >= 0.0, "{what}");
        for axis in plan.turn_motion().expect("a motion").axes() {
            worst = worst.max(closing(&axis.profile));
            assert!(closing(&axis.profile) <= CLOSING, "{what}: {}: {}", axis.name, closing(&axis.profile));
        }
    }
    println!("{planned} planned; worst closing: {worst} units");
    assert!(planned >= problems() * 3 / 4, "{planned}");
}

#[test]
fn what_no_plan_can_do_is_refused() {
    let refused = |scan: DerivedRaster, name: &str| {
        let error = scan.plan().expect_err(&format!("{scan:?}"));
        let text = error.to_string();
        assert!(text.contains(name), "{text}");
        error
    };
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, -1.0];
    for x in bad {
        refused(DerivedRaster { v1_scan: x, ..example() }, "v1_scan");
        refused(DerivedRaster { a1_max: x, ..example() }, "a1_max");
        refused(DerivedRaster { d2_step: x, ..example() }, "d2_step");
        refused(DerivedRaster { a2_max: x, ..example() }, "a2_max");
        refused(DerivedRaster { line_length: x, ..example() }, "line_length");
        refused(DerivedRaster { tick: Some(x), ..example() }, "tick");
        refused(DerivedRaster { raster: Raster::OneWay { v1_return: Some(x) }, ..example() }, "v1_return");
        refused(DerivedRaster { choice: Choice::TOut(x), ..example() }, "t_out");
        refused(DerivedRaster { choice: Choice::Ramp { v1_diff: 0.01, t_in: x }, ..example() }, "t_in");
        if x != 0.0 {
            refused(DerivedRaster { choice: Choice::V1Diff(x), ..example() }, "v1_diff");
            refused(DerivedRaster { choice: Choice::Ramp { v1_diff: x, t_in: 0.01 }, ..example() }, "v1_diff");
        }
    }
    refused(DerivedRaster { lines: 0, ..example() }, "lines");
    refused(DerivedRaster { tick: Some(1e-300), ..example() }, "tick");
    let error = refused(DerivedRaster { choice: Choice::V1Diff(0.1), ..example() }, "v1_diff");
    assert!(matches!(error, PlanError::Limit { limit: 0.1, needed: 0.1, .. }), "{error}");
    // the fly axis is at rest after 4 ms at the latest
    let error = refused(DerivedRaster { choice: Choice::TOut(0.0041), ..example() }, "t_out");
    assert!(matches!(error, PlanError::Limit { limit: 0.004, needed: 0.0041, .. }), "{error}");
    let ramp = Choice::Ramp { v1_diff: 0.05, t_in: 0.001 };
    let error = refused(DerivedRaster { choice: ramp, ..example() }, "a1_max");
    assert!(matches!(error, PlanError::Limit { limit: 50.0, needed: 100.0, .. }), "{error}");
    // a step of the ramps out alone
    refused(DerivedRaster { choice: Choice::V1Diff(0.0), d2_step: 1e-5, ..example() }, "d2_step");
    refused(DerivedRaster { choice: Choice::TOut(0.004), d2_step: 1e-5, ..example() }, "d2_step");
    // 2*d1_in = 2.4 mm
    let error = refused(DerivedRaster { ramps: Ramps::Inside, line_length: 0.002, ..example() }, "line_length");
    assert!(matches!(error, PlanError::Limit { needed, .. } if (needed - 0.0024).abs() < 1e-4), "{error}");
    refused(DerivedRaster { raster: Raster::OneWay { v1_return: Some(10.0) }, ..example() }, "line_length");
    for scan in [
        DerivedRaster { a1_max: 1e-320, ..example() },
        DerivedRaster { d2_step: 1e-320, a2_max: 1e300, ..example() },
        DerivedRaster { v1_scan: 1e300, a1_max: 1e-300, ..example() },
        DerivedRaster { d2_step: 1e300, lines: 1 << 53, ..example() },
    ] {
        refused(scan, "beyond the range");
    }
}

#[test]
fn peaks_are_the_limits() {
    let plan = example().plan().expect("a plan");
    let motion = plan.turn_motion().expect("a motion");
    let peaks = motion.peaks();
    assert_eq!(peaks[0].velocity.share(), 1.0);
    assert_eq!(peaks[0].acceleration.share(), 1.0);
    // the step axis meets its limit but for the rounding of the times
    assert!((1.0 - 20.0 * EPS..=1.0).contains(&peaks[1].acceleration.share()), "{:?}", peaks[1]);
    let fly = motion.axes()[0].profile.extremes(Quantity::Position);
    let half = plan.turn.leaving;
    assert_eq!(fly.largest.value, 0.01 + (half.d1_in + half.d1_out));
    assert_eq!(motion.axes()[1].profile.extremes(Quantity::Velocity).largest.value, plan.turn.v2);
}

#[test]
fn odd_numbers_give_a_sound_plan_or_an_error() {
    let odd = [
        f64::NAN,
        f64::INFINITY,
        -1.0,
        0.0,
        5e-324,
        1e-300,
        1e-160,
        1e-80,
        1e-9,
        0.3,
        1.0,
        7.0,
        1e12,
        1e90,
        1e155,
        1e300,
        f64::MAX,
    ];
    let mut random = Random(7);
    let mut planned = 0;
    for _ in 0..problems() {
        let mut one = |from: usize| odd[from + (random.unit() * (odd.len() - from) as f64) as usize];
        let mut scan = DerivedRaster::new(one(3), one(3), one(3), one(3), one(3), 3);
        scan.choice = match one(0).to_bits() % 5 {
            0 => Choice::V1Diff(one(0)),
            1 => Choice::TOut(one(0)),
            2 => Choice::Ramp { v1_diff: one(0), t_in: one(0) },
            _ => Choice::Fastest,
        };
        if one(0) < 1.0 {
            scan.raster = Raster::OneWay { v1_return: Some(one(3)) };
        }
        if one(0) < 1.0 {
            scan.tick = Some(one(3));
        }
        let Ok(plan) = scan.plan() else { continue };
        planned += 1;
        let mut before = 0.0;
        for knot in plan.knots() {
            assert!(knot.time.is_finite() && knot.time >= before, "{scan:?}: {knot:?} after {before}");
            before = knot.time;
            for (state, limit) in knot.states.iter().zip([scan.a1_max, scan.a2_max]) {
                assert!(state.position.is_finite() && state.velocity.is_finite(), "{scan:?}: {knot:?}");
                assert!(state.acceleration.abs() <= limit, "{scan:?}: {knot:?}");
            }
        }
        let motion = plan.motion().unwrap_or_else(|error| panic!("{scan:?}: {error}"));
        for axis in motion.axes() {
            let off = closing_in_reach(&axis.profile);
            assert!(off <= CLOSING, "{scan:?}: {}: {off}", axis.name);
        }
    }
    println!("{planned} planned");
}
