//! What controllers take, read back by readers that know only the manuals: the cubics that they drive are the plan.

mod support;

use closedform_motion::controller::{
    Buffer, ExportError, Form, Language, Scaling, write, write_constants, write_scan_spec,
};
use closedform_motion::plan::raster_scan::{Order, RasterPlan, RasterScan};
use closedform_motion::{Knot, Limits, Motion, Segment, State};
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

/// Reads a program in ACSPL+: comments after `!`, a move to the start that is waited for, then points of a `PVSPLINE` with
/// times, each with all positions, all velocities and the time in ms of `acsc_AddPVTPointM`, until `ENDS`.
fn read_acs(text: &str, axes: usize) -> Driven {
    let list = format!("({})", (0..axes).map(|axis| axis.to_string()).collect::<Vec<_>>().join(","));
    let (mut time, mut ends) = (0.0, Vec::new());
    let mut said: Vec<&str> = Vec::new();
    for line in text.lines().map(|line| line.split('!').next().unwrap_or("").trim()).filter(|line| !line.is_empty()) {
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        let numbers = rest.strip_prefix(&list).unwrap_or(rest).trim_start_matches(',');
        assert!(rest.is_empty() || rest.starts_with(&list), "{line}");
        assert!(!numbers.contains(['e', 'E']), "no exponents: {line}");
        let numbers: Vec<f64> = numbers
            .split(',')
            .map(str::trim)
            .filter(|text| !text.is_empty())
            .map(|text| text.parse().expect("a number"))
            .collect();
        match word {
            "PTP/e" => {
                assert_eq!(numbers.len(), axes, "{line}");
                ends.push((0.0, numbers.into_iter().map(|position| (position, 0.0)).collect::<Vec<_>>()));
            }
            "POINT" => {
                assert_eq!(said.last(), Some(&"PVSPLINE/t"), "points are of a spline: {line}");
                assert_eq!(numbers.len(), 2 * axes + 1, "{line}");
                assert!(numbers[2 * axes] > 0.0, "{line}");
                time += numbers[2 * axes] / 1000.0;
                ends.push((time, (0..axes).map(|axis| (numbers[axis], numbers[axes + axis])).collect()));
                continue;
            }
            _ => assert!(numbers.is_empty(), "{line}"),
        }
        said.push(word);
    }
    assert_eq!(said, ["PTP/e", "PVSPLINE/t", "ENDS", "STOP"]);
    Driven { ends }
}

/// Reads the process variables, and makes of them what the driver of the XPS does: the velocity at a point is the way of the
/// elements on both sides by their time; at the last one that of the last element.
fn read_epics(text: &str, axes: usize) -> Driven {
    let all: Value = serde_json::from_str(text).expect("JSON");
    let floats = |name: &str| {
        all[name].as_array().expect("an array").iter().map(|x| x.as_f64().expect("a number")).collect::<Vec<f64>>()
    };
    let points = all["NumPoints"].as_u64().expect("a number") as usize;
    let is_said = |name: &str, value: u64| assert_eq!(all[name].as_u64(), Some(value), "{name}");
    is_said("NumAxes", axes as u64);
    is_said("TimeMode", 1);
    is_said("MoveMode", 0);
    let times = floats("Times");
    assert_eq!(times.len(), points);
    assert_eq!(times[points - 1], times[points - 2]);
    let mut ends: Vec<(f64, Vec<(f64, f64)>)> = vec![(0.0, Vec::new())];
    for element in &times[..points - 1] {
        assert!(*element > 0.0);
        ends.push((ends[ends.len() - 1].0 + element, Vec::new()));
    }
    for axis in 1..=axes {
        is_said(&format!("M{axis}UseAxis"), 1);
        let positions = floats(&format!("M{axis}Positions"));
        assert_eq!(positions.len(), points);
        let way = |element: usize| positions[element + 1] - positions[element];
        for point in 0..points {
            let velocity = match point {
                0 => way(0) / times[0],
                _ if point == points - 1 => way(point - 1) / times[point - 1],
                _ => (way(point - 1) + way(point)) / (times[point - 1] + times[point]),
            };
            ends[point].1.push((positions[point], velocity));
        }
    }
    Driven { ends }
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
        let program = text(Form::Acs, &scalings, &Buffer::default(), rows.clone()).expect("a program");
        is_driven(&read_acs(&program, 2), &motion, &scalings, "acs");
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
    assert!(matches!(refused(&[], Buffer { most: Some(5), ..Buffer::default() }), ExportError::Many { most: 5 }));
    assert!(matches!(refused(&[], Buffer { shortest: 0.01, ..Buffer::default() }), ExportError::Short { .. }));
    let zero = Scaling { counts: 0.0, offset: 0.0 };
    assert!(matches!(refused(&[zero], Buffer::default()), ExportError::Scalings { .. }));
    assert!(matches!(refused(&[Scaling::METRES; 3], Buffer::default()), ExportError::Scalings { .. }));
    let divided = Buffer { shortest: 1e-3, longest: Some(1.5e-3), most: None };
    assert!(matches!(refused(&[], divided), ExportError::Longest { least, .. } if least == 2e-3));
    let knot = |time, position| (Knot { time, states: vec![State::rest(position); 2] }, 0.0);
    let close = vec![knot(0.0, 0.0), knot(1e-8, 0.0)];
    assert!(matches!(text(Form::Pmac, &[], &Buffer::default(), close), Err(ExportError::Short { .. })));
    let bad = vec![knot(0.0, 0.0), knot(1.0, f64::NAN)];
    assert!(matches!(text(Form::Arrays, &[], &Buffer::default(), bad), Err(ExportError::NotFinite { .. })));
}

