//! Profiles: extremes, sampling, smoothness; motions: knots and peaks.

mod support;

use closedform_motion::{Axis, Limits, Motion, PlanError, Profile, Quantity, Sample, Segment, State};
use proptest::prelude::*;
use support::EPS;

fn profile(segments: Vec<Segment>) -> Profile {
    Profile::new(segments).expect("a profile")
}

/// A profile of quartics that meet in position, velocity and acceleration.
fn smooth(start: State, pieces: &[(f64, f64, f64)]) -> Profile {
    let mut state = start;
    let mut segments = Vec::new();
    for &(duration, jerk, snap) in pieces {
        let segment = Segment::with_snap(state, duration, jerk, snap);
        state = segment.end;
        segments.push(segment);
    }
    profile(segments)
}

#[test]
fn extremes_of_known_polynomials() {
    // x = t^3/6 - t on [0, 2]: least at sqrt(2), -2*sqrt(2)/3
    let cubic = smooth(State::cruise(0.0, -1.0), &[(2.0, 1.0, 0.0)]);
    let position = cubic.extremes(Quantity::Position);
    assert!((position.least.value + 8_f64.sqrt() / 3.0).abs() <= EPS);
    assert!((position.least.time - 2_f64.sqrt()).abs() <= 2.0 * EPS);
    assert_eq!((position.largest.value, position.largest.time), (0.0, 0.0));
    let velocity = cubic.extremes(Quantity::Velocity);
    assert_eq!((velocity.least.value, velocity.largest.value), (-1.0, 1.0));
    // v = (t-1)(t-2)(t-4) on [0, 5]: x has its extremes at 1, 2 and 4
    let start = State { position: 0.0, velocity: -8.0, acceleration: 14.0 };
    let quartic = smooth(start, &[(5.0, -14.0, 6.0)]);
    let at = |t: f64| t * (-8.0 + t * (7.0 + t * (-7.0 / 3.0 + t / 4.0)));
    let position = quartic.extremes(Quantity::Position);
    assert!((position.least.value - at(4.0)).abs() <= 16.0 * EPS * 8.0, "{position:?}");
    assert!((position.largest.value - 0.0).abs() <= 16.0 * EPS * 8.0, "{position:?}");
    let velocity = quartic.extremes(Quantity::Velocity);
    // at (7 -+ sqrt(7))/3, and 12 at the end
    assert_eq!(velocity.least.value, -8.0);
    assert_eq!(velocity.largest.value, quartic.end().velocity);
    assert_eq!(quartic.extremes(Quantity::Jerk).least.value, -14.0);
}

#[test]
fn a_jump_counts_on_both_sides() {
    let before = Segment::with_jerk(State { position: 0.0, velocity: 0.0, acceleration: 3.0 }, 1.0, 0.0);
    let after = Segment::with_jerk(State { acceleration: -4.0, ..before.end }, 1.0, 0.0);
    let jump = profile(vec![before, after]);
    let acceleration = jump.extremes(Quantity::Acceleration);
    assert_eq!((acceleration.least.value, acceleration.largest.value), (-4.0, 3.0));
    assert_eq!((acceleration.peak().value, acceleration.peak().time), (-4.0, 1.0));
    let smoothness = jump.smoothness();
    assert_eq!((smoothness.acceleration.size, smoothness.acceleration.time), (-7.0, 1.0));
    assert_eq!(smoothness.order(), 1);
    assert_eq!(smoothness.closing, State::default());
}

#[test]
fn samples_cover_the_profile_once() {
    let p = smooth(State::rest(0.0), &[(0.25, 1.0, 0.0), (0.5, -1.0, 2.0), (0.25, 1.0, 0.0)]);
    let samples: Vec<_> = p.samples(8.0).expect("a rate").collect();
    let times: Vec<_> = samples.iter().map(|(time, _)| *time).collect();
    assert_eq!(times, [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0]);
    assert!(samples.iter().all(|(time, sample)| *sample == p.at(*time)));
    let odd: Vec<_> = p.samples(2.5).expect("a rate").map(|(time, _)| time).collect();
    assert_eq!(odd, [0.0, 0.4, 0.8, 1.0]);
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(p.samples(rate), Err(PlanError::Input { name: "rate", .. })));
    }
    assert!(p.sample_into(&[0.0; 3], &mut [Sample::default(); 2]).is_err());
    assert!(p.at(f64::NAN).position.is_nan());
}

