//! G-code files: realistic ones by hand, broken ones by their line, and a big one as a stream.

use std::fs::File;
use std::io::{BufReader, Cursor, Read};
use std::path::Path as FilePath;
use std::time::Instant;

use closedform_motion::plan::milling::gcode::{DwellUnit, Event, GcodeError, Notice, Reading, Summary, Unknown};
use closedform_motion::plan::milling::{Feed, Machine, Milling, Model, Path, Row};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

const SKIP: Reading = Reading {
    dialect: None,
    unknown: Unknown::Skip,
    default_feed: None,
    dwell: None,
    block_delete: false,
    start: [0.0; 3],
    home: None,
    parameters: Vec::new(),
    folders: Vec::new(),
    most_repeated: 2_000,
};
const REFUSE: Reading = Reading {
    dialect: None,
    unknown: Unknown::Refuse,
    default_feed: None,
    dwell: None,
    block_delete: false,
    start: [0.0; 3],
    home: None,
    parameters: Vec::new(),
    folders: Vec::new(),
    most_repeated: 2_000,
};

fn milling() -> Milling {
    Milling::new(Machine::default(), Model::ExactStop).unwrap()
}

struct Outcome {
    rows: Vec<Row>,
    notices: Vec<Notice>,
    result: Result<Summary, GcodeError>,
}

fn read(input: impl std::io::BufRead, reading: &Reading) -> Outcome {
    let (mut rows, mut notices) = (Vec::new(), Vec::new());
    let result = milling().gcode(input, reading, |event| match event {
        Event::Row(row) => rows.push(*row),
        Event::Notice(notice) => notices.push(notice.clone()),
        Event::Progress(_) | Event::Dialect(_) | Event::Dwell(_) => {}
    });
    Outcome { rows, notices, result }
}

fn text(text: &str, reading: &Reading) -> Outcome {
    read(text.as_bytes(), reading)
}

fn file(name: &str, reading: &Reading) -> Outcome {
    let path = FilePath::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    read(BufReader::new(File::open(path).unwrap()), reading)
}

fn ends(rows: &[Row]) -> Vec<[f64; 3]> {
    rows.iter().map(|row| row.cut.to).collect()
}

fn near(found: f64, expected: f64) {
    // A few roundings of lengths and speeds in other units.
    assert!((found - expected).abs() <= 16.0 * f64::EPSILON * expected.abs(), "{found} {expected}");
}

#[test]
fn a_pocket() {
    let Outcome { rows, notices, result } = file("pocket.nc", &REFUSE);
    let summary = result.unwrap();
    assert_eq!(notices, []);
    let lines: Vec<u64> = rows.iter().map(|row| row.cut.line).collect();
    assert_eq!(lines, [10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 26]);
    assert_eq!((summary.moves, summary.dwell_time, summary.lines), (16, 0.5, 29));
    // Each move starts where the one before ends.
    assert!(rows.windows(2).all(|pair| pair[0].cut.to == pair[1].cut.from && pair[0].total < pair[1].total));
    assert_eq!(rows[15].cut.to, [20.0, 15.0, 15.0]);
    // Pocket and plunge: 34, 14, 34, 14 mm at 900 mm/min, 7 mm at 200 mm/min.
    let lengths: Vec<f64> = rows[3..8].iter().map(|row| row.length).collect();
    assert_eq!(lengths, [7.0, 34.0, 14.0, 34.0, 14.0]);
    assert_eq!(rows[4].feed, 15.0);
    near(rows[4].time, 34.0 / 15.0 + 15.0 / 500.0);
    near(rows[3].feed, 200.0 / 60.0);
    // The whole circle, half a circle by its radius, and a helix of half a turn.
    near(rows[11].length, 10.0 * std::f64::consts::PI);
    near(rows[12].length, 5.0 * std::f64::consts::PI);
    near(rows[14].length, (2.5 * std::f64::consts::PI).hypot(2.0));
    assert!(matches!(rows[12].cut.path, Path::Arc(arc) if arc.axis == 2));
    near(summary.cutting_time + summary.rapid_time + summary.dwell_time, summary.time);
    near(rows[15].total, summary.time);
}

