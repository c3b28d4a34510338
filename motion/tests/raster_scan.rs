//! Raster scans: limits, lines at one velocity, ticks, triggers, and that nothing under the limits is faster.

mod support;

use closedform_motion::plan::derived_raster::{Choice, DerivedRaster};
use closedform_motion::plan::raster_scan::{Order, RasterPlan, RasterScan, Slower};
use closedform_motion::{Knot, Limits, Quantity};
use support::{EPS, Random, integrates_in_reach, problems};

const NONE: f64 = f64::INFINITY;

fn limits(acceleration: f64, jerk: f64) -> Limits {
    Limits { velocity: NONE, acceleration, jerk }
}

/// The raster of the README.
fn example() -> RasterScan {
    RasterScan::new(0.1, 0.005, 2e-4, 4, limits(50.0, NONE), limits(2.0, NONE))
}

/// Over decades of every unit and of the ratios of what is given.
fn random(random: &mut Random, ticks: bool) -> RasterScan {
    let (length, time) = (random.decades(-6.0, 6.0), random.decades(-6.0, 6.0));
    let velocity = length / time * random.decades(-1.0, 1.0);
    let axis = |random: &mut Random, least: f64| Limits {
        velocity: if random.unit() < 0.3 { NONE } else { least * random.decades(0.0, 1.0) },
        acceleration: length / time / time * random.decades(-1.0, 2.0),
        jerk: if random.unit() < 0.3 { NONE } else { length / time / time / time * random.decades(-1.0, 4.0) },
    };
    let fly = axis(random, velocity);
    let stepping = axis(random, length / time * 0.1);
    let sign = |random: &mut Random| if random.unit() < 0.5 { -1.0 } else { 1.0 };
    let step = if random.unit() < 0.1 { 0.0 } else { length * random.decades(-3.0, 0.0) * sign(random) };
    let line_length = length * sign(random);
    RasterScan {
        order: match (random.unit() * 4.0) as u32 {
            0 => Order::OneWay(None),
            1 => Order::OneWay(Some(velocity * random.decades(-0.5, 1.0))),
            _ => Order::Snake,
        },
        run_up: if random.unit() < 0.5 { 0.0 } else { time * random.decades(-3.0, 0.0) },
        settle: if random.unit() < 0.5 { 0.0 } else { time * random.decades(-3.0, 0.0) },
        tick: ticks.then(|| time * random.decades(-4.0, 0.0)),
        shortest: if random.unit() < 0.7 { 0.0 } else { time * random.decades(-4.0, 0.0) },
        start: [length * random.between(-1.0, 1.0), length * random.between(-1.0, 1.0)],
        ..RasterScan::new(velocity, line_length, step, 1 + (random.unit() * 5.0) as u64, fly, stepping)
    }
}