#[test]
fn a_profile_of_positions_comes_closer_with_shorter_elements() {
    let scalings = [Scaling { counts: -2e6, offset: 1234.5 }, Scaling { counts: 1e5, offset: -7.0 }];
    let plan = scan(1e-3, 0.1).plan().expect("a plan");
    let motion = plan.motion(4).expect("a motion");
    for longest in [4e-3, 1e-3, 1e-4] {
        let buffer = Buffer { longest: Some(longest), ..Buffer::default() };
        let profile = text(Form::Epics, &scalings, &buffer, plan.rows().collect()).expect("a profile");
        let driven = read_epics(&profile, 2);
        let elements = driven.ends.windows(2).map(|pair| pair[1].0 - pair[0].0);
        assert!(elements.fold(0.0, f64::max) <= longest * (1.0 + 1e-9));
        let mut random = Random(1902);
        for _ in 0..3000 {
            let time = motion.duration() * random.unit();
            for (axis, (scaling, acceleration)) in scalings.iter().zip([20.0, 5.0]).enumerate() {
                let right = motion.axes()[axis].profile.at(time).position * scaling.counts + scaling.offset;
                let off = (driven.at(axis, time) - right).abs();
                // the mean of two elements is off by the acceleration times the longer one at most, and cubics pass on
                // 4/27 of an element's time of each end's
                let bound = 8.0 / 27.0 * acceleration * longest * longest * scaling.counts.abs();
                assert!(off <= bound + 1e-10 * right.abs(), "axis {axis} at {time}, {longest}: {off}");
            }
        }
    }
}

/// What the pixels of a spec are, by the rules of scanspec: the outer steps, for each all of the inner ones, which go back in
/// every second line of a snake; a pixel reaches half a step to both sides of its middle.
fn read_scan_spec(text: &str) -> (f64, Vec<[f64; 4]>) {
    let all: Value = serde_json::from_str(text).expect("JSON");
    assert_eq!(all["type"], "Fly");
    let timed = &all["spec"];
    assert_eq!(timed["type"], "ConstantDuration");
    let product = &timed["spec"];
    assert_eq!((&product["type"], &product["gap"]), (&Value::from("Product"), &Value::from(true)));
    let number = |value: &Value| value.as_f64().expect("a number");
    let points = |spec: &Value| {
        assert_eq!(spec["type"], "Linspace");
        let (start, stop, count) = (number(&spec["start"]), number(&spec["stop"]), number(&spec["num"]));
        let step = if count > 1.0 { (stop - start) / (count - 1.0) } else { 0.0 };
        ((0..count as usize).map(|index| start + step * index as f64).collect::<Vec<f64>>(), step)
    };
    let is_snake = product["inner"]["type"] == "Snake";
    let (fly, pixel) = points(if is_snake { &product["inner"]["spec"] } else { &product["inner"] });
    let mut pixels = Vec::new();
    for (line, step) in points(&product["outer"]).0.into_iter().enumerate() {
        let is_back = is_snake && line % 2 == 1;
        let half = if is_back { -pixel / 2.0 } else { pixel / 2.0 };
        let order: Vec<f64> = if is_back { fly.iter().rev().copied().collect() } else { fly.clone() };
        pixels.extend(order.into_iter().map(|middle| [middle - half, middle, middle + half, step]));
    }
    (number(&timed["constant_duration"]), pixels)
}

