//! What controllers take, read back by readers that know only the manuals: the cubics that they drive are the plan.

mod support;

use closedform_motion::controller::{Buffer, ExportError, Form, Scaling, write};
use closedform_motion::plan::raster_scan::RasterScan;
use closedform_motion::{Knot, Limits, Motion, State};
use serde_json::Value;
use support::Random;

/// A profile as a controller has it: when each segment ends, in s, and position and velocity of every axis there.
struct Driven {
    ends: Vec<(f64, Vec<(f64, f64)>)>,
}

impl Driven {
    /// Where an axis is, on the cubics between the ends.
    fn at(&self, axis: usize, time: f64) -> f64 {
        let index = self.ends.partition_point(|(end, _)| *end < time).clamp(1, self.ends.len() - 1);
        let ((t0, from), (t1, to)) = (&self.ends[index - 1], &self.ends[index]);
        let ((x0, v0), (x1, v1)) = (from[axis], to[axis]);
        let (h, s) = (t1 - t0, (time - t0) / (t1 - t0));
        // by Hermite's four cubics
        let (s2, s3) = (s * s, s * s * s);
        (2.0 * s3 - 3.0 * s2 + 1.0) * x0
            + (s3 - 2.0 * s2 + s) * h * v0
            + (3.0 * s2 - 2.0 * s3) * x1
            + (s3 - s2) * h * v1
    }
}

/// Reads a motion program as the manual says: comments after `;`, `PVT` with the time in ms of what follows, and words of an
/// axis with its end and, after a colon, its velocity there in units a second.
fn read_pmac(text: &str) -> Driven {
    let (mut time, mut segment) = (0.0, f64::NAN);
    let mut ends: Vec<(f64, Vec<(f64, f64)>)> = Vec::new();
    let letters = "XYZABCUVW";
    let mut is_open = false;
    for line in text.lines().map(|line| line.split(';').next().unwrap_or("").trim()).filter(|line| !line.is_empty()) {
        assert!(line.len() < 255, "{line}");
        match line {
            "OPEN PROG 1 CLEAR" => is_open = true,
            "CLOSE" => is_open = false,
            "ABS" | "DWELL0" => assert!(is_open),
            _ if line.starts_with("PVT") => {
                segment = line[3..].parse().expect("a time");
                assert!(segment > 0.0 && segment <= 4095.9998, "{line}");
                assert!(((segment * 4000.0).round() - segment * 4000.0).abs() < 1e-6, "{line}");
            }
            _ => {
                let words = line.strip_prefix("RAPID ").unwrap_or(line);
                assert!(!words.contains(['e', 'E']), "no exponents: {line}");
                let words = words.split(' ');
                let axis = |(index, word): (usize, &str)| {
                    assert_eq!(word.chars().next(), letters.chars().nth(index), "{line}");
                    let mut numbers = word[1..].split(':').map(|number| number.parse::<f64>().expect("a number"));
                    (numbers.next().expect("an end"), numbers.next().unwrap_or(0.0))
                };
                if !line.starts_with("RAPID") {
                    time += segment / 1000.0;
                }
                ends.push((time, words.enumerate().map(axis).collect()));
            }
        }
    }
    assert!(!is_open);
    Driven { ends }
}

/// Reads the arrays: durations in microseconds.
fn read_arrays(text: &str, names: &[String]) -> (Driven, Vec<i64>) {
    let all: Value = serde_json::from_str(text).expect("JSON");
    let floats = |value: &Value| {
        value.as_array().expect("an array").iter().map(|x| x.as_f64().expect("a number")).collect::<Vec<f64>>()
    };
    let positions: Vec<Vec<f64>> = names.iter().map(|name| floats(&all["positions"][name])).collect();
    let velocities: Vec<Vec<f64>> = names.iter().map(|name| floats(&all["velocities"][name])).collect();
    let mut time = 0.0;
    let mut ends = vec![(0.0, floats(&all["start"]).into_iter().map(|x| (x, 0.0)).collect::<Vec<_>>())];
    for (index, duration) in all["durations"].as_array().expect("an array").iter().enumerate() {
        time += duration.as_u64().expect("a whole number") as f64 * 1e-6;
        ends.push((time, (0..names.len()).map(|axis| (positions[axis][index], velocities[axis][index])).collect()));
    }
    let programs =
        all["user_programs"].as_array().expect("an array").iter().map(|x| x.as_i64().expect("a number")).collect();
    (Driven { ends }, programs)
}

