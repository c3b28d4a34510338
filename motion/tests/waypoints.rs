//! Paths through waypoints, put back into what the problems promise: solved once more by dense exact arithmetic.

use std::iter::repeat_with;

use closedform_motion::plan::waypoints::{Problem, Timing, WaypointPlan, Waypoints};
use closedform_motion::{PlanError, Profile, Segment};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use rug::Rational;

const EPSILON: f64 = f64::EPSILON;

/// What the problem promises, as linear equations of the coefficients, solved by Gauss in fractions.
mod exact {
    use super::{Problem, Rational};

    /// Coefficients of each segment, at most the fourth power.
    pub fn coefficients(problem: Problem, p: &[f64], t: &[f64]) -> Vec<[Rational; 5]> {
        let degrees = degrees(problem, t.len());
        let mut start = vec![0];
        for degree in &degrees {
            start.push(start[start.len() - 1] + degree + 1);
        }
        let (p, t): (Vec<Rational>, Vec<Rational>) = (p.iter().map(number).collect(), t.iter().map(number).collect());
        let unknowns = start[t.len()];
        let mut system = System { rows: Vec::new(), start, degrees, t, unknowns };
        system.conditions(problem, &p);
        assert_eq!(system.rows.len(), unknowns, "as many equations as coefficients");
        let solution = gauss(system.rows);
        let coefficient = |segment: usize, k: usize| match k <= system.degrees[segment] {
            true => solution[system.start[segment] + k].clone(),
            false => Rational::new(),
        };
        (0..system.t.len()).map(|segment| [0, 1, 2, 3, 4].map(|k| coefficient(segment, k))).collect()
    }

    fn number(x: &f64) -> Rational {
        Rational::from_f64(*x).unwrap()
    }

    fn degrees(problem: Problem, segments: usize) -> Vec<usize> {
        let (outer, inner) = match problem {
            Problem::Linear => (1, 1),
            Problem::QuadraticLinearQuadratic if segments == 3 => (2, 1),
            Problem::QuadraticLinearQuadratic
            | Problem::QuadraticCubicQuadraticAtRest
            | Problem::QuadraticCubicQuadratic => (2, 3),
            Problem::CubicsAtRest => (3, 3),
            Problem::QuarticCubicQuarticAtRest => (4, 3),
        };
        (0..segments).map(|i| if i == 0 || i + 1 == segments { outer } else { inner }).collect()
    }

    struct System {
        /// Factors of all unknowns, and the right side.
        rows: Vec<Vec<Rational>>,
        start: Vec<usize>,
        degrees: Vec<usize>,
        t: Vec<Rational>,
        unknowns: usize,
    }

    impl System {
        fn conditions(&mut self, problem: Problem, p: &[Rational]) {
            let last = self.t.len() - 1;
            for i in 0..=last {
                self.equation(&[(i, 0, false, 1)], p[i].clone());
                self.equation(&[(i, 0, true, 1)], p[i + 1].clone());
            }
            let meets = |order: usize, point: usize| match (problem, order) {
                (Problem::Linear, _) => false,
                (_, 1) => true,
                (Problem::QuadraticLinearQuadratic | Problem::QuadraticCubicQuadraticAtRest, _) => {
                    point > 1 && point < last
                }
                _ => true,
            };
            for (order, point) in [1, 2].into_iter().flat_map(|order| (1..=last).map(move |point| (order, point))) {
                if meets(order, point) {
                    self.equation(&[(point - 1, order, true, 1), (point, order, false, -1)], Rational::new());
                }
            }
            if problem == Problem::QuadraticLinearQuadratic && last > 2 {
                self.zero(2, 1, last - 1);
            }
            if matches!(
                problem,
                Problem::QuadraticCubicQuadraticAtRest | Problem::CubicsAtRest | Problem::QuarticCubicQuarticAtRest
            ) {
                self.zero(1, 0, last);
            }
            if problem == Problem::QuarticCubicQuarticAtRest {
                self.zero(2, 0, last);
            }
        }

        /// This derivative is 0 at the begin of one segment and the end of another.
        fn zero(&mut self, order: usize, first: usize, last: usize) {
            self.equation(&[(first, order, false, 1)], Rational::new());
            self.equation(&[(last, order, true, 1)], Rational::new());
        }

