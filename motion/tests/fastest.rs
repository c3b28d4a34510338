//! The fastest moves: they end where they should, keep their limits, and nothing of bang, coast and bang is faster.

mod support;

use closedform_motion::plan::fastest::{Fastest, Together, together};
use closedform_motion::{Limits, PlanError, Profile, Quantity, State};
use support::{EPS, Random, integrates, problems};

const NONE: f64 = f64::INFINITY;

/// A problem over decades of every unit.
struct Problem {
    start: State,
    end: State,
    limits: Limits,
}

impl Problem {
    /// From rest to rest, or between velocities; lengths and times in units over twelve decades each.
    fn random(random: &mut Random, is_resting: bool) -> Self {
        let (length, time) = (random.decades(-6.0, 6.0), random.decades(-6.0, 6.0));
        let limit = |random: &mut Random, unit: f64| unit * random.decades(-1.5, 1.5);
        let velocity = limit(random, length / time);
        let none = (random.unit() * 6.0) as u32;
        let limits = Limits {
            velocity: if none == 0 { NONE } else { velocity },
            acceleration: if none == 1 { NONE } else { limit(random, length / time / time) },
            jerk: if none == 2 { NONE } else { limit(random, length / time / time / time) },
        };
        let position = |random: &mut Random| length * random.between(-1.0, 1.0) * random.decades(-2.0, 1.0);
        let speed = |random: &mut Random| if is_resting { 0.0 } else { velocity * random.between(-1.0, 1.0) };
        let (from, v0) = (position(random), speed(random));
        let v1 = if random.unit() < 0.2 { v0 } else { speed(random) };
        Self { start: State::cruise(from, v0), end: State::cruise(position(random), v1), limits }
    }

    fn plan(&self) -> Fastest {
        Fastest::new(self.start, self.end, self.limits).unwrap_or_else(|error| panic!("{self}: {error}"))
    }
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?} to {:?} within {:?}", self.start, self.end, self.limits)
    }
}

/// That a profile is a move between the states within the limits, at all times.
fn is_move(profile: &Profile, problem: &Problem) {
    let what = problem.to_string();
    for (state, given) in [(profile.start(), problem.start), (profile.end(), problem.end)] {
        assert_eq!((state.position, state.velocity), (given.position, given.velocity), "{what}");
    }
    integrates(profile, &what);
    let limits = problem.limits;
    let quantities = [
        (Quantity::Velocity, limits.velocity),
        (Quantity::Acceleration, limits.acceleration),
        (Quantity::Jerk, limits.jerk),
    ];
    for (quantity, limit) in quantities {
        let peak = profile.extremes(quantity).peak().value.abs();
        // two quotients and a product of numbers that kernels give to 5 ulp
        assert!(peak <= limit * (1.0 + 24.0 * EPS), "{what}: {quantity:?} is {peak}");
    }
}

#[test]
fn moves_keep_their_limits_over_twelve_decades() {
    let mut random = Random(1601);
    for count in 0..problems() / 10 {
        let problem = Problem::random(&mut random, count % 2 == 0);
        let plan = problem.plan();
        let profile = plan.profile().unwrap_or_else(|error| panic!("{problem}: {error}"));
        is_move(&profile, &problem);
        assert!((profile.duration() - plan.duration()).abs() <= 16.0 * EPS * plan.duration(), "{problem}");
    }
}

/// Of a move with the jerks +j, 0, -j in the first three times and -j, 0, +j in the last three: where it comes to.
struct Bang {
    way: f64,
    velocity: f64,
}

/// Integrates stretches of constant jerk, none of which leaves the limits; none where one does.
fn bang(v0: f64, stretches: &[(f64, f64)], limits: &Limits) -> Option<Bang> {
    let (mut x, mut v, mut a) = (0.0, v0, 0.0);
    let fits = |value: f64, limit: f64| value.abs() <= limit * (1.0 + 1e-9);
    for &(time, jerk) in stretches {
        let turn = if jerk == 0.0 { NONE } else { -a / jerk };
        if turn > 0.0 && turn < time && !fits(v + turn * (a + turn * jerk / 2.0), limits.velocity) {
            return None;
        }
        x += time * (v + time * (a / 2.0 + time * jerk / 6.0));
        v += time * (a + time * jerk / 2.0);
        a += time * jerk;
        if !fits(v, limits.velocity) || !fits(a, limits.acceleration) {
            return None;
        }
    }
    Some(Bang { way: x, velocity: v })
}

