//! Milling times against brute force: every axis, every step, by bisection; and their continuous limit.

use closedform_motion::PlanError;
use closedform_motion::plan::milling::{Arc, Feed, Job, Machine, Milling, Model, Move, Path, Row, Timer};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use rug::Float;

const EPSILON: f64 = f64::EPSILON;
const FREE: [f64; 3] = [f64::INFINITY; 3];

fn machine(acceleration: [f64; 3]) -> Machine {
    Machine { acceleration, speed: FREE, rapid: f64::INFINITY, feed: f64::INFINITY, ..Machine::default() }
}

fn steps(machine: Machine, length: f64) -> Milling {
    Milling::new(machine, Model::Steps { length }).unwrap()
}

fn continuous(machine: Machine) -> Milling {
    Milling::new(machine, Model::ExactStop).unwrap()
}

fn cut(milling: &Milling, way: [f64; 3], feed: f64) -> Row {
    let job = milling.polyline(&[[0.0; 3], way], Feed::Speed(feed)).unwrap();
    assert_eq!((job.rows.len(), job.time), (1, job.rows[0].time));
    job.rows[0]
}

/// The printed derivation's loop, without its formula: in each step, for each axis, the largest speed by bisection.
struct Brute {
    direction: [f64; 3],
    step: f64,
    steps: u32,
}

impl Brute {
    fn new(way: [f64; 3], step: f64) -> Self {
        let length = way.iter().map(|way| way * way).sum::<f64>().sqrt();
        let steps = (1..).find(|steps| length / 2.0 / f64::from(*steps) <= step).unwrap();
        Self { direction: way.map(|way| way / length), step: length / f64::from(2 * steps), steps }
    }

    /// Acceleration of an axis in a step of the speed `now` after one of the speed `before`.
    fn acceleration(&self, axis: usize, before: f64, now: f64) -> f64 {
        self.direction[axis] * (now - before) * now / self.step
    }

    /// Speeds of the first half.
    fn speeds(&self, limits: [f64; 3], feed: f64) -> Vec<f64> {
        let mut speeds = vec![0.0];
        for _ in 0..self.steps {
            let before = speeds[speeds.len() - 1];
            let keeps = |speed: f64| (0..3).all(|axis| self.acceleration(axis, before, speed).abs() <= limits[axis]);
            let (mut low, mut high) = (before, 1e9_f64.max(2.0 * before));
            while low < (low + high) / 2.0 && (low + high) / 2.0 < high {
                let middle = (low + high) / 2.0;
                if keeps(middle) { low = middle } else { high = middle }
            }
            speeds.push(low.min(feed));
        }
        speeds.split_off(1)
    }

    fn time(&self, limits: [f64; 3], feed: f64) -> f64 {
        2.0 * self.speeds(limits, feed).into_iter().map(|speed| self.step / speed).sum::<f64>()
    }
}

/// Ways that differ in what limits: one axis, two, three, a mirrored one, a skew one, an odd length, a short one.
const WAYS: [[f64; 3]; 8] = [
    [100.0, 0.0, 0.0],
    [0.0, -37.0, 0.0],
    [60.0, 80.0, 0.0],
    [-30.0, 20.0, -10.0],
    [1e-3, 50.0, 0.0],
    [12.345, -6.789, 0.1],
    [0.3, 0.1, 0.0],
    [1e-6, 1e-6, 1e-6],
];
const LIMITS: [f64; 3] = [500.0, 1200.0, 200.0];

#[test]
fn steps_are_the_seeds_loop() {
    for way in WAYS {
        for step in [1.0, 0.3, 2.5, 1000.0] {
            for feed in [f64::INFINITY, 40.0, 3.0, 0.01] {
                let brute = Brute::new(way, step);
                let (expected, found) = (brute.time(LIMITS, feed), cut(&steps(machine(LIMITS), step), way, feed));
                // Each step of the loop rounds some four times, and no error grows from step to step.
                let allowed = (8.0 + 4.0 * f64::from(brute.steps)) * EPSILON * expected;
                assert!((found.time - expected).abs() <= allowed, "{way:?} {step} {feed}: {} {expected}", found.time);
                let peak = brute.speeds(LIMITS, feed).pop().unwrap();
                assert!(
                    (found.peak - peak).abs() <= allowed / expected * peak,
                    "{way:?} {step} {feed}: {}",
                    found.peak
                );
            }
        }
    }
}