        /// A sum of derivatives (segment, order, at its end, factor) and what it is.
        fn equation(&mut self, terms: &[(usize, usize, bool, i32)], right: Rational) {
            let mut row = vec![Rational::new(); self.unknowns + 1];
            for (segment, order, at_end, factor) in terms {
                for k in *order..=self.degrees[*segment] {
                    let falling: usize = ((k - order + 1)..=k).product();
                    let power = match (k - order, at_end) {
                        (0, _) => Rational::from(1),
                        (_, false) => Rational::new(),
                        (n, true) => (0..n).fold(Rational::from(1), |product, _| product * &self.t[*segment]),
                    };
                    row[self.start[*segment] + k] += power * Rational::from(falling) * Rational::from(*factor);
                }
            }
            row[self.unknowns] = right;
            self.rows.push(row);
        }
    }

    fn gauss(mut rows: Vec<Vec<Rational>>) -> Vec<Rational> {
        let n = rows.len();
        for column in 0..n {
            let pivot = (column..n).find(|row| rows[*row][column] != 0).expect("one solution");
            rows.swap(column, pivot);
            let inverse = rows[column][column].clone().recip();
            rows[column].iter_mut().for_each(|entry| *entry *= &inverse);
            let pivot = rows[column].clone();
            for (at, row) in rows.iter_mut().enumerate() {
                if at == column || row[column] == 0 {
                    continue;
                }
                let factor = row[column].clone();
                row.iter_mut().zip(&pivot).for_each(|(entry, of_pivot)| *entry -= Rational::from(&factor * of_pivot));
            }
        }
        rows.into_iter().map(|mut row| row.pop().unwrap()).collect()
    }
}

/// Velocity, acceleration, jerk and snap at the begin, and velocity and acceleration at the end, exactly.
fn exact_numbers(c: &[Rational; 5], t: f64) -> [Rational; 6] {
    let t = Rational::from_f64(t).unwrap();
    let times = |k: usize, n: i32| &c[k] * Rational::from(n);
    let [v, a, j, s] = [times(1, 1), times(2, 2), times(3, 6), times(4, 24)];
    let half = Rational::from((1, 2));
    let end_a = a.clone() + &t * (j.clone() + Rational::from(&t * &s) * &half);
    let rest = Rational::from(&t * &s) / Rational::from(6) + j.clone() * &half;
    let end_v = v.clone() + &t * (a.clone() + &t * rest);
    [v, a, j, s, end_v, end_a]
}

fn numbers(segment: &Segment) -> [f64; 6] {
    let (a, b) = (segment.start, segment.end);
    [a.velocity, a.acceleration, segment.jerk, segment.snap, b.velocity, b.acceleration]
}

fn plan(problem: Problem, points: &[Vec<f64>], timing: Timing) -> WaypointPlan {
    Waypoints::new(problem, points.to_vec(), timing).plan().unwrap()
}

fn profile(problem: Problem, p: &[f64], t: &[f64]) -> Profile {
    let points: Vec<Vec<f64>> = p.iter().map(|p| vec![*p]).collect();
    plan(problem, &points, Timing::Durations(t.to_vec())).profiles()[0].clone()
}

fn apart(exact: &Rational, computed: f64) -> f64 {
    (exact - Rational::from_f64(computed).unwrap()).to_f64().abs()
}

fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |most, number| number.abs().max(most))
}

/// Repeatable numbers: uniform, and over decades.
struct Dice(TestRng);

impl Dice {
    fn new() -> Self {
        Self(TestRng::deterministic_rng(RngAlgorithm::ChaCha))
    }

    fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn many(&mut self, count: usize, low: f64, high: f64) -> Vec<f64> {
        repeat_with(|| self.between(low, high)).take(count).collect()
    }

    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }
}

#[test]
fn four_points_are_solved_to_the_last_digits() {
    let mut dice = Dice::new();
    for problem in Problem::ALL {
        for _ in 0..200 {
            let (p, t) = (dice.many(4, -1.0, 1.0), dice.many(3, 0.01, 2.0));
            let exact = exact::coefficients(problem, &p, &t);
            let profile = profile(problem, &p, &t);
            for ((segment, c), t) in profile.segments().iter().zip(&exact).zip(&t) {
                for (exact, computed) in exact_numbers(c, *t).iter().zip(numbers(segment)) {
                    // The kernels' bounds: at most 13.01 ulp, of at most EPSILON each.
                    let relative = apart(exact, computed) / exact.to_f64().abs().max(f64::MIN_POSITIVE);
                    assert!(relative <= 13.01 * EPSILON, "{problem:?} {p:?} {t:?}: {exact} {computed:e} {relative:e}");
                }
            }
        }
    }
}

