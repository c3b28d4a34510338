//! Tables judged by reading them back, and by a cubic Hermite interpolation of their own.

use std::fs;

use closedform_motion::plan::derived_raster::DerivedRaster;
use closedform_motion::table::{
    Heading, TableError, Timing, knots, load, read_csv, read_json, save, write_csv, write_json,
};
use closedform_motion::{Axis, Knot, Limits, Motion, Profile, Segment, State};
use proptest::prelude::*;

fn heading(axes: &[&str], timing: Timing) -> Heading {
    Heading { axes: axes.iter().map(|name| (*name).to_owned()).collect(), timing }
}

fn axis(name: &str, segments: Vec<Segment>) -> Axis {
    Axis { name: name.to_owned(), profile: Profile::new(segments).expect("a profile"), limits: Limits::NONE }
}

/// What a controller does between two rows, and how much rounding may add: the cubic is a sum of four products with
/// weights of at most 1, of which each has at most eight roundings.
fn hermite(from: (f64, State), to: (f64, State), time: f64) -> (f64, f64) {
    let ((t0, a), (t1, b)) = (from, to);
    let (h, s) = (t1 - t0, (time - t0) / (t1 - t0));
    let weights =
        [(1.0 + 2.0 * s) * (1.0 - s).powi(2), s * (1.0 - s).powi(2), s * s * (3.0 - 2.0 * s), s * s * (s - 1.0)];
    let values = [a.position, h * a.velocity, b.position, h * b.velocity];
    let terms: Vec<f64> = weights.iter().zip(values).map(|(weight, value)| weight * value).collect();
    (terms.iter().sum(), 8.0 * f64::EPSILON * values.iter().map(|value| value.abs()).sum::<f64>())
}

/// The largest sum of terms in the polynomials of an axis, for the rounding of its positions: each is a sum of five terms
/// of at most eight roundings, and the time that it is evaluated at is a rounded sum of durations.
fn rounding(motion: &Motion, axis: usize) -> f64 {
    let profile = &motion.axes()[axis].profile;
    let terms = |s: &Segment| {
        let t = s.duration;
        let powers = [1.0, t, t * t / 2.0, t.powi(3) / 6.0, t.powi(4) / 24.0];
        let values = |state: State| [state.position, state.velocity, state.acceleration, s.jerk, s.snap];
        let sum = |state: State| values(state).iter().zip(powers).map(|(a, b)| (a * b).abs()).sum::<f64>();
        sum(s.start).max(sum(s.end))
    };
    let most = profile.segments().iter().map(terms).fold(0.0, f64::max);
    let speed = profile.segments().iter().map(|s| s.start.velocity.abs().max(s.end.velocity.abs())).fold(0.0, f64::max);
    let clock = profile.segments().len() as f64 * f64::EPSILON * motion.duration();
    16.0 * f64::EPSILON * most + 4.0 * speed * clock
}

/// The rows, played, stay within the tolerance of the motion.
fn judge(motion: &Motion, rows: &[Knot], tolerance: f64) {
    for pair in rows.windows(2) {
        for share in [0.0, 0.1, 0.3, 0.5, 0.8, 1.0] {
            let time = pair[0].time + share * (pair[1].time - pair[0].time);
            for (index, axis) in motion.axes().iter().enumerate() {
                let ends = [0, 1].map(|end| (pair[end].time, pair[end].states[index]));
                let (played, rounded) = hermite(ends[0], ends[1], time);
                let off = (played - axis.profile.at(time).position).abs();
                let allowed = tolerance + rounded + rounding(motion, index);
                assert!(off <= allowed, "axis {index} at {time}: off by {off}, allowed {allowed}");
            }
        }
    }
}