#[test]
fn inches_and_modal_lines() {
    let Outcome { rows, notices, result } = file("engrave.ngc", &REFUSE);
    let summary = result.unwrap();
    assert_eq!((notices.len(), summary.moves), (0, 13));
    let inch = |x: f64, y: f64, z: f64| [x * 25.4, y * 25.4, z * 25.4];
    let expected = [
        inch(0.0, 0.0, 0.25),
        inch(0.0, 0.0, 0.25),
        inch(0.0, 0.0, -0.01),
        inch(1.0, 0.0, -0.01),
        inch(1.0, 1.0, -0.01),
        inch(0.0, 0.0, -0.01),
        inch(0.0, 0.0, 0.25),
        inch(0.5, 0.5, 0.25),
        inch(0.5, 0.5, -0.01),
        inch(0.75, 0.5, -0.01),
        inch(0.75, 0.75, -0.01),
        inch(0.5, 0.5, -0.01),
        inch(0.5, 0.5, 1.0),
    ];
    for (found, expected) in ends(&rows).iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
    }
    near(rows[2].feed, 10.0 * 25.4 / 60.0);
    near(rows[3].feed, 20.0 * 25.4 / 60.0);
    // The move after G91 goes on with G0, the one after is at the feed of before.
    assert_eq!((rows[7].cut.feed, rows[8].cut.feed), (Feed::Rapid, rows[3].cut.feed));
}

#[test]
fn canned_cycles_drill() {
    let Outcome { rows, notices, result } = file("drill.nc", &REFUSE);
    let summary = result.unwrap();
    // Three holes, each down at feed; the way home is told, since nobody said where that is.
    let holes: Vec<f64> = rows.iter().filter(|row| !row.cut.feed.is_rapid()).map(|row| row.length).collect();
    assert_eq!((holes, summary.notices), (vec![7.0; 3], 1));
    assert!(notices[0].to_string().starts_with("line 10: where home is, no file says"), "{}", notices[0]);
    let home = Reading { home: Some([0.0, 0.0, 50.0]), ..REFUSE };
    let Outcome { notices, rows, .. } = file("drill.nc", &home);
    assert_eq!((notices.len(), rows[rows.len() - 2].cut.to[2]), (0, 50.0));
}

#[test]
fn old_encodings_and_line_ends() {
    let Outcome { rows, result, .. } = file("latin1.nc", &REFUSE);
    assert_eq!(ends(&rows), [[10.0, 0.0, 0.0], [10.0, 10.0, 0.0]]);
    assert_eq!((rows[1].cut.line, rows[1].feed), (4, 5.0));
    assert!(result.is_ok());
    assert_eq!(text("\u{feff}G0 X1\n", &REFUSE).rows.len(), 1);
    // No line end after the last line.
    assert_eq!(text("G0 X1\nX2", &REFUSE).rows.len(), 2);
}

#[test]
fn a_laser() {
    let Outcome { rows, notices, result } = file("laser.gcode", &REFUSE);
    assert_eq!((notices.len(), result.unwrap().moves), (0, 7));
    // The line with a slash counts, unless the switch is on; F of a rapid move is not its speed.
    assert_eq!(rows[1].cut.to, [100.0, 0.0, 0.0]);
    assert_eq!((rows[0].time, rows[2].feed), (0.0, 10.0));
    // After G92 the tool is at the new origin; rows say where it is in the machine.
    assert_eq!((rows[5].cut.from, rows[5].length), (rows[4].cut.to, 1.0));
    near(rows[5].cut.to[0], rows[4].cut.to[0] + 1.0);
    let without = file("laser.gcode", &Reading { block_delete: true, ..REFUSE });
    assert_eq!(without.rows.len(), 6);
}

#[test]
fn what_a_block_sets_applies_to_all_of_it() {
    // Order of words does not matter.
    for line in ["G20 G1 X1 F60", "X1 F60 G1 G20", "F60 X1 G20 M8 G1", "N7 g1x1(in between)f60 g20 ; end"] {
        let read = text(line, &REFUSE);
        assert_eq!(ends(&read.rows), [[25.4, 0.0, 0.0]], "{line}");
        near(read.rows[0].feed, 25.4);
    }
    // A feed stays what it is when the unit changes.
    let read = text("G21 G1 X1 F600\nG20\nX2", &REFUSE);
    assert_eq!((read.rows[1].feed, read.rows[1].cut.to), (10.0, [50.8, 0.0, 0.0]));
    // Spaces between letter, sign and number, signs, points without digits.
    assert_eq!(ends(&text("G0 X - 1 Y+2. Z.5", &REFUSE).rows), [[-1.0, 2.0, 0.5]]);
    // Numbers are read in full, not as the parser's f32.
    assert_eq!(ends(&text("G0 X123.456789 Y-0.1", &REFUSE).rows), [[123.456789, -0.1, 0.0]]);
    // Axes do not move that are not named; a start may be given.
    let start = Reading { start: [1.0, 2.0, 3.0], ..REFUSE };
    assert_eq!(ends(&text("G0 Y5\nG91 Y-1", &start).rows), [[1.0, 5.0, 3.0], [1.0, 4.0, 3.0]]);
}