/// What must hold of every raster, by its motion.
fn is_sound(plan: &RasterPlan) {
    let scan = &plan.scan;
    let what = format!("{scan:?}");
    let motion = plan.motion(u64::MAX).unwrap_or_else(|error| panic!("{what}: {error}"));
    for axis in motion.axes() {
        let profile = &axis.profile;
        integrates_in_reach(profile, &what);
        assert_eq!(profile.smoothness().velocity.size, 0.0, "{what}");
        for (quantity, limit) in [
            (Quantity::Velocity, axis.limits.velocity),
            (Quantity::Acceleration, axis.limits.acceleration),
            (Quantity::Jerk, axis.limits.jerk),
        ] {
            let peak = profile.extremes(quantity).peak().value.abs();
            // durations are counted in ticks of a decimal, and differences of positions are of the whole reach
            assert!(peak <= limit * (1.0 + 1e-9), "{what}: {quantity:?} of {} is {peak}", axis.name);
        }
    }
    assert!((motion.duration() - plan.duration).abs() <= 1e-12 * plan.duration, "{what}");
    let [fly, step] = [&motion.axes()[0].profile, &motion.axes()[1].profile];
    assert_eq!((fly.start().velocity, fly.end().velocity, step.end().velocity), (0.0, 0.0, 0.0), "{what}");
    for line in 0..scan.lines {
        // inside of the line by a part of it that is far above rounding
        let (start, part) = (plan.line_start(line), 1e-6 * plan.line_time);
        for time in [start + part, start + 0.5 * plan.line_time, start + plan.line_time - part] {
            let (x, y) = (fly.at(time), step.at(time));
            assert!((x.velocity.abs() - scan.velocity).abs() <= 4.0 * EPS * scan.velocity, "{what}: line {line}");
            assert_eq!((y.velocity, y.acceleration), (0.0, 0.0), "{what}: line {line} at {time}");
            assert_eq!(y.position, scan.start[1] + line as f64 * scan.step, "{what}: line {line}");
            let back = scan.order == Order::Snake && line % 2 == 1;
            let along = scan.velocity * (time - start) * scan.line_length.signum();
            let from = scan.start[0] + if back { scan.line_length } else { 0.0 };
            let at = if back { from - along } else { from + along };
            let scale = scan.start[0].abs() + scan.line_length.abs() + scan.velocity * plan.duration;
            assert!((x.position - at).abs() <= 64.0 * EPS * scale, "{what}: line {line}: {} at {at}", x.position);
        }
        let settled = step.at(start - 0.999 * scan.settle);
        assert!(scan.settle == 0.0 || settled.velocity == 0.0, "{what}: line {line} settles");
        // inside of the run-up, by more than the rounding of its times
        let inside = if scan.run_up > 0.0 { 0.999 * scan.run_up } else { -part };
        let run_up = fly.at(start - inside);
        assert!(
            (run_up.velocity.abs() - scan.velocity).abs() <= 4.0 * EPS * scan.velocity,
            "{what}: line {line} run-up"
        );
    }
}

fn rows(plan: &RasterPlan) -> Vec<(Knot, f64)> {
    plan.rows().collect()
}

#[test]
fn random_rasters_over_twelve_decades_are_sound() {
    let mut source = Random(1701);
    for count in 0..problems() / 50 {
        let scan = random(&mut source, count % 2 == 1);
        let plan = scan.plan().unwrap_or_else(|error| panic!("{scan:?}: {error}"));
        is_sound(&plan);
        assert_eq!(rows(&plan).len() as u64, plan.row_count(), "{scan:?}");
    }
}

#[test]
fn rows_are_on_the_tick_and_no_closer_than_the_shortest_time() {
    let mut source = Random(1702);
    for _ in 0..problems() / 100 {
        let tick = 10_f64.powi(-(source.unit() * 6.0) as i32) * [1.0, 2.0, 2.5, 5.0][(source.unit() * 4.0) as usize];
        let tick: f64 = format!("{tick:.3e}").parse().expect("a number");
        let mut scan = random(&mut source, true);
        // in units of seconds, so that decimals are exact
        let unit = scan.tick.take().expect("a tick") / tick;
        let scaled = |limits: Limits| Limits {
            velocity: limits.velocity * unit,
            acceleration: limits.acceleration * unit * unit,
            jerk: limits.jerk * unit * unit * unit,
        };
        scan.velocity *= unit;
        (scan.fly, scan.stepping, scan.tick) = (scaled(scan.fly), scaled(scan.stepping), Some(tick));
        (scan.run_up, scan.settle, scan.shortest) = (scan.run_up / unit, scan.settle / unit, scan.shortest / unit);
        scan.order = Order::Snake;
        let plan = scan.plan().unwrap_or_else(|error| panic!("{scan:?}: {error}"));
        for (knot, duration) in rows(&plan) {
            for time in [knot.time, duration] {
                let count = (time / tick).round();
                let digits = format!("{tick:e}");
                let (mantissa, exponent) = digits.split_once('e').expect("an exponent");
                let places = mantissa.len().saturating_sub(2) as i32;
                let whole: u128 = mantissa.replace('.', "").parse().expect("digits");
                let exponent: i32 = exponent.parse::<i32>().expect("an exponent") - places;
                let nearest: f64 = format!("{}e{exponent}", whole * count as u128).parse().expect("a number");
                assert_eq!(time, nearest, "{scan:?}");
            }
            assert!(duration == 0.0 || duration >= scan.shortest * (1.0 - 1e-12), "{scan:?}: {duration}");
        }
    }
}