#[test]
fn a_motion_has_the_knots_of_all_axes_once() {
    let axis = |name: &str, pieces: &[f64]| Axis {
        name: name.into(),
        profile: smooth(State::rest(0.0), &pieces.iter().map(|t| (*t, 1.0, 0.0)).collect::<Vec<_>>()),
        limits: Limits { velocity: 2.0, acceleration: 4.0, jerk: f64::INFINITY },
    };
    // 0.1 ten times is 1 but for rounding
    let motion = Motion::new(vec![axis("a", &[0.1; 10]), axis("b", &[0.25, 0.75]), axis("c", &[0.5])]);
    let times = motion.times();
    assert_eq!(times.len(), 12, "{times:?}");
    assert_eq!((times[0], times[11]), (0.0, motion.duration()));
    let end = motion.at(5.0);
    assert_eq!(end.states[2], motion.axes()[2].profile.end());
    let peaks = motion.peaks();
    assert_eq!(peaks[1].name, "b");
    assert_eq!((peaks[1].velocity.share(), peaks[1].acceleration.share(), peaks[1].jerk.share()), (0.25, 0.25, 0.0));
}

#[test]
fn times_are_summed_with_what_rounding_leaves() {
    let p = smooth(State::rest(0.0), &vec![(0.1, 0.0, 0.0); 1_000_000]);
    // 10^6 * the double 0.1, rounded once
    assert_eq!(p.duration(), 1e6 * 0.1);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn no_sample_is_beyond_the_extremes(
        start in (-1.0..1.0, -1.0..1.0, -1.0..1.0),
        pieces in prop::collection::vec((0.0..2.0, -5.0..5.0, -5.0..5.0), 1..5),
        scale in -40_i32..40,
    ) {
        let start = State { position: start.0, velocity: start.1, acceleration: start.2 };
        let unit = 2_f64.powi(scale);
        let p = smooth(start, &pieces);
        let long: Vec<_> = pieces.iter().map(|(t, j, s)| (*t, j * unit, s * unit)).collect();
        let [position, velocity, acceleration] = [start.position, start.velocity, start.acceleration].map(|x| x * unit);
        let scaled = State { position, velocity, acceleration };
        let q = smooth(scaled, &long);
        // a sample has 12 roundings of terms of its size or, where they cancel, of the largest: at most these
        let size: f64 = pieces.iter().fold(3.0, |size, (t, j, s)| (size + j.abs() + s.abs()) * (1.0 + t).powi(4));
        for quantity in Quantity::ALL {
            let found = p.extremes(quantity);
            let (least, largest) = (found.least, found.largest);
            prop_assert_eq!(q.extremes(quantity).largest.value, largest.value * unit);
            prop_assert_eq!(q.extremes(quantity).least.time, least.time);
            for n in 0..=400 {
                let value = quantity.of(&p.at(p.duration() * f64::from(n) / 400.0));
                prop_assert!(value >= least.value - 16.0 * EPS * size && value <= largest.value + 16.0 * EPS * size);
            }
        }
    }

    #[test]
    fn batch_samples_are_single_samples(
        pieces in prop::collection::vec((0.0..2.0, -5.0..5.0, -5.0..5.0), 1..9),
        times in prop::collection::vec(-1.0..20.0, 0..50),
        sorted in any::<bool>(),
    ) {
        let p = smooth(State::rest(1.0), &pieces);
        let mut times = times;
        if sorted {
            times.sort_by(f64::total_cmp);
        }
        let mut samples = vec![Sample::default(); times.len()];
        p.sample_into(&times, &mut samples)?;
        for (time, sample) in times.iter().zip(samples) {
            prop_assert_eq!(sample, p.at(*time));
        }
    }
}

/// A controller that has the segments and their times plays the same bits, also at the rows of the table.
#[test]
fn a_player_has_the_bits_of_the_table() {
    use closedform_motion::plan::raster_scan::RasterScan;
    use closedform_motion::table::knots;
    use closedform_motion::{Limits, Motion};

    let limits = |acceleration| Limits { velocity: 0.5, acceleration, jerk: 1e4 };
    let scan = RasterScan { tick: Some(1e-4), ..RasterScan::new(0.1, 0.01, 3e-4, 5, limits(20.0), limits(3.0)) };
    let motion: Motion = scan.plan().expect("a plan").motion(5).expect("a motion");
    let mut cursors: Vec<_> = motion.axes().iter().map(|axis| axis.profile.player().cursor()).collect();
    for knot in knots(&motion, 1e-9).expect("rows") {
        for (axis, (cursor, state)) in motion.axes().iter().zip(cursors.iter_mut().zip(&knot.states)) {
            let played = cursor.at(knot.time);
            assert_eq!((played.position, played.velocity), (state.position, state.velocity));
            assert_eq!(axis.profile.player().at(knot.time), played);
            assert_eq!(axis.profile.at(knot.time), played);
        }
    }
}