#[test]
fn arcs_by_centre_and_radius() {
    let length = |program: &str| text(program, &Reading { default_feed: Some(10.0), ..REFUSE }).rows[0].length;
    use std::f64::consts::PI;
    for (program, expected) in [
        // Quarter, three quarters, whole circle, about the centre 10, 0.
        ("G3 X10 Y-10 I10 J0", 5.0 * PI),
        ("G2 X10 Y-10 I10 J0", 15.0 * PI),
        ("G2 I10", 20.0 * PI),
        ("G3 X0 Y0 I10", 20.0 * PI),
        ("G90.1 G3 X10 Y-10 I10 J0", 5.0 * PI),
        // By radius: a small and a large arc.
        ("G2 X10 Y10 R10", 5.0 * PI),
        ("G3 X10 Y10 R-10", 15.0 * PI),
        ("G3 X20 R10", 10.0 * PI),
        // Other planes, each seen from the positive end of its third axis: Z to X about Y, Y to Z about X.
        ("G18 G2 X10 Z10 I0 K10", 5.0 * PI),
        ("G18 G3 X10 Z10 I0 K10", 15.0 * PI),
        ("G19 G3 Y10 Z10 J0 K10", 5.0 * PI),
        ("G19 G3 X4 Y10 Z10 J0 K10", (5.0 * PI).hypot(4.0)),
        ("G20 G3 X1 Y-1 I1 J0", 25.4 * PI / 2.0),
    ] {
        near(length(program), expected);
    }
}

#[test]
fn dwells() {
    let milliseconds = Reading { dwell: Some(DwellUnit::Milliseconds), ..REFUSE };
    for (program, reading, expected) in [
        ("G0 X1\nG4 P1.5", REFUSE, 1.5),
        ("G0 X1\nG4 P500", milliseconds.clone(), 0.5),
        ("G0 X1\nG4 S2", milliseconds, 2.0),
        ("G0 X1\nG04 X2.5", REFUSE, 2.5),
    ] {
        let read = text(program, &reading);
        let summary = read.result.unwrap();
        assert_eq!((summary.dwell_time, summary.moves), (expected, 1));
        near(summary.time, read.rows[0].time + expected);
    }
}