/// Rows of the system have a diagonal of at least twice their rest, so an error on the right side, or of the
/// elimination, is at most doubled. Right side and elimination make some ten roundings each, of numbers up to 1.5 times
/// the largest acceleration.
const OF_ACCELERATION: f64 = 32.0 * EPSILON;

#[test]
fn many_points_are_solved_as_dense_exact_elimination_does() {
    let mut dice = Dice::new();
    for problem in Problem::ALL {
        for points in [5, 5, 6, 6, 7, 8, 9] {
            for spread in [0.0, 2.0] {
                let t: Vec<f64> = repeat_with(|| dice.decades(-spread, spread)).take(points - 1).collect();
                compare(problem, &dice.many(points, -1.0, 1.0), &t);
                // Nearly uniform motion: what is left of the velocities are the last third of their digits.
                let mut p = vec![1.0];
                t.iter().for_each(|t| p.push(p[p.len() - 1] + 0.7 * t));
                p.iter_mut().for_each(|p| *p += 1e-9 * dice.unit());
                compare(problem, &p, &t);
            }
        }
    }
}

fn compare(problem: Problem, p: &[f64], t: &[f64]) {
    let exact = exact::coefficients(problem, p, t);
    let exact: Vec<[Rational; 6]> = exact.iter().zip(t).map(|(c, t)| exact_numbers(c, *t)).collect();
    let profile = profile(problem, p, t);
    let most = largest(exact.iter().flat_map(|e| [e[1].to_f64(), e[5].to_f64()]));
    let (last, (outer, _)) = (t.len() - 1, problem.degrees());
    let of_segment = |i: usize| 32.0 * EPSILON * (((p[i + 1] - p[i]) / t[i]).abs() + t[i] * most);
    // The velocity at a point is as good as the cubic after it tells, or that before it; at the ends, the quadratic's
    // also as that at its other point.
    let after = |i: usize| if i + usize::from(outer != 3) > last { of_segment(i - 1) } else { of_segment(i) };
    let of_point = |i: usize| match i {
        _ if problem == Problem::Linear => of_segment(i.min(last)).max(of_segment(i.max(1) - 1)),
        0 => of_segment(0) + after(1),
        _ if i > last => of_segment(last) + after(last),
        _ => after(i),
    };
    for (i, (segment, exact)) in profile.segments().iter().zip(&exact).enumerate() {
        let (t, own) = (segment.duration, of_segment(i));
        // Quadratics get their acceleration from the velocities, but in (d); all others from the system.
        let by_velocity = outer == 2 && (i == 0 || i == last) && problem != Problem::QuadraticCubicQuadratic;
        let acceleration = OF_ACCELERATION * most + if by_velocity { own / t } else { 0.0 };
        let allowed = [
            of_point(i),
            acceleration,
            (2.0 * OF_ACCELERATION * most + own / t) / t,
            (8.0 * OF_ACCELERATION * most + 2.0 * own / t) / t / t,
            of_point(i + 1),
            acceleration,
        ];
        for (k, (exact, computed)) in exact.iter().zip(numbers(segment)).enumerate() {
            let apart = apart(exact, computed);
            assert!(apart <= allowed[k], "{problem:?} {p:?} {t:?} segment {i} number {k}: {apart:e} {:e}", allowed[k]);
        }
    }
}