#[test]
fn no_axis_exceeds_its_acceleration_in_any_step() {
    // A cut of k steps a half ends its first half with the speed of step k of every longer cut.
    for way in WAYS {
        let brute = Brute::new(way, f64::INFINITY);
        let unit = brute.direction.map(|n| 2.0 * n);
        let milling = steps(machine(LIMITS), 1.0 + 1e-9);
        let mut before = 0.0;
        for k in 1..300 {
            let now = cut(&milling, unit.map(|n| n * f64::from(k)), f64::INFINITY).peak;
            for (axis, limit) in LIMITS.into_iter().enumerate() {
                let found = brute.direction[axis].abs() * (now - before) * now;
                // The difference of two speeds, each good to some ulp.
                let allowed = limit + 8.0 * EPSILON * now * now;
                assert!(found <= allowed, "{way:?} step {k} axis {axis}: {found}");
            }
            before = now;
        }
    }
}

#[test]
fn short_steps_tend_to_constant_acceleration_from_below() {
    for way in WAYS {
        for feed in [f64::INFINITY, 40.0, 3.0] {
            let limit = cut(&continuous(machine(LIMITS)), way, feed).time;
            let length = way.iter().map(|way| way * way).sum::<f64>().sqrt();
            let mut missing = Vec::new();
            for count in [1.0, 10.0, 100.0, 1e3, 1e4, 1e5] {
                let time = cut(&steps(machine(LIMITS), length / 2.0 / count), way, feed).time;
                assert!(time <= limit * (1.0 + 8.0 * EPSILON), "{way:?} {feed} {count}: {time} {limit}");
                missing.push(1.0 - time / limit);
            }
            // Each time ten times as many steps: the time so far, squared, falls short by a logarithm of their number.
            assert!(missing.windows(2).all(|pair| pair[1] <= pair[0] + 8.0 * EPSILON), "{way:?} {feed}: {missing:?}");
            assert!(missing[5] < 1e-4, "{way:?} {feed}: {missing:?}");
        }
    }
    // One step a half: the worksheet's factor sqrt(2).
    let way = [10.0, 0.0, 0.0];
    let [one, limit] =
        [steps(machine(LIMITS), 5.0), continuous(machine(LIMITS))].map(|m| cut(&m, way, f64::INFINITY).time);
    assert!((limit / one - 2.0_f64.sqrt()).abs() < 4.0 * EPSILON);
}

#[test]
fn a_hundred_thousand_steps_lose_no_digits() {
    let (mut time, mut speed) = (Float::with_val(200, 0), Float::with_val(200, 0));
    for _ in 0..100_000 {
        let root: Float = Float::with_val(200, &speed * &speed) + 4_u32;
        speed = (root.sqrt() + &speed) / 2_u32;
        time += Float::with_val(200, 1) / &speed;
    }
    // Limit 1 mm/s² and steps of 1 mm: the unit of the sequence itself.
    let row = cut(&steps(machine([1.0; 3]), 1.0), [200_000.0, 0.0, 0.0], f64::INFINITY);
    let [expected, peak] = [time.to_f64() * 2.0, speed.to_f64()];
    assert!((row.time / expected - 1.0).abs() <= 2.0 * EPSILON, "{} {expected}", row.time);
    assert!((row.peak / peak - 1.0).abs() <= 2.0 * EPSILON, "{} {peak}", row.peak);
}