#[test]
fn broken_lines_are_named() {
    let refused = "is not supported: remove it, or pass such lines over";
    let unreadable = "is not G-code that can be read: correct it";
    let spaced = "which controllers take for a word E: write the number with all its digits";
    let cases = [
        ("G1 X1 F100\nG1 X", 2, format!("`X` {unreadable}")),
        ("G0 X1\n\n\nX1 X2", 4, "X stands twice in one line: split the line".into()),
        ("G0 X1..2", 1, format!("`X1..2` {unreadable}")),
        ("G0 X1.2.3", 1, format!("`X1.2.3` {unreadable}")),
        ("G0 X1e5", 1, format!("`X1e5` has an exponent, {spaced}")),
        ("G1 Z-2.7755598776686065e-17 F9", 1, format!("`Z-2.7755598776686065e-17` has an exponent, {spaced}")),
        ("G0 X#<no>", 1, "#<no> has no value: set it before, or define it".into()),
        ("#1=[2", 1, "the expression has no end: close it with ]".into()),
        ("#1=[2/0]", 1, "the expression divides by 0: correct it".into()),
        ("G0 G1 X1 F1", 1, "a motion code (G0 to G3) stands twice in one line: split the line".into()),
        ("hello world", 1, format!("`HELLOWORLD` {unreadable}")),
        ("(no end\nG0 X1", 1, "the comment `(no end` has no end: close it with `)`".into()),
        ("G5.10.1 X1", 1, format!("`G5.10.1` {unreadable}")),
        ("G99999999999 X1", 1, format!("`G99999999999` {unreadable}")),
        ("M4294967296", 1, format!("`M4294967296` {unreadable}")),
        ("G71 P1", 1, format!("G71 {refused}")),
        ("G999", 1, format!("G999 {refused}")),
        ("G80\nX1", 2, "coordinates, but no G0, G1, G2 or G3 is in force: give one".into()),
        ("G1 X1 F0", 1, "the feed F is 0: make it positive".into()),
        ("G1 X1 F-100", 1, "the feed F is -100: make it positive".into()),
        ("G95 G1 X1 F2", 1, "a feed per turn (G95) or a thread, but the spindle has no speed: give S before it".into()),
        ("G4", 1, "G4 needs its time, P or S, and not a negative one: give it".into()),
        ("G4 P-1", 1, "G4 needs its time, P or S, and not a negative one: give it".into()),
        ("F100 G2 X1", 1, "the arc has neither centre nor radius: give I, J, K of its plane, or R".into()),
        ("F100 G2 X1 I5", 1, "the arc ends at another distance from its centre than it starts: correct I, J, K".into()),
        ("F100 G2 X1 I0", 1, "the arc starts at its own centre: correct I, J, K".into()),
        ("F100 G2 X10 R4", 1, "the arc has a radius that is less than half the distance of its ends: correct R".into()),
        ("F100 G2 X0 R4", 1, "the arc ends where it starts, which with R has no one centre: give I, J, K".into()),
        ("F100 G2 X1 I1 R4", 1, "the arc has a radius and a centre: give one of them".into()),
        (
            "F100 G2 X2 I1 P1.5",
            1,
            "the arc has a number of turns (P) that is not whole and positive: correct it".into(),
        ),
        ("G81 X1 Z-1 F9", 1, "G81 needs the height over the work piece: give R".into()),
        ("G83 X1 Z-1 R1 Q0 F9", 1, "G83 needs the depth of a peck: give a positive Q".into()),
        ("N3 T0*58", 1, "the checksum is 58, and that of the line is 57: the line is damaged, correct it".into()),
        ("o1 call", 1, "there is no sub-program O1: put it into the file, or beside it".into()),
        ("G0 X1\no1 while [1]\nG0 X2", 2, "O1 has no end: give it".into()),
        ("o1 endwhile", 1, "O1 is no loop that is under way: correct its number".into()),
        ("G0 X1\rG0 X2\r", 1, "a carriage return inside the line: save the file with line ends LF or CRLF".into()),
    ];
    for (program, line, message) in cases {
        let error = text(program, &REFUSE).result.expect_err(program);
        assert_eq!(error.to_string(), format!("line {line}: {message}"), "{program:?}");
    }
}

#[test]
fn what_makes_times_wrong_is_never_passed_over() {
    for program in ["G1 X1 F0", "G95 G1 X1 F2", "G0 X1\rX2"] {
        assert!(text(program, &SKIP).result.is_err(), "{program}");
    }
    let feed = Reading { default_feed: Some(5.0), ..REFUSE };
    assert_eq!(text("G1 X1", &feed).rows[0].feed, 5.0);
    for bad in [0.0, -1.0, f64::NAN] {
        let feed = Reading { default_feed: Some(bad), ..REFUSE };
        let message = format!("default feed is {bad}: make it positive");
        assert_eq!(text("G1 X1", &feed).result.unwrap_err().to_string(), message);
    }
}

#[test]
fn what_is_not_known_is_told_and_counts_the_least() {
    for (program, told) in [
        ("G1 X100", "line 1: a cut, but no feed is in force: it counts as fast as the machine goes"),
        ("X100", "line 1: coordinates before the first G0, G1, G2 or G3: they count as a rapid move (G0)"),
        ("G0 X100\nM0", "line 2: M0 takes a time that nobody knows"),
        ("G0 X100\nM98 P7", "line 2: there is no sub-program O7 in the file or beside it: it counts 0 s"),
        ("G0 X100 I5", "line 1: I does nothing in this line"),
        ("G0 X100\nG41 D1", "line 2: G41: the path is timed without the compensation of the cutter"),
    ] {
        let Outcome { notices, result, .. } = text(program, &REFUSE);
        let summary = result.unwrap();
        assert_eq!((summary.notices, notices.len()), (1, 1), "{program}");
        assert!(notices[0].to_string().starts_with(told), "{program}: {}", notices[0]);
        near(summary.time, 1.2);
    }
}