/// The least time of a turn-around from v to -v and of a step, by numbers that know nothing of the planner: a reversal
/// changes the velocity by 2v with an acceleration that rises, stays, and falls; a step is tried with all peaks.
fn least(scan: &RasterScan) -> (f64, f64) {
    let reversal = |limits: &Limits, dv: f64| {
        let fine = |share: u32| limits.acceleration * f64::from(share) / 2000.0;
        (1..=2000)
            .map(fine)
            .filter(|a| a * a / limits.jerk <= dv)
            .map(|a| dv / a + a / limits.jerk)
            .fold(NONE, f64::min)
    };
    let turn = reversal(&scan.fly, 2.0 * scan.velocity);
    let d = scan.step.abs();
    let Limits { velocity, acceleration, jerk } = scan.stepping;
    let top = velocity.min((d * acceleration).sqrt()).min((d * d * jerk).cbrt());
    let mut step = NONE;
    for v in (1..=500).map(|share| top * f64::from(share) / 500.0) {
        for a in (1..=60).map(|share| acceleration * f64::from(share) / 60.0).chain([(v * jerk).sqrt()]) {
            let ramp = v / a + a / jerk;
            let fits = a <= acceleration && a * a / jerk <= v * (1.0 + 1e-12) && d / v >= ramp;
            step = if fits { step.min(d / v + ramp) } else { step };
        }
    }
    (turn, if d == 0.0 { 0.0 } else { step })
}

#[test]
fn no_search_over_time_is_faster() {
    let mut source = Random(1703);
    for _ in 0..2000 {
        let scan = RasterScan { lines: 2, order: Order::Snake, shortest: 0.0, ..random(&mut source, false) };
        let plan = scan.plan().expect("a plan");
        let (turn, step) = least(&scan);
        let settle = if scan.step == 0.0 { 0.0 } else { scan.settle - 2.0 * scan.run_up };
        let found = turn.max(step + settle);
        assert!(plan.turn_time <= found * (1.0 + 1e-9), "{scan:?}: {} against {found}", plan.turn_time);
        assert!(plan.turn_time >= found * (1.0 - 2e-2), "{scan:?}: {} against {found}", plan.turn_time);
    }
}

/// The period, and the largest jerks of both axes, of a raster by a shape of the derivation.
fn derived(scan: &RasterScan, choice: Choice) -> Option<(f64, [f64; 2])> {
    let old = DerivedRaster::new(
        scan.velocity,
        scan.fly.acceleration,
        scan.step.abs(),
        scan.stepping.acceleration,
        scan.line_length.abs(),
        2,
    );
    let plan = DerivedRaster { choice, ..old }.plan().ok()?;
    let motion = plan.motion().ok()?;
    let jerk = |index: usize| motion.axes()[index].profile.extremes(Quantity::Jerk).peak().value.abs();
    Some((plan.period, [jerk(0), jerk(1)]))
}

/// With the jerks of another shape as its limits, the default is no slower; without limits of the jerk neither.
#[test]
fn no_shape_of_the_derivation_is_faster_with_jerks_no_larger() {
    let mut source = Random(1704);
    let mut judged = 0;
    for _ in 0..2000 {
        let mut scan = RasterScan {
            lines: 2,
            order: Order::Snake,
            run_up: 0.0,
            settle: 0.0,
            shortest: 0.0,
            ..random(&mut source, false)
        };
        (scan.fly.jerk, scan.stepping.jerk, scan.stepping.velocity) = (NONE, NONE, NONE);
        let u = scan.velocity * source.unit();
        let longest = scan.velocity / scan.fly.acceleration;
        let ramp = Choice::Ramp { v1_diff: u, t_in: 2.0 * u / scan.fly.acceleration * source.decades(0.0, 1.0) };
        for choice in
            [Choice::Fastest, Choice::V1Diff(u), Choice::V1Diff(0.0), Choice::TOut(longest * source.unit()), ramp]
        {
            let Some((period, jerks)) = derived(&scan, choice) else { continue };
            let free = scan.plan().expect("a plan").period;
            assert!(free <= period * (1.0 + 1e-12), "{scan:?} {choice:?}: {free} against {period}");
            let mut as_soft = scan;
            (as_soft.fly.jerk, as_soft.stepping.jerk) = (jerks[0] * (1.0 + 1e-9), jerks[1] * (1.0 + 1e-9));
            let soft = as_soft.plan().expect("a plan").period;
            assert!(soft <= period * (1.0 + 1e-8), "{scan:?} {choice:?}: {soft} against {period}");
            judged += 1;
        }
    }
    assert!(judged > 4000, "{judged}");
}