#[test]
fn the_feed_makes_long_cuts_closed() {
    // A light year in steps of a micrometre, in no time.
    let row = cut(&steps(machine([100.0; 3]), 1e-3), [9.46e18, 0.0, 0.0], 5.0);
    assert_eq!(row.peak, 5.0);
    assert!((row.time / (9.46e18 / 5.0) - 1.0).abs() < 4.0 * EPSILON);
    // Without a speed limit that would be more steps than anybody wants.
    let error = steps(machine([100.0; 3]), 1e-3).polyline(&[[0.0; 3], [9.46e18, 0.0, 0.0]], Feed::Rapid).unwrap_err();
    let text =
        "step is 0.001: make it longer, or limit the speed: cuts of this length would take more than a million steps";
    assert_eq!(error.to_string(), text);
}

#[test]
fn a_trapezoid_by_hand() {
    // 25 mm/s with 500 mm/s²: 0.05 s and 0.625 mm up, the same down, 98.75 mm between.
    let milling = continuous(machine([500.0; 3]));
    let row = cut(&milling, [0.0, 100.0, 0.0], 25.0);
    assert!((row.time - (0.05 + 98.75 / 25.0 + 0.05)).abs() < 4.0 * EPSILON * row.time);
    assert_eq!((row.peak, row.feed, row.length), (25.0, 25.0, 100.0));
    // Too short to reach it: 1 mm, half of it in sqrt(2*0.5/500) s.
    let row = cut(&milling, [0.0, 0.0, -1.0], 25.0);
    assert!((row.time - 2.0 * 0.002_f64.sqrt()).abs() < 4.0 * EPSILON * row.time);
    assert!((row.peak - 500.0 * 0.002_f64.sqrt()).abs() < 4.0 * EPSILON * row.peak && row.feed == 25.0);
}

#[test]
fn the_limits_of_speed() {
    let limited = Machine { speed: [10.0, 20.0, 5.0], rapid: 100.0, feed: 8.0, ..machine([500.0; 3]) };
    let milling = continuous(limited);
    let feed = |way: [f64; 3], feed: Feed| milling.polyline(&[[0.0; 3], way], feed).unwrap().rows[0].feed;
    // Alone, an axis moves at its speed; in a diagonal, the slowest for its part decides.
    assert_eq!(feed([50.0, 0.0, 0.0], Feed::Rapid), 10.0);
    assert_eq!(feed([0.0, -50.0, 0.0], Feed::Rapid), 20.0);
    assert_eq!(feed([30.0, 0.0, 40.0], Feed::Rapid), 6.25);
    assert_eq!(feed([50.0, 0.0, 0.0], Feed::Speed(9.0)), 8.0);
    assert_eq!(feed([50.0, 0.0, 0.0], Feed::Speed(2.0)), 2.0);
    assert_eq!(feed([0.0, 0.0, 1.0], Feed::Speed(f64::INFINITY)), 5.0);
}

#[test]
fn the_edges() {
    let milling = steps(machine(LIMITS), 1.0);
    // Against an axis, or along it.
    for way in WAYS {
        let mirrored = way.map(|way| -way);
        assert_eq!(cut(&milling, way, 40.0).time, cut(&milling, mirrored, 40.0).time);
    }
    // An axis that does not move limits nothing, however weak it is.
    let weak = steps(machine([500.0, 1200.0, 1e-300]), 1.0);
    assert_eq!(cut(&milling, [60.0, 80.0, 0.0], 40.0).time, cut(&weak, [60.0, 80.0, 0.0], 40.0).time);
    // No way, no time.
    let row = cut(&milling, [0.0; 3], 40.0);
    assert_eq!((row.time, row.length, row.peak, row.feed), (0.0, 0.0, 0.0, 0.0));
    // 3 mm: a half is a step and a half, so it gets two of 0.75 mm, and the same as with steps of 0.75 mm.
    let way = [3.0, 0.0, 0.0];
    assert_eq!(cut(&milling, way, 40.0).time, cut(&steps(machine(LIMITS), 0.75), way, 40.0).time);
    // Shorter than two steps: one a half, whatever their length.
    let way = [0.5, 0.0, 0.0];
    assert_eq!(cut(&milling, way, 40.0).time, cut(&steps(machine(LIMITS), 1e9), way, 40.0).time);
    assert_eq!(cut(&milling, way, f64::INFINITY).time, 2.0 * (0.25_f64 / 500.0).sqrt());
}