#[test]
fn the_pixels_of_a_scan_spec_are_those_of_the_plan() {
    for order in [Order::Snake, Order::OneWay(None)] {
        let plan = RasterScan { order, ..scan(1e-3, 0.1) }.plan().expect("a plan");
        let (names, mut out) = (RasterPlan::AXES.map(str::to_owned), Vec::new());
        assert_eq!(write_scan_spec(&mut out, &names, &[], &plan, 25).expect("a spec"), 100);
        let (time, pixels) = read_scan_spec(&String::from_utf8(out).expect("text"));
        let motion = plan.motion(4).expect("a motion");
        let triggers: Vec<_> = plan.triggers(25).collect();
        assert_eq!(pixels.len(), triggers.len());
        for ([lower, middle, upper, step], trigger) in pixels.into_iter().zip(triggers) {
            for (at, right) in [(0.0, lower), (0.5, middle), (1.0, upper)] {
                let state = motion.at(trigger.time + at * time).states;
                let off = (state[0].position - right).abs().max((state[1].position - step).abs());
                assert!(off < 1e-14, "{order:?}, {trigger:?}: {off}");
            }
        }
    }
}

/// The numbers of an array between braces or brackets, in order.
fn numbers(text: &str) -> Vec<f64> {
    let is_number = |text: &&str| text.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    let words = text.split(|c: char| c.is_whitespace() || "{}[](),;:".contains(c)).filter(is_number);
    words.map(|word| word.parse().expect("a number")).collect()
}

/// The constants of an axis in either language, read as arrays of nine numbers a segment, and its times.
fn read_constants(text: &str, name: &str) -> (Vec<Segment>, Vec<f64>) {
    let body = |what: &str| {
        let from = text.find(&format!("{name}_{what}")).expect("the array");
        let (_, body) = text[from..].split_once('=').expect("a value");
        body.split_once(';').expect("an end").0.to_owned()
    };
    let state = |x: &[f64]| State { position: x[0], velocity: x[1], acceleration: x[2] };
    let segment =
        |x: &[f64]| Segment { duration: x[0], start: state(&x[1..4]), end: state(&x[4..7]), jerk: x[7], snap: x[8] };
    (numbers(&body("segments")).chunks(9).map(segment).collect(), numbers(&body("times")))
}

#[test]
fn constants_are_the_segments_to_the_bit() {
    let plan = scan(1e-6, 0.1).plan().expect("a plan");
    let motion = plan.motion(4).expect("a motion");
    for language in [Language::Rust, Language::C] {
        let mut out = Vec::new();
        write_constants(&mut out, language, &[], None, &motion).expect("constants");
        let text = String::from_utf8(out).expect("text").to_lowercase();
        for axis in motion.axes() {
            let (segments, times) = read_constants(&text, &axis.name);
            assert_eq!((segments.as_slice(), times.as_slice()), (axis.profile.segments(), axis.profile.times()));
        }
    }
    let refused = write_constants(&mut Vec::new(), Language::C, &[], Some(3), &motion);
    assert!(matches!(refused, Err(ExportError::Many { most: 3 })));
    let mut axes = motion.axes().to_vec();
    axes[0].name = "STEP".to_owned();
    let refused = write_constants(&mut Vec::new(), Language::C, &[], None, &Motion::new(axes));
    assert!(matches!(refused, Err(ExportError::Names { .. })));
}