#[test]
fn the_raster_of_the_readme_takes_what_its_accelerations_allow() {
    let plan = example().plan().expect("a plan");
    assert!((plan.turn_time - 0.02).abs() < 1e-15 && (plan.period - 0.07).abs() < 1e-15);
    assert_eq!(plan.slower, Some(Slower::Step));
    assert!((plan.overhead - 0.02).abs() < 1e-15 && (plan.overhead_share() - 2.0 / 7.0).abs() < 1e-14);
    is_sound(&plan);
}

#[test]
fn ticks_keep_the_velocity() {
    let plan = RasterScan { tick: Some(0.03), ..example() }.plan().expect("a plan");
    assert_eq!((plan.velocity(), plan.steady_time, plan.period), (0.1, 0.06, 0.12));
    is_sound(&plan);
    let plan = RasterScan { tick: Some(0.00025), lines: 1000, ..example() }.plan().expect("a plan");
    assert_eq!(plan.steady_time, 0.05);
    let mut durations: Vec<f64> = rows(&plan).into_iter().map(|(_, duration)| duration).collect();
    durations.sort_by(f64::total_cmp);
    durations.dedup();
    assert!(durations.len() < 10, "{durations:?}");
}

#[test]
fn one_line_has_no_turn_around() {
    let plan = RasterScan { lines: 1, ..example() }.plan().expect("a plan");
    assert_eq!(plan.slower, None);
    let step = &plan.motion(1).expect("a motion").axes()[1].profile.clone();
    assert_eq!(step.extremes(Quantity::Velocity).peak().value, 0.0);
    assert!((plan.duration - (0.05 + 2.0 * 0.002)).abs() < 1e-15);
}

#[test]
fn triggers_are_where_pixels_begin() {
    let scan = RasterScan { lines: 3, run_up: 1e-3, tick: Some(1e-3), start: [1.0, 2.0], ..example() };
    let plan = scan.plan().expect("a plan");
    let motion = plan.motion(3).expect("a motion");
    let triggers: Vec<_> = plan.triggers(10).collect();
    assert_eq!(triggers.len(), 30);
    for trigger in triggers {
        let [fly, step] = [0, 1].map(|axis: usize| motion.axes()[axis].profile.at(trigger.time));
        assert!((fly.position - trigger.position[0]).abs() < 1e-15 * 8.0, "{trigger:?}");
        assert_eq!((step.position, step.velocity), (trigger.position[1], 0.0), "{trigger:?}");
        assert!((fly.velocity.abs() - 0.1).abs() < 1e-16 * 4.0);
    }
}

#[test]
fn a_million_lines_stream() {
    let plan = RasterScan { lines: 1_000_000, ..example() }.plan().expect("a plan");
    let mut before = -1.0;
    let mut count = 0;
    for (knot, _) in plan.rows() {
        assert!(knot.time > before);
        (before, count) = (knot.time, count + 1);
    }
    assert_eq!((before, count), (plan.duration, plan.row_count()));
}

#[test]
fn what_no_plan_can_do_is_refused() {
    let refused = |scan: RasterScan| scan.plan().expect_err("refused").to_string();
    for bad in [0.0, -1.0, f64::NAN, NONE] {
        assert!(refused(RasterScan { velocity: bad, ..example() }).contains("velocity"));
        assert!(refused(RasterScan { tick: Some(bad), ..example() }).contains("tick"));
    }
    assert!(refused(RasterScan { line_length: 0.0, ..example() }).contains("line_length"));
    assert!(refused(RasterScan { step: f64::NAN, ..example() }).contains("step"));
    assert!(refused(RasterScan { settle: -1.0, ..example() }).contains("settle"));
    assert!(refused(RasterScan { lines: 0, ..example() }).contains("lines"));
    assert!(refused(RasterScan { fly: Limits { velocity: 0.05, ..limits(50.0, NONE) }, ..example() }).contains("fly"));
    assert!(refused(RasterScan { stepping: limits(NONE, NONE), ..example() }).contains("limit the acceleration"));
    assert!(refused(RasterScan { tick: Some(1e-20), ..example() }).contains("2^53"));
}