#[test]
fn powers_of_two_scale_times_exactly() {
    for (length, time) in [(2_f64.powi(30), 1.0), (1.0, 2_f64.powi(-20)), (2_f64.powi(-300), 2_f64.powi(200))] {
        for way in WAYS {
            for feed in [f64::INFINITY, 40.0] {
                let scaled = machine(LIMITS.map(|limit| limit * length / time / time));
                let (far, feed_there) = (way.map(|way| way * length), feed * length / time);
                for (one, other) in [
                    (steps(machine(LIMITS), 0.7), steps(scaled, 0.7 * length)),
                    (continuous(machine(LIMITS)), continuous(scaled)),
                ] {
                    let (one, other) = (cut(&one, way, feed), cut(&other, far, feed_there));
                    assert_eq!(
                        (one.time * time, one.peak * length / time),
                        (other.time, other.peak),
                        "{way:?} {length:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_million_cuts_lose_no_digits() {
    let milling = steps(machine([500.0; 3]), 1.0);
    let mut timer = milling.timer();
    let (from, to) = ([0.0; 3], [0.1, 0.0, 0.0]);
    let one = Move::straight(from, to, Feed::Speed(7.0));
    let add = |timer: &mut Timer| {
        timer.add(&one).unwrap();
        timer.next_row().unwrap()
    };
    let time = add(&mut timer).time;
    for _ in 1..1_000_000 {
        add(&mut timer);
    }
    let exact: Float = Float::with_val(100, time) * 1_000_000_u32;
    assert_eq!(timer.time(), exact.to_f64());
    timer.dwell(2.0).unwrap();
    assert_eq!(add(&mut timer).number, 1_000_001);
}

fn arc(milling: &Milling, arc: Arc, feed: Feed) -> Row {
    let mut timer = milling.timer();
    timer.add(&Move { path: Path::Arc(arc), ..Move::straight([0.0; 3], [0.0; 3], feed) }).unwrap();
    timer.next_row().unwrap()
}

#[test]
fn on_an_arc_no_axis_exceeds_its_limits() {
    let limits = Machine { speed: [30.0, 50.0, 4.0], ..machine([500.0, 300.0, 200.0]) };
    for (radius, height, axis) in [(10.0, 0.0, 2), (0.5, 0.0, 2), (1000.0, 0.0, 1), (5.0, 30.0, 2), (5.0, 1.0, 0)] {
        let mut centre = [0.0; 3];
        centre[(axis + 1) % 3] = radius;
        let whole = Arc { radius, angle: std::f64::consts::TAU, height, axis, centre, clockwise: false };
        let row = arc(&continuous(limits), whole, Feed::Speed(100.0));
        let length = (radius * whole.angle).hypot(height);
        assert!((row.length - length).abs() < 4.0 * EPSILON * length);
        let (in_plane, along) = (radius * whole.angle / length, height / length);
        // The acceleration along the path, from the trapezoid that this time and peak belong to.
        let missing = row.peak * row.time - length;
        let (tangential, loose) = (row.peak * row.peak / missing, 1.0 + 16.0 * EPSILON * (1.0 + length / missing));
        let across = (in_plane * row.peak).powi(2) / radius;
        for degree in 0..360 {
            let (sin, cos) = f64::from(degree).to_radians().sin_cos();
            for (k, (part, normal)) in [(cos, sin), (sin, cos)].into_iter().enumerate() {
                let acceleration = (in_plane * tangential * part).abs() + (across * normal).abs();
                let axis = (axis + 1 + k) % 3;
                assert!(acceleration <= limits.acceleration[axis] * loose, "{whole:?} {axis}");
                assert!((in_plane * row.peak * part).abs() <= limits.speed[axis] * (1.0 + 4.0 * EPSILON));
            }
        }
        assert!(along * row.peak <= limits.speed[axis] * (1.0 + 4.0 * EPSILON));
        assert!(along * tangential <= limits.acceleration[axis] * loose);
        // Steps are never slower here either.
        assert!(arc(&steps(limits, 1.0), whole, Feed::Speed(100.0)).time <= row.time * (1.0 + 8.0 * EPSILON));
    }
    // An arc of no angle in its plane is a straight move along its axis.
    let centre = [5.0, 0.0, 0.0];
    let straight = Arc { radius: 5.0, angle: 0.0, height: 7.0, axis: 2, centre, clockwise: false };
    let milling = continuous(limits);
    assert_eq!(arc(&milling, straight, Feed::Rapid).time, cut(&milling, [0.0, 0.0, 7.0], f64::INFINITY).time);
}

fn message<T: std::fmt::Debug>(result: Result<T, PlanError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn bad_input_is_named() {
    let make = |change: fn(&mut Machine), model: Model| {
        let mut machine = Machine::default();
        change(&mut machine);
        message(Milling::new(machine, model))
    };
    let positive = "make it positive and finite";
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let text = message(Milling::new(Machine::default(), Model::Steps { length: bad }));
        assert_eq!(text, format!("step is {bad}: {positive}"));
    }
    let text = make(|m| m.acceleration[1] = 0.0, Model::ExactStop);
    assert_eq!(text, format!("axis 1: acceleration limit is 0: {positive}"));
    let positive = "make it positive, or infinite where there is none";
    assert_eq!(make(|m| m.speed[2] = -1.0, Model::default()), format!("axis 2: speed limit is -1: {positive}"));
    assert_eq!(make(|m| m.rapid = f64::NAN, Model::default()), format!("rapid speed is NaN: {positive}"));
    assert_eq!(make(|m| m.feed = 0.0, Model::default()), format!("feed limit is 0: {positive}"));
    let milling = Milling::new(Machine::default(), Model::default()).unwrap();
    let line = |points: &[[f64; 3]], feed: f64| message(milling.polyline(points, Feed::Speed(feed)));
    assert_eq!(line(&[[0.0; 3]], 1.0), "number of points is 1: give at least two");
    assert_eq!(
        line(&[[0.0; 3], [0.0, f64::NAN, 0.0]], 1.0),
        "point 1: a coordinate is NaN: make all coordinates finite"
    );
    for bad in [0.0, -3.0, f64::NAN] {
        assert_eq!(line(&[[0.0; 3], [1.0; 3]], bad), format!("feed is {bad}: make it positive"));
    }
    let far = [[-1.7e308; 3], [1.7e308; 3]];
    assert_eq!(line(&far, 1.0), "the length of a cut is beyond the range of 64-bit numbers: scale lengths or times");
}

#[test]
fn any_numbers_give_a_time_or_an_error() {
    let mut runner = TestRunner::new_with_rng(
        Config { cases: 2000, failure_persistence: None, ..Config::default() },
        TestRng::deterministic_rng(RngAlgorithm::ChaCha),
    );
    let decade = || (-300.0..300.0).prop_map(|power: f64| 10_f64.powf(power));
    let three = || [decade(), decade(), decade()];
    runner
        .run(&(three(), three(), decade(), decade()), |(way, acceleration, feed, step)| {
            for model in [Model::ExactStop, Model::Steps { length: step }] {
                let milling = Milling::new(machine(acceleration), model).unwrap();
                let job: Result<Job, PlanError> = milling.polyline(&[[0.0; 3], way], Feed::Speed(feed));
                if let Ok(job) = job {
                    let row = job.rows[0];
                    // At least the way at feed; the first term of both models.
                    prop_assert!(row.time >= row.length / feed * (1.0 - 8.0 * EPSILON), "{row:?}");
                    prop_assert!(row.peak > 0.0 && row.peak <= feed, "{row:?}");
                }
            }
            Ok(())
        })
        .unwrap();
}