/// Random moves of up to seven stretches, of jerks and times that know nothing of the planner: one that ends with the
/// velocity that the planner is asked for, no acceleration, at some way, takes no less time than the planner's to there.
#[test]
fn no_random_move_within_the_limits_is_faster() {
    let mut random = Random(1602);
    let mut judged = 0;
    for _ in 0..problems() {
        let limits = Limits {
            velocity: random.decades(-1.0, 1.0),
            acceleration: random.decades(-1.0, 1.0),
            jerk: random.decades(-1.0, 1.0),
        };
        let v0 = limits.velocity * random.between(-1.0, 1.0) * f64::from(u8::from(random.unit() < 0.7));
        // jerks of full and of half size; the last but one time makes the acceleration end with 0
        let mut stretches = Vec::new();
        let mut a = 0.0;
        for _ in 0..2 + (random.unit() * 4.0) as usize {
            let jerk = limits.jerk * [1.0, -1.0, 0.0, 0.5, -0.5][(random.unit() * 5.0) as usize];
            let time = random.decades(-2.0, 1.0) * (limits.acceleration / limits.jerk);
            stretches.push((time, jerk));
            a += time * jerk;
        }
        let slowing = if a > 0.0 { -limits.jerk } else { limits.jerk };
        stretches.push((a.abs() / limits.jerk, slowing));
        let Some(found) = bang(v0, &stretches, &limits) else { continue };
        let time: f64 = stretches.iter().map(|(time, _)| time).sum();
        let v1 = found.velocity.clamp(-limits.velocity, limits.velocity);
        // a way that misses that of the direct ramp by the rounding of this sum takes much longer: its neighbours do not
        let near = 1e-9 * (found.way.abs() + limits.velocity * time);
        let duration = |way| {
            let plan = Fastest::new(State::cruise(0.0, v0), State::cruise(way, v1), limits).expect("a plan");
            plan.duration()
        };
        let best = [found.way - near, found.way, found.way + near].map(duration).into_iter().fold(NONE, f64::min);
        assert!(
            best <= time * (1.0 + 1e-6),
            "{limits:?} from {v0} to {v1} along {}: {best} against {time} of {stretches:?}",
            found.way
        );
        judged += 1;
    }
    assert!(judged > problems() / 10, "{judged}");
}

/// The least time from rest to rest by trying the largest velocity and acceleration on a fine grid.
#[test]
fn no_grid_of_peaks_is_faster_from_rest_to_rest() {
    let mut random = Random(1603);
    for _ in 0..300 {
        let problem = Problem::random(&mut random, true);
        let Limits { velocity: v, acceleration: a, jerk: j } = problem.limits;
        let d = (problem.end.position - problem.start.position).abs();
        let best = problem.plan().duration();
        let top = v.min(2.0 * d / best);
        for step in 1..=400 {
            let peak = top * f64::from(step) / 400.0;
            for share in 1..=20 {
                let a_peak = a.min((peak * j).sqrt()) * f64::from(share) / 20.0;
                if !(a_peak > 0.0 && a_peak.is_finite()) {
                    continue;
                }
                let ramp = peak / a_peak + a_peak / j;
                let cruise = d / peak - ramp;
                if cruise >= 0.0 {
                    let time = 2.0 * ramp + cruise;
                    assert!(best <= time * (1.0 + 1e-12), "{problem}: {best} against {time}");
                }
            }
        }
    }
}

#[test]
fn the_four_cases_have_their_shapes() {
    let case = |velocity, acceleration, jerk| {
        let limits = Limits { velocity, acceleration, jerk };
        let plan = Fastest::new(State::rest(0.0), State::rest(1.0), limits).expect("a plan");
        (plan.duration(), plan.profile().expect("a profile").segments().len())
    };
    assert_eq!(case(0.5, 1.0, 4.0), (2.75, 7));
    assert_eq!(case(NONE, 1.0, 16.0).1, 6);
    assert_eq!(case(0.5, NONE, 2.0), (3.0, 5));
    assert_eq!(case(NONE, NONE, 4.0), (2.0, 4));
    assert_eq!(case(0.5, 1.0, NONE), (2.5, 3));
    assert_eq!(case(NONE, 1.0, NONE), (2.0, 2));
}