#[test]
fn no_code_is_an_error() {
    for (program, lines) in [("", 0), ("\n\n", 2), ("%\n\n%\n", 3)] {
        let message = format!("no G-code in {lines} lines: this is not the right file");
        assert_eq!(text(program, &REFUSE).result.unwrap_err().to_string(), message, "{program:?}");
    }
    // What has codes or comments and no moves takes no time.
    for program in ["(only words)\n%\nG21\n", "G21\nM30\nG0 X1", "o<x> sub\nG0 X1\no<x> endsub\nM2"] {
        let summary = text(program, &REFUSE).result.unwrap();
        assert_eq!((summary.moves, summary.time), (0, 0.0), "{program:?}");
    }
    let long = "G0 X1 (".to_owned() + &"x".repeat(2 << 20) + ")";
    let message = text(&long, &SKIP).result.unwrap_err().to_string();
    assert_eq!(message, "line 1: the line has more than 1048576 bytes: this is not G-code, or its line ends are lost");
    struct Broken;
    impl Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("unplugged"))
        }
    }
    let input = BufReader::new(Cursor::new("G0 X1\n").chain(Broken));
    assert_eq!(read(input, &REFUSE).result.unwrap_err().to_string(), "line 2 cannot be read: unplugged");
}

#[test]
fn passed_over_lines_still_set_modes() {
    // The codes of a line that are known count, its move does not; an unreadable line does not count at all.
    let Outcome { rows, notices, .. } = text("G0 X1\nG91 G999 X5\nX1\nG90 X..2\nX1", &SKIP);
    assert_eq!(ends(&rows), [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]]);
    assert_eq!(notices.len(), 2);
    // A broken arc is passed over, and the tool is at its end.
    let Outcome { rows, .. } = text("G0 X1\nG2 X9 Y9 I1 F100\nG1 X9 Y10", &SKIP);
    assert_eq!((rows[1].cut.from, rows[1].length), ([9.0, 9.0, 0.0], 1.0));
}

/// A program that is made while it is read.
struct Endless {
    line: u64,
    lines: u64,
    rest: Cursor<Vec<u8>>,
}

impl Read for Endless {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if self.rest.position() == self.rest.get_ref().len() as u64 && self.line < self.lines {
            let (x, y) = (self.line % 100, self.line / 7 % 100);
            let word = if self.line == 0 { "G21 G1 F1200 " } else { "" };
            self.rest = Cursor::new(format!("{word}X{x}.{y:03} Y{y}.5\n").into_bytes());
            self.line += 1;
        }
        self.rest.read(buffer)
    }
}

#[test]
fn a_million_moves_stream_in_seconds() {
    let input = BufReader::new(Endless { line: 0, lines: 1_000_000, rest: Cursor::default() });
    let milling = Milling::new(Machine::default(), Model::default()).unwrap();
    let (mut rows, mut last, mut reports) = (0_u64, 0, 0);
    let begin = Instant::now();
    let summary = milling
        .gcode(input, &REFUSE, |event| match event {
            Event::Row(_) => rows += 1,
            Event::Notice(notice) => panic!("{notice}"),
            Event::Dialect(_) | Event::Dwell(_) => {}
            Event::Progress(progress) => {
                assert!(progress.lines >= last && progress.moves == rows && progress.bytes > progress.lines);
                (last, reports) = (progress.lines, reports + 1);
            }
        })
        .unwrap();
    assert_eq!((rows, summary.moves, last), (1_000_000, 1_000_000, 1_000_000));
    assert!(reports > 200);
    let seconds = begin.elapsed().as_secs_f64();
    println!("{seconds} s for {} s of milling", summary.time);
    // About one second on one core; a loaded machine may be slow, a quadratic reader would take hours.
    assert!(seconds < 60.0, "{seconds}");
}

#[test]
fn no_bytes_make_it_panic() {
    let mut runner = TestRunner::new_with_rng(
        Config { cases: 20_000, failure_persistence: None, ..Config::default() },
        TestRng::deterministic_rng(RngAlgorithm::ChaCha),
    );
    let word = "[GMTNOXYZIJKRFPSEAgx%/;()#* .+-]{0,2} ?[+-]?[0-9]{0,10}[.]?[0-9]{0,3}";
    let line = prop::collection::vec(word, 0..6).prop_map(|words| words.join(" "));
    let program = prop::collection::vec(line, 0..6).prop_map(|lines| lines.join("\n"));
    runner
        .run(&(program, prop::collection::vec(any::<u8>(), 0..60)), |(program, bytes)| {
            for input in [program.as_bytes(), &bytes] {
                for reading in [SKIP, REFUSE] {
                    let Outcome { rows, result, .. } = read(input, &reading);
                    if let Ok(summary) = result {
                        prop_assert!(summary.time.is_finite() && summary.time >= 0.0);
                        prop_assert_eq!(summary.moves, rows.len() as u64);
                    }
                }
            }
            Ok(())
        })
        .unwrap();
}