/// Segments that follow each other smoothly in position and velocity.
fn segments() -> impl Strategy<Value = Vec<Segment>> {
    let piece = (1e-4..1.0, -50.0..50.0, -1e3..1e3, prop_oneof![Just(0.0), -1e4..1e4]);
    prop::collection::vec(piece, 1..12).prop_map(|pieces| {
        let mut state = State::rest(0.0);
        let next = |(duration, acceleration, jerk, snap): (f64, f64, f64, f64)| {
            let segment = Segment::with_snap(State { acceleration, ..state }, duration, jerk, snap);
            state = segment.end;
            segment
        };
        pieces.into_iter().map(next).collect()
    })
}

/// To rest, so that an axis may end before the others.
fn to_rest(mut segments: Vec<Segment>) -> Vec<Segment> {
    let end = segments[segments.len() - 1].end;
    segments.push(Segment::with_jerk(State { acceleration: -end.velocity, ..end }, 1.0, 0.0));
    let last = segments.len() - 1;
    segments[last].end.velocity = 0.0;
    segments
}

fn bits(rows: &[Knot]) -> Vec<u64> {
    let numbers = |state: &State| [state.position.to_bits(), state.velocity.to_bits()];
    rows.iter().flat_map(|row| std::iter::once(row.time.to_bits()).chain(row.states.iter().flat_map(numbers))).collect()
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |number| number.is_finite())
}