#[test]
fn a_stretched_move_takes_the_time_and_is_no_harder() {
    let mut random = Random(1604);
    for count in 0..problems() / 50 {
        let problem = Problem::random(&mut random, count % 2 == 0);
        let plan = problem.plan();
        let time = plan.duration() * random.between(1.0, 20.0);
        let Ok(stretched) = plan.stretched(time) else {
            assert_eq!(count % 2, 1, "{problem}: from rest to rest any longer time will do");
            continue;
        };
        assert!((stretched.duration() - time).abs() <= 1e-8 * time, "{problem}");
        is_move(&stretched.profile().expect("a profile"), &problem);
    }
}

#[test]
fn axes_arrive_together() {
    let axis = |name: &str, to: f64, jerk| Together {
        name: name.to_owned(),
        start: State::rest(0.0),
        end: State::rest(to),
        limits: Limits { velocity: 0.1, acceleration: 2.0, jerk },
    };
    let axes = [axis("x", 0.1, 100.0), axis("y", -1e-3, NONE), axis("z", 0.0, 100.0)];
    let motion = together(&axes, None).expect("a motion");
    for axis in motion.axes() {
        assert!((axis.profile.duration() - motion.duration()).abs() <= 8.0 * EPS * motion.duration());
    }
    assert_eq!(motion.axes()[1].profile.end().position, -1e-3);
    assert!((together(&axes, Some(3.0)).expect("a motion").duration() - 3.0).abs() < 1e-15);
    assert!(matches!(together(&axes, Some(0.5)), Err(PlanError::Limit { name: "time", .. })));
}

#[test]
fn what_cannot_be_planned_is_said() {
    let plan = |from: State, limits| Fastest::new(from, State::rest(1.0), limits).map(|plan| plan.duration());
    let limits = Limits { velocity: 1.0, acceleration: 1.0, jerk: 1.0 };
    assert!(plan(State::rest(0.0), Limits { acceleration: NONE, jerk: NONE, ..limits }).is_err());
    assert!(plan(State::cruise(0.0, 2.0), limits).is_err());
    assert!(plan(State { acceleration: 1.0, ..State::rest(0.0) }, limits).is_err());
    for bad in [f64::NAN, NONE] {
        assert!(plan(State::rest(bad), limits).is_err());
    }
    for bad in [f64::NAN, 0.0, -1.0] {
        assert!(plan(State::rest(0.0), Limits { velocity: bad, ..limits }).is_err());
    }
    assert_eq!(plan(State::rest(1.0), limits), Ok(0.0));
}

/// The time of a ramp between two velocities.
fn ramp_time(from: f64, to: f64, limits: &Limits) -> f64 {
    let (rise, a, j) = ((to - from).abs(), limits.acceleration, limits.jerk);
    if rise * j >= a * a { rise / a + a / j } else { 2.0 * (rise / j).sqrt() }
}

/// The least time of all moves in a ramp to a peak, on at it, and a ramp to the end: by a grid of peaks, and bisection in
/// each of its gaps where the way comes out.
fn least_time_of_peaks(way: f64, v0: f64, v1: f64, limits: &Limits) -> f64 {
    let v_max = limits.velocity;
    let ramps = |peak: f64| ramp_time(v0, peak, limits) + ramp_time(peak, v1, limits);
    let off = |peak: f64| {
        let to_peak = (v0 + peak) / 2.0 * ramp_time(v0, peak, limits);
        to_peak + (peak + v1) / 2.0 * ramp_time(peak, v1, limits) - way
    };
    let cruising = [v_max, -v_max].map(|peak| (peak, -off(peak) / peak));
    let mut least =
        cruising.iter().filter(|(_, time)| *time >= 0.0).map(|(peak, time)| ramps(*peak) + time).fold(NONE, f64::min);
    let mut peaks: Vec<f64> = (0..=400).map(|step| v_max * (f64::from(step) / 200.0 - 1.0)).collect();
    peaks.extend([v0, v1]);
    peaks.sort_by(f64::total_cmp);
    for pair in peaks.windows(2) {
        let (mut low, mut high) = (pair[0], pair[1]);
        if (off(low) > 0.0) == (off(high) > 0.0) {
            continue;
        }
        for _ in 0..100 {
            let middle = (low + high) / 2.0;
            *(if (off(middle) > 0.0) == (off(low) > 0.0) { &mut low } else { &mut high }) = middle;
        }
        least = least.min(ramps(high));
    }
    least
}