fn names() -> Vec<String> {
    vec!["fly".to_owned(), "step".to_owned()]
}

fn text(form: Form, scalings: &[Scaling], buffer: &Buffer, rows: Vec<(Knot, f64)>) -> Result<String, ExportError> {
    let mut out = Vec::new();
    write(&mut out, form, &names(), scalings, buffer, rows)?;
    Ok(String::from_utf8(out).expect("text"))
}

fn scan(tick: f64, velocity: f64) -> RasterScan {
    let limits = |acceleration| Limits { velocity: f64::INFINITY, acceleration, jerk: 1e4 };
    RasterScan {
        tick: Some(tick),
        start: [0.01, -0.02],
        ..RasterScan::new(velocity, 0.05, 1e-3, 4, limits(20.0), limits(5.0))
    }
}

/// That a profile is the motion in counts, at all times.
fn is_driven(driven: &Driven, motion: &Motion, scalings: &[Scaling], what: &str) {
    let duration = driven.ends.last().expect("an end").0;
    assert!((duration - motion.duration()).abs() < 1e-9, "{what}");
    let mut random = Random(1901);
    for _ in 0..3000 {
        let time = duration * random.unit();
        for (axis, scaling) in scalings.iter().enumerate() {
            let right = motion.axes()[axis].profile.at(time).position * scaling.counts + scaling.offset;
            let off = (driven.at(axis, time) - right).abs();
            assert!(off <= 1e-10 * (scaling.counts.abs() + right.abs()), "{what}: axis {axis} at {time}: {off}");
        }
    }
}

#[test]
fn programs_and_arrays_drive_the_plan() {
    let scalings = [Scaling { counts: -2e6, offset: 1234.5 }, Scaling { counts: 1e5, offset: -7.0 }];
    // the slow line takes 10 s, more than a segment may
    for (tick, velocity) in [(1e-3, 0.1), (1e-6, 0.1), (2.5e-4, 5e-3)] {
        let plan = scan(tick, velocity).plan().expect("a plan");
        let motion = plan.motion(4).expect("a motion");
        let rows: Vec<_> = plan.rows().collect();
        let program = text(Form::Pmac, &scalings, &Buffer::default(), rows.clone()).expect("a program");
        is_driven(&read_pmac(&program), &motion, &scalings, "pmac");
        let arrays = text(Form::Arrays, &scalings, &Buffer::default(), rows).expect("arrays");
        let (driven, programs) = read_arrays(&arrays, &names());
        is_driven(&driven, &motion, &scalings, "arrays");
        assert_eq!(programs.last(), Some(&8));
        let windows = programs.split(|program| *program != 1).filter(|window| !window.is_empty()).count();
        assert_eq!(windows, 4, "one window a line: {programs:?}");
    }
}

#[test]
fn what_a_controller_cannot_hold_is_said() {
    let rows: Vec<_> = scan(1e-3, 0.1).plan().expect("a plan").rows().collect();
    let refused =
        |scalings: &[Scaling], buffer| text(Form::Pmac, scalings, &buffer, rows.clone()).expect_err("refused");
    assert!(matches!(refused(&[], Buffer { most: Some(5), shortest: 0.0 }), ExportError::Many { most: 5 }));
    assert!(matches!(refused(&[], Buffer { most: None, shortest: 0.01 }), ExportError::Short { .. }));
    let zero = Scaling { counts: 0.0, offset: 0.0 };
    assert!(matches!(refused(&[zero], Buffer::default()), ExportError::Scalings { .. }));
    assert!(matches!(refused(&[Scaling::METRES; 3], Buffer::default()), ExportError::Scalings { .. }));
    let knot = |time, position| (Knot { time, states: vec![State::rest(position); 2] }, 0.0);
    let close = vec![knot(0.0, 0.0), knot(1e-8, 0.0)];
    assert!(matches!(text(Form::Pmac, &[], &Buffer::default(), close), Err(ExportError::Short { .. })));
    let bad = vec![knot(0.0, 0.0), knot(1.0, f64::NAN)];
    assert!(matches!(text(Form::Arrays, &[], &Buffer::default(), bad), Err(ExportError::NotFinite { .. })));
}