fn rows() -> impl Strategy<Value = Vec<Knot>> {
    let state = (finite(), finite()).prop_map(|(position, velocity)| State::cruise(position, velocity));
    let row = (0.0..1e6, prop::collection::vec(state, 2)).prop_map(|(time, states)| Knot { time, states });
    prop::collection::vec(row, 0..20).prop_map(|mut rows| {
        rows.sort_by(|a, b| a.time.total_cmp(&b.time));
        rows.dedup_by(|a, b| a.time == b.time);
        rows
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn tables_read_back_bit_by_bit(rows in rows()) {
        let heading = heading(&["a, \"b\" 1e5", "µ"], Timing::Absolute);
        let (mut csv, mut json) = (Vec::new(), Vec::new());
        write_csv(&mut csv, &heading, rows.clone()).expect("written");
        write_json(&mut json, &heading, rows.clone()).expect("written");
        for table in [read_csv(csv.as_slice()).expect("read"), read_json(json.as_slice()).expect("read")] {
            prop_assert_eq!(&table.heading, &heading);
            prop_assert_eq!(bits(&table.rows), bits(&rows));
        }
    }

    /// Times come back as sums of durations to half an ulp each, however many there are.
    #[test]
    fn durations_do_not_drift(rows in rows()) {
        let heading = heading(&["a", "b"], Timing::Duration);
        let mut csv = Vec::new();
        write_csv(&mut csv, &heading, rows.clone()).expect("written");
        let table = read_csv(csv.as_slice()).expect("read");
        for (row, read) in rows.iter().zip(&table.rows) {
            prop_assert!((row.time - read.time).abs() <= row.time * f64::EPSILON);
        }
    }

    #[test]
    fn rows_play_the_motion(x in segments(), y in segments(), tolerance in prop_oneof![Just(1e-9), Just(1e-3)]) {
        let motion = Motion::new(vec![axis("x", to_rest(x)), axis("y", to_rest(y))]);
        let rows: Vec<Knot> = knots(&motion, tolerance).expect("rows").collect();
        prop_assert_eq!(rows[0].time, 0.0);
        prop_assert_eq!(rows[rows.len() - 1].time, motion.duration());
        judge(&motion, &rows, tolerance);
    }

    /// Lengths and tolerance, or times, times a power of two: the same rows, scaled.
    #[test]
    fn rows_scale(x in segments(), lengths in -40..40, times in -20..20) {
        let (length, time) = (2.0_f64.powi(lengths), 2.0_f64.powi(times));
        let state = |s: State| State {
            position: s.position * length,
            velocity: s.velocity * length / time,
            acceleration: s.acceleration * length / time / time,
        };
        let scaled = |s: &Segment| Segment {
            duration: s.duration * time,
            start: state(s.start),
            end: state(s.end),
            jerk: s.jerk * length / time.powi(3),
            snap: s.snap * length / time.powi(4),
        };
        let (small, large) = (Motion::new(vec![axis("x", x.clone())]), Motion::new(vec![axis("x", x.iter().map(scaled).collect())]));
        let rows = knots(&small, 1e-6).expect("rows").map(|row| Knot {
            time: row.time * time,
            states: row.states.into_iter().map(state).collect(),
        });
        prop_assert_eq!(rows.collect::<Vec<_>>(), knots(&large, 1e-6 * length).expect("rows").collect::<Vec<_>>());
    }
}

#[test]
fn a_quartic_needs_as_many_rows_as_its_bound_says() {
    // |snap| h^4 / 384 = 1e-6 with snap = 384 and h = 1/32 is 9.5e-7; with h = 1/31 it is 1.08e-6.
    let motion = Motion::new(vec![axis("x", vec![Segment::with_snap(State::rest(0.0), 1.0, 0.0, 384.0)])]);
    let rows: Vec<Knot> = knots(&motion, 1e-6).expect("rows").collect();
    assert_eq!(rows.len(), 33);
    judge(&motion, &rows, 1e-6);
}

#[test]
fn a_raster_streams_into_a_table_and_plays() {
    let plan = DerivedRaster::new(0.1, 50.0, 2e-4, 2.0, 5e-3, 5).plan().expect("a plan");
    let (folder, heading) = (tempfile::tempdir().expect("a folder"), heading(&["fly", "step"], Timing::Absolute));
    for name in ["raster.csv", "raster.json"] {
        let path = folder.path().join(name);
        let rows = save(&path, &heading, plan.knots()).expect("written");
        let table = load(&path).expect("read");
        assert_eq!((rows, table.rows.len() as u64), (plan.knot_count(), plan.knot_count()));
        judge(&plan.motion().expect("a motion"), &table.rows, 0.0);
    }
}

#[test]
fn a_jump_of_velocity_is_refused_unless_it_is_tolerated() {
    let leg = |from: f64, to: f64| Segment {
        start: State::cruise(from, to - from),
        end: State::cruise(to, to - from),
        duration: 1.0,
        jerk: 0.0,
        snap: 0.0,
    };
    let motion = Motion::new(vec![axis("x", vec![leg(0.0, 1.0), leg(1.0, 3.0)])]);
    let error = knots(&motion, 1e-9).expect_err("a jump");
    assert!(error.to_string().starts_with("axis x changes its velocity by 1 m/s at 1 s in no time"), "{error}");
    let rows: Vec<Knot> = knots(&motion, 4.0 / 27.0 + 1e-15).expect("tolerated").collect();
    judge(&motion, &rows, 4.0 / 27.0);
    let ends_early = Motion::new(vec![axis("x", vec![leg(0.0, 1.0)]), axis("y", vec![leg(0.0, 1.0), leg(1.0, 2.0)])]);
    assert!(matches!(knots(&ends_early, 1e-9), Err(TableError::Jump { .. })));
}

#[test]
fn sums_of_durations_that_round_differently_are_one_row() {
    let leg = |state: State, duration: f64| Segment::with_jerk(state, duration, 0.0);
    let chain = |durations: &[f64]| {
        let mut state = State::cruise(0.0, 1.0);
        let segments = durations.iter().map(|duration| {
            let segment = leg(state, *duration);
            state = segment.end;
            segment
        });
        segments.collect::<Vec<_>>()
    };
    let motion = Motion::new(vec![axis("x", chain(&[0.1, 0.2, 0.3])), axis("y", chain(&[0.3, 0.2, 0.1]))]);
    assert_ne!(0.1 + 0.2, 0.3);
    let times: Vec<f64> = knots(&motion, 1e-9).expect("rows").map(|row| row.time).collect();
    assert_eq!(times.len(), 5, "{times:?}");
}

#[test]
fn wrong_rows_are_refused_with_their_place() {
    let heading = heading(&["x"], Timing::Absolute);
    let row = |time: f64, position: f64| Knot { time, states: vec![State::rest(position)] };
    let refuse = |rows: Vec<Knot>| write_csv(Vec::new(), &heading, rows).expect_err("refused").to_string();
    assert!(refuse(vec![row(0.0, 0.0), row(0.0, 1.0)]).starts_with("row 2: its time 0 s"));
    assert!(refuse(vec![row(0.0, f64::NAN)]).starts_with("row 1: x position is NaN"));
    assert!(refuse(vec![row(f64::INFINITY, 0.0)]).starts_with("row 1: time is inf"));
    assert!(refuse(vec![Knot { time: 0.0, states: Vec::new() }]).starts_with("row 1 has 1 columns and the header 3"));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300] {
        let motion = Motion::new(vec![axis("x", vec![Segment::with_snap(State::rest(0.0), 1.0, 0.0, 1.0)])]);
        assert!(matches!(knots(&motion, tolerance), Err(TableError::Tolerance { .. })), "{tolerance}");
    }
}

#[test]
fn wrong_files_are_refused_with_their_place() {
    let csv = |text: &str| read_csv(text.as_bytes()).expect_err("refused").to_string();
    assert!(csv("").starts_with("the header is not that of a PVT table at column 1"));
    assert!(csv("time [ms],x position [m],x velocity [m/s]\n").contains("at column 1, `time [ms]`"));
    assert!(csv("time [s],x position [m]\n").contains("at column 3, ``"));
    assert!(csv("time [s],x position [m],x velocity [mm/s]\n").contains("at column 3"));
    let twice = "time [s],x position [m],x velocity [m/s],x position [m],x velocity [m/s]\n";
    assert!(csv(twice).contains("at column 4"));
    let head = "time [s],x position [m],x velocity [m/s]\n";
    assert_eq!(csv(&format!("{head}0,0,0\n1,a,0\n")), "row 2: x position is `a`: write a number");
    assert!(csv(&format!("{head}0,0\n")).starts_with("row 1 has 2 columns and the header 3"));
    assert!(csv(&format!("{head}0,inf,0\n")).starts_with("row 1: x position is inf"));
    assert!(csv(&format!("{head}1,0,0\n0,0,0\n")).starts_with("row 2: its time 0 s does not come after 1 s"));
    let json = |text: &str| read_json(text.as_bytes()).expect_err("refused").to_string();
    assert!(json("{").starts_with("not a table in JSON"));
    assert!(json("{\"columns\":[],\"rows\":[],\"more\":1}").contains("unknown field"));
    assert!(json("{\"columns\":[],\"rows\":[[]]}").starts_with("the header"));
}

#[test]
fn a_table_that_fails_leaves_what_was_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    fs::write(&path, "mine").expect("written");
    let row = |time: f64| Knot { time, states: vec![State::rest(0.0)] };
    assert!(save(&path, &heading(&["x"], Timing::Absolute), [row(1.0), row(0.0)]).is_err());
    assert_eq!(fs::read_to_string(&path).expect("still there"), "mine");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
    let error =
        save(&folder.path().join("a.txt"), &heading(&["x"], Timing::Absolute), [row(1.0)]).expect_err("no format");
    assert!(error.to_string().ends_with("a table is a file that ends in .csv or .json"));
}

#[test]
fn accelerations_are_those_of_the_cubics() {
    let state = |acceleration| State { position: 0.5, velocity: -1.0, acceleration };
    let motion = Motion::new(vec![axis("x", vec![Segment::with_jerk(state(3.0), 0.5, -48.0)])]);
    let mut csv = Vec::new();
    write_csv(&mut csv, &heading(&["x"], Timing::Absolute), knots(&motion, 1e-9).expect("rows")).expect("written");
    let table = read_csv(csv.as_slice()).expect("read");
    // 48/6 and powers of two: nothing is rounded.
    assert_eq!(table.rows.iter().map(|row| row.states[0].acceleration).collect::<Vec<_>>(), [3.0, -21.0]);
}