/// Way, velocities at the ends, and limits, of a unit of 1e-6, and the time of a well-known planner, whose profile is shorter
/// because it goes beyond the limit of the velocity: by 0.9 to 19 %, as its own times and jerks say.
const BEYOND_THE_LIMIT: [[f64; 7]; 7] = [
    [
        9.992784593046261e-09,
        1.3217533917068826e-08,
        6.054503142855863e-09,
        1.362836698763214e-08,
        9.175717683801523e-07,
        6.20215057427208e-08,
        0.9245144671573188,
    ],
    [
        -7.116264859848339e-08,
        -9.26584692499677e-09,
        -4.094953236940589e-08,
        4.200257671491389e-08,
        1.183423594740807e-06,
        3.114718410759081e-08,
        2.491952315837441,
    ],
    [
        -1.752361570832108e-08,
        6.69293449017011e-09,
        -6.9587426560436855e-09,
        1.1426909499142693e-08,
        6.613056955575013e-05,
        1.585288113930089e-08,
        3.361969276218887,
    ],
    [
        -4.353591355691842e-08,
        -1.5661129177002915e-08,
        -3.809135175719731e-09,
        1.8210990673158574e-08,
        3.2653439985808797e-07,
        2.1126993425811528e-08,
        2.9129673311360293,
    ],
    [
        -2.0879039924124725e-08,
        -8.354880037331185e-09,
        7.101153097140225e-09,
        1.1692377480297677e-08,
        8.386058735245723e-08,
        1.1047139786665464e-08,
        3.942214253138342,
    ],
    [
        3.758018663367029e-08,
        1.761333093489437e-08,
        7.23749672617692e-09,
        1.769865171663895e-08,
        1.1741181609135372e-06,
        2.0016206030259258e-08,
        2.4098015334891296,
    ],
    [
        -1.805960630315533e-08,
        -1.1905325643626701e-08,
        -4.684186144433986e-09,
        1.1964587074901574e-08,
        5.024157369311326e-08,
        1.2834511519117633e-08,
        1.9464652542519438,
    ],
];

#[test]
fn small_units_bend_no_limit() {
    let mut random = Random(1607);
    let unit = 1e-6;
    let drawn = std::iter::repeat_with(|| {
        let mut decades = |least: f64, most: f64| random.decades(least, most) * unit;
        let (way, v, a, j) = (decades(-4.0, 2.0), decades(-2.0, 2.0), decades(-2.0, 2.0), decades(-2.0, 2.0));
        [way * random.between(-1.0, 1.0), v * random.between(-1.0, 1.0), v * random.between(-1.0, 1.0), v, a, j, 0.0]
    });
    let drawn: Vec<_> = drawn.take(problems() as usize / 100).collect();
    for [way, v0, v1, velocity, acceleration, jerk, beyond] in BEYOND_THE_LIMIT.into_iter().chain(drawn) {
        let limits = Limits { velocity, acceleration, jerk };
        let problem = Problem { start: State::cruise(0.0, v0), end: State::cruise(way, v1), limits };
        let plan = problem.plan();
        is_move(&plan.profile().expect("a profile"), &problem);
        let least = least_time_of_peaks(way, v0, v1, &limits);
        // a peak that lies close to a velocity at an end makes a ramp whose time is a root of their difference
        let off = (plan.duration() / least - 1.0).abs();
        assert!(off <= 1e-7, "{problem}: {} for {least}", plan.duration());
        assert!(plan.duration() > beyond, "{problem}");
    }
}