/// What the problem promises holds exactly, bit by bit, at every point.
fn check_joints(problem: Problem, p: &[f64], profile: &Profile) {
    let segments = profile.segments();
    let last = segments.len() - 1;
    for (i, segment) in segments.iter().enumerate() {
        assert_eq!((segment.start.position, segment.end.position), (p[i], p[i + 1]), "{problem:?}");
    }
    for (i, pair) in segments.windows(2).enumerate() {
        let (end, start) = (pair[0].end, pair[1].start);
        let outer = i == 0 || i + 1 == last;
        if problem != Problem::Linear {
            assert_eq!(end.velocity, start.velocity, "{problem:?} {p:?} after segment {i}");
        }
        let jumps = match problem {
            Problem::Linear => true,
            Problem::QuadraticLinearQuadratic | Problem::QuadraticCubicQuadraticAtRest => outer,
            _ => false,
        };
        if !jumps {
            assert_eq!(end.acceleration, start.acceleration, "{problem:?} {p:?} after segment {i}");
        }
    }
    let (start, end) = (profile.start(), profile.end());
    let letter = problem.letter();
    if matches!(letter, 'c' | 'e' | 'f') {
        assert_eq!((start.velocity, end.velocity), (0.0, 0.0));
    }
    if letter == 'f' {
        assert_eq!((start.acceleration, end.acceleration), (0.0, 0.0));
    }
    for (i, segment) in segments.iter().enumerate() {
        let (outer, inner) = problem.degrees();
        let degree = if i == 0 || i == last { outer } else { inner };
        assert!(degree > 3 || segment.snap == 0.0);
        assert!(degree > 2 || segment.jerk == 0.0);
        assert!(degree > 2 || segment.start.acceleration == segment.end.acceleration);
        assert!(degree > 1 || segment.start.acceleration == 0.0);
    }
}

/// Integrating jerk and snap exactly from the begin of each segment leads to its end, up to rounding.
fn check_integral(problem: Problem, profile: &Profile) {
    for segment in profile.segments() {
        let exact = |x: f64| Rational::from_f64(x).unwrap();
        let (t, a) = (exact(segment.duration), segment.start);
        let terms = [a.position, a.velocity, a.acceleration, segment.jerk, segment.snap];
        let factors: [i32; 5] = [1, 1, 2, 6, 24];
        let mut power = Rational::from(1);
        let (mut sum, mut size) = (Rational::new(), 0.0_f64);
        for (term, factor) in terms.into_iter().zip(factors) {
            let part = exact(term) * &power / Rational::from(factor);
            size = size.max(part.to_f64().abs());
            sum += part;
            power *= &t;
        }
        let apart = apart(&sum, segment.end.position);
        // Each part has the error that `compare` allows its factor, so their sum a few times that of the largest.
        assert!(apart <= 256.0 * EPSILON * size, "{problem:?} {segment:?}: {apart:e} of {size:e}");
    }
}

#[test]
fn promises_hold_exactly_over_twelve_decades() {
    let mut dice = Dice::new();
    for round in 0..3000 {
        let points = 4 + round % 9;
        let dimension = 1 + round % 3;
        let (length, time) = (dice.decades(-6.0, 6.0), dice.decades(-6.0, 6.0));
        let path: Vec<Vec<f64>> = repeat_with(|| dice.many(dimension, -length, length)).take(points).collect();
        let t: Vec<f64> = repeat_with(|| time * dice.decades(-1.0, 1.0)).take(points - 1).collect();
        for timing in [Timing::Durations(t), Timing::Speed(length / time)] {
            for problem in Problem::ALL {
                let plan = plan(problem, &path, timing.clone());
                for (axis, profile) in plan.profiles().iter().enumerate() {
                    let p: Vec<f64> = path.iter().map(|point| point[axis]).collect();
                    check_joints(problem, &p, profile);
                    check_integral(problem, profile);
                }
            }
        }
    }
}

#[test]
fn powers_of_two_scale_plans_exactly() {
    let mut dice = Dice::new();
    for points in [4, 5, 9] {
        let (p, t) = (dice.many(points, -1.0, 1.0), dice.many(points - 1, 0.1, 2.0));
        for problem in Problem::ALL {
            let base = profile(problem, &p, &t);
            for (length, time) in [(2_f64.powi(40), 1.0), (1.0, 2_f64.powi(-37)), (2_f64.powi(-90), 2_f64.powi(80))] {
                let (p, t): (Vec<f64>, Vec<f64>) =
                    (p.iter().map(|p| p * length).collect(), t.iter().map(|t| t * time).collect());
                let scaled = profile(problem, &p, &t);
                for (one, other) in base.segments().iter().zip(scaled.segments()) {
                    let powers = [1, 2, 3, 4, 1, 2];
                    for ((one, other), power) in numbers(one).into_iter().zip(numbers(other)).zip(powers) {
                        assert_eq!(one * length / time.powi(power), other, "{problem:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_way_back_is_the_way_there() {
    let mut dice = Dice::new();
    for points in [4, 6, 11] {
        let (p, t) = (dice.many(points, -1.0, 1.0), dice.many(points - 1, 0.5, 2.0));
        let (back_p, back_t): (Vec<f64>, Vec<f64>) =
            (p.iter().rev().copied().collect(), t.iter().rev().copied().collect());
        for problem in Problem::ALL {
            let (way, back) = (profile(problem, &p, &t), profile(problem, &back_p, &back_t));
            let most = largest(way.segments().iter().flat_map(numbers));
            for (way, back) in way.segments().iter().zip(back.segments().iter().rev()) {
                let (v, a) = (way.start.velocity + back.end.velocity, way.start.acceleration - back.end.acceleration);
                // Two errors as `compare` allows them.
                assert!(v.abs().max(a.abs()) < 256.0 * EPSILON * most, "{problem:?}: {v:e} {a:e}");
            }
        }
    }
}

#[test]
fn uniform_motion_stays_uniform() {
    // On a line over time, (a), (b) and (d) are that line, with any number of points.
    for points in [4_u32, 5, 20] {
        let t: Vec<f64> = (1..points).map(|i| f64::from(i % 3 + 1)).collect();
        let mut p = vec![1.0];
        t.iter().for_each(|t| p.push(p[p.len() - 1] + 0.5 * t));
        for problem in [Problem::Linear, Problem::QuadraticLinearQuadratic, Problem::QuadraticCubicQuadratic] {
            for segment in profile(problem, &p, &t).segments() {
                assert_eq!(numbers(segment), [0.5, 0.0, 0.0, 0.0, 0.5, 0.0], "{problem:?} {points}");
            }
        }
    }
}

#[test]
fn times_by_distance_do_not_overflow() {
    let shapes = [vec![[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [3.0, 4.0, 2.0], [5.0, 5.0, 4.0]]];
    for points in shapes {
        for power in [-1000, -540, -300, 0, 300, 540, 1000] {
            let length = 2_f64.powi(power);
            let path: Vec<Vec<f64>> = points.iter().map(|point| point.map(|x| x * length).to_vec()).collect();
            let plan = Waypoints::new(Problem::Linear, path, Timing::Speed(length)).plan().unwrap();
            assert_eq!(plan.durations(), [5.0, 2.0, 3.0]);
        }
    }
    // One coordinate: its distance. And a third coordinate may keep points apart.
    let line: Vec<Vec<f64>> = [0.0, -2.0, 2.0, 3.0].map(|x| vec![x]).to_vec();
    assert_eq!(plan(Problem::Linear, &line, Timing::Speed(2.0)).durations(), [1.0, 2.0, 0.5]);
}

#[test]
fn the_seeds_case_and_names() {
    // maxima-ref/waypoints.mac: 0, 1, 3, 4 in the times 1, 2, 1.
    let (p, t) = ([0.0, 1.0, 3.0, 4.0], [1.0, 2.0, 1.0]);
    let c = profile(Problem::QuadraticCubicQuadraticAtRest, &p, &t);
    assert_eq!(numbers(&c.segments()[1]), [2.0, -3.0, 3.0, 0.0, 2.0, 3.0]);
    for problem in Problem::ALL {
        assert_eq!(Problem::of_letter(problem.letter()), Some(problem));
    }
    assert_eq!(Problem::of_letter('g'), None);
    let path: Vec<Vec<f64>> = p.iter().map(|p| vec![*p, 0.0]).collect();
    let motion = plan(Problem::CubicsAtRest, &path, Timing::Speed(1.0)).motion();
    let names: Vec<&str> = motion.axes().iter().map(|axis| axis.name.as_str()).collect();
    assert_eq!((names, motion.duration()), (vec!["X", "Y"], 4.0));
}

#[test]
fn a_long_path_takes_linear_time() {
    let mut dice = Dice::new();
    let path: Vec<Vec<f64>> = repeat_with(|| dice.many(2, -1.0, 1.0)).take(200_000).collect();
    let plan = plan(Problem::CubicsAtRest, &path, Timing::Speed(1.0));
    let p: Vec<f64> = path.iter().map(|point| point[0]).collect();
    check_joints(Problem::CubicsAtRest, &p, &plan.profiles()[0]);
}

/// One to change.
fn good() -> Waypoints {
    let points = vec![vec![0.0, 0.0], vec![1.0, 0.0], vec![1.0, 1.0], vec![2.0, 3.0]];
    Waypoints::new(Problem::CubicsAtRest, points, Timing::Speed(1.0))
}

fn message(change: impl FnOnce(&mut Waypoints)) -> String {
    let mut waypoints = good();
    change(&mut waypoints);
    waypoints.plan().unwrap_err().to_string()
}

#[test]
fn bad_input_is_named() {
    let speed = |speed: f64| message(|w| w.timing = Timing::Speed(speed));
    let durations = |durations: &[f64]| message(|w| w.timing = Timing::Durations(durations.to_vec()));
    let few = |count: usize, problem| {
        message(|w| {
            w.points.truncate(count);
            w.problem = problem;
        })
    };
    let natural = Problem::QuadraticLinearQuadratic;
    let remedy = "give at least four, or with three points problem a, e or f";
    assert_eq!(few(3, natural), format!("number of points is 3: {remedy}"));
    assert_eq!(few(2, natural), "number of points is 2: give at least four, or with two points problem a or e");
    assert_eq!(few(0, Problem::CubicsAtRest), "number of points is 0: give at least two");
    assert_eq!(
        message(|w| w.points[2] = w.points[1].clone()),
        "points 1 and 2 are the same, so the way between them takes no time: drop one, or give durations"
    );
    assert_eq!(
        message(|w| w.points[2] = vec![1.0]),
        "point 2: number of coordinates is 1: give all points as many as point 0"
    );
    assert_eq!(message(|w| w.points[0] = vec![]), "point 0: number of coordinates is 0: give one or more");
    assert_eq!(message(|w| w.points[3][1] = f64::NAN), "point 3: a coordinate is NaN: make all coordinates finite");
    assert_eq!(
        message(|w| w.points[3][1] = f64::INFINITY),
        "point 3: a coordinate is inf: make all coordinates finite"
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(speed(bad), format!("speed is {bad}: make it positive and finite"));
        assert_eq!(durations(&[1.0, bad, 1.0]), format!("segment 1: duration is {bad}: make it positive and finite"));
    }
    assert_eq!(durations(&[1.0, 1.0]), "number of durations is 2: give one a segment, one fewer than points");
}

#[test]
fn beyond_the_range_is_an_error_not_a_number() {
    let far = |points: [f64; 4], timing: Timing| {
        let points = points.map(|x| vec![x]).to_vec();
        Waypoints::new(Problem::QuarticCubicQuarticAtRest, points, timing).plan()
    };
    let range = |result: Result<WaypointPlan, PlanError>| matches!(result, Err(PlanError::Range { .. }));
    assert!(range(far([-1.7e308, 1.7e308, 0.0, 1.0], Timing::Speed(1.0))));
    assert!(range(far([0.0, 1e300, 0.0, 1.0], Timing::Durations(vec![1e-10; 3]))));
    assert!(range(far([0.0, 1e-300, 0.0, 1e-300], Timing::Speed(1e300))));
    // Far apart in time: beyond what the kernels take, not beyond what can be planned.
    let plan = far([0.0, 1.0, 2.0, 3.0], Timing::Durations(vec![1e-15, 1.0, 1e15])).unwrap();
    check_joints(Problem::QuarticCubicQuarticAtRest, &[0.0, 1.0, 2.0, 3.0], &plan.profiles()[0]);
    // With given durations, points may be the same.
    let plan = far([2.0; 4], Timing::Durations(vec![1.0; 3])).unwrap();
    assert!(plan.profiles()[0].segments().iter().all(|segment| numbers(segment) == [0.0; 6]));
}

#[test]
fn any_numbers_give_a_plan_or_an_error() {
    let mut runner = TestRunner::new_with_rng(
        Config { cases: 2000, failure_persistence: None, ..Config::default() },
        TestRng::deterministic_rng(RngAlgorithm::ChaCha),
    );
    let numbers = || prop::collection::vec(any::<f64>(), 3..8);
    runner
        .run(&(numbers(), numbers(), any::<f64>(), 0..6_usize), |(p, t, speed, problem)| {
            for timing in [Timing::Durations(t.clone()), Timing::Speed(speed)] {
                let points = p.iter().map(|p| vec![*p]).collect();
                let waypoints = Waypoints::new(Problem::ALL[problem], points, timing);
                if let Ok(plan) = waypoints.plan() {
                    check_joints(waypoints.problem, &p, &plan.profiles()[0]);
                }
            }
            Ok(())
        })
        .unwrap();
}
