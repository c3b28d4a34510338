//! The language of G-code: variables, statements, sub-programs, cycles, offsets, and what each dialect has of its own.

use closedform_motion::plan::milling::gcode::{Dialect, Event, GcodeError, Reading, Summary};
use closedform_motion::plan::milling::{Machine, Milling, Model, Row};

/// Rows of a program, each from rest to rest with 500 mm/s², and what is said at the end.
fn run(program: &str, reading: &Reading) -> (Vec<Row>, Result<Summary, GcodeError>) {
    let milling = Milling::new(Machine::default(), Model::ExactStop).expect("a machine");
    let mut rows = Vec::new();
    let result = milling.gcode(program.as_bytes(), reading, |event| {
        if let Event::Row(row) = event {
            rows.push(*row);
        }
    });
    (rows, result)
}

fn of(dialect: Dialect) -> Reading {
    Reading { dialect: Some(dialect), ..Reading::default() }
}

/// Where the moves end, in the machine.
fn ends(program: &str, reading: &Reading) -> Vec<[f64; 3]> {
    let (rows, result) = run(program, reading);
    result.unwrap_or_else(|error| panic!("{program}: {error}"));
    rows.iter().map(|row| row.cut.to).collect()
}

/// X of the ends.
fn xs(program: &str) -> Vec<f64> {
    ends(program, &Reading::default()).iter().map(|end| end[0]).collect()
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{found} {expected}");
}

/// A time in s, from rest to rest: the way at its speed and the time to reach it, once.
fn time(length: f64, speed: f64) -> f64 {
    length / speed + speed / 500.0
}

#[test]
fn variables_have_values() {
    assert_eq!(xs("#1=5 #<a>=[#1*2]\nG0 X#1\nX#<a>\n#1=[#1+1] X#1\nX#1"), [5.0, 0.0, 5.0, 6.0]);
    // A value counts from the next line on.
    assert_eq!(xs("#<a>=1\nG0 X[#<a>+1]\n#<a>=7\nX#<A>"), [2.0, 7.0]);
    assert_eq!(xs("G0 X3\nX[#5420+1]\nX[#<_x>*2]"), [3.0, 4.0, 8.0]);
    let given = Reading { parameters: vec![("depth".into(), 4.0), ("100".into(), 2.0)], ..Reading::default() };
    assert_eq!(ends("G0 X[#<depth>*#100]", &given), [[8.0, 0.0, 0.0]]);
}

#[test]
fn loops_and_conditions() {
    let cases: [(&str, &[f64]); 9] = [
        ("#1=0\nG91\no1 while [#1 lt 3]\n#1=[#1+1]\nG0 X1\no1 endwhile\nG0 X10", &[1.0, 2.0, 3.0, 13.0]),
        ("#1=0\no1 do\n#1=[#1+1]\nG0 X#1\no1 while [#1 lt 2]\nG0 X9", &[1.0, 2.0, 9.0]),
        ("G91\no1 repeat [3]\nG0 X2\no1 endrepeat", &[2.0, 4.0, 6.0]),
        ("o1 repeat [0]\nG0 X2\no1 endrepeat\nG0 X1", &[1.0]),
        ("o1 if [1 gt 2]\nG0 X1\no1 elseif [2 gt 1]\nG0 X2\no1 else\nG0 X3\no1 endif\nG0 X4", &[2.0, 4.0]),
        ("o1 if [1 gt 2]\nG0 X1\no1 else\no2 if [1]\nG0 X3\no2 endif\no1 endif", &[3.0]),
        (
            "#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 eq 3]\no1 break\no2 endif\nG0 X#1\no1 endwhile\nG0 X9",
            &[1.0, 2.0, 9.0],
        ),
        (
            "#1=0\no1 while [#1 lt 4]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\nG0 X#1\no1 endwhile",
            &[1.0, 3.0, 4.0],
        ),
        ("G91\no1 repeat [2]\no2 repeat [2]\nG0 X1\no2 endrepeat\no1 endrepeat", &[1.0, 2.0, 3.0, 4.0]),
    ];
    for (program, expected) in cases {
        assert_eq!(xs(program), expected, "{program}");
    }
}

#[test]
fn sub_programs() {
    let cases: [(&str, &[f64]); 8] = [
        ("o1 sub\nG0 X#1\no1 endsub\no1 call [5]\no1 call [7]", &[5.0, 7.0]),
        // Numbers up to 30 and names belong to a call, others to all.
        ("#1=3 #40=9\no<f> sub\n#1=8\n#40=#1\no<f> endsub\no<f> call [1]\nG0 X#1\nX#40", &[3.0, 8.0]),
        (
            "o<f> sub\no1 if [#1 gt 2]\no<f> return [#1*2]\no1 endif\no<f> endsub [0]\no<f> call [3]\nG0 X#<_value>",
            &[6.0],
        ),
        // Called before it stands in the file, behind the end of the main program.
        ("o1 call [4]\nM2\no1 sub\nG0 X#1\no1 endsub", &[4.0]),
        ("G91\nM98 P1000 L3\nG90 G0 X9\nM30\nO1000\nG0 X1\nM99", &[1.0, 2.0, 3.0, 9.0]),
        ("#<n>=2\no1 sub\nG0 X1\no1 endsub\no2 sub\nG0 X2\no2 endsub\no#<n> call\no[#<n>-1] call", &[2.0, 1.0]),
        // One that calls another, in a loop.
        ("o2 sub\nG91 G0 X1\no2 endsub\no1 sub\no3 repeat [2]\no2 call\no3 endrepeat\no1 endsub\no1 call", &[1.0, 2.0]),
        // A numbered main program ends where the next one begins.
        ("O1\nM98 P2\nG0 X2\nO2\nG0 X1\nM99", &[1.0, 2.0]),
    ];
    for (program, expected) in cases {
        assert_eq!(xs(program), expected, "{program}");
    }
}

#[test]
fn a_sub_program_in_a_file_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("corner.ngc"), "o<corner> sub\nG0 X#1\no<corner> endsub\n").expect("written");
    std::fs::write(folder.path().join("O0007.nc"), "G0 X70\nM99\n").expect("written");
    let reading = Reading { folders: vec![folder.path().to_path_buf()], ..Reading::default() };
    let found = ends("o<corner> call [3]\nM98 P7", &reading);
    assert_eq!(found, [[3.0, 0.0, 0.0], [70.0, 0.0, 0.0]]);
    let (_, result) = run("o<../corner> call [3]", &reading);
    assert!(result.is_err(), "a name leads out of the folder");
}

#[test]
fn what_never_ends_is_told() {
    let few = Reading { most_repeated: 10_000, ..Reading::default() };
    for program in [
        "o1 while [1]\nG0 X1\no1 endwhile",
        "o1 do\no1 while [1]",
        "o1 repeat [1000000000000]\nG0 X1\no1 endrepeat",
        "M98 P1 L1000000000\nM30\nO1\nM99",
        "o1 sub\no1 call\no1 endsub\no1 call",
    ] {
        let (_, result) = run(program, &few);
        let message = result.expect_err(program).to_string();
        assert!(
            message.contains("more than") && message.contains("without end") || message.contains("never ends"),
            "{message}"
        );
    }
    // A million calls are none.
    let (rows, result) =
        run("o1 sub\nG91 G0 X0.001\no1 endsub\no2 repeat [1000000]\no1 call\no2 endrepeat", &Reading::default());
    assert_eq!((rows.len(), result.expect("timed").moves), (1_000_000, 1_000_000));
}

#[test]
fn macros_of_fanuc() {
    let fanuc = of(Dialect::Fanuc);
    let xs = |program: &str| ends(program, &fanuc).iter().map(|end| end[0]).collect::<Vec<f64>>();
    let cases: [(&str, &[f64]); 8] = [
        ("#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nG0 X#1\nEND1\nG0 X9", &[1.0, 2.0, 3.0, 9.0]),
        ("#1=0\nN10 #1=[#1+1]\nG0 X#1\nIF [#1 LT 3] GOTO 10\nG0 X9", &[1.0, 2.0, 3.0, 9.0]),
        ("GOTO 20\nG0 X1\nN20 G0 X2", &[2.0]),
        ("IF [1 EQ 1] THEN #100=5\nIF [1 EQ 2] THEN #100=6\nG0 X#100", &[5.0]),
        ("G65 P9000 A4 B5\nM30\nO9000\nG0 X#1\nX#2\nM99", &[4.0, 5.0]),
        ("G91\nM98 P31000\nM30\nO1000\nG0 X1\nM99", &[1.0, 2.0, 3.0]),
        ("O1 (PART)\nG28 U0 W0\nG0 X1", &[0.0, 0.0, 1.0]),
        ("N1 G0 X1\nM30\nN2 G0 X2", &[1.0]),
    ];
    for (program, expected) in cases {
        let program = program.replace("#1=#1+1", "#1=[#1+1]");
        assert_eq!(xs(&program), expected, "{program}");
    }
    // P is in milliseconds, with a point in seconds; X in seconds.
    let dwell = |program: &str| run(program, &fanuc).1.expect("timed").dwell_time;
    assert_eq!([dwell("G4 P500"), dwell("G4 P1.5"), dwell("G4 X2."), dwell("G4 U3")], [0.5, 1.5, 2.0, 3.0]);
}

#[test]
fn free_text_is_no_code() {
    for program in ["M117 X50", "M117 F1", "M117 M2", "M117 G1 X30 ; (", "M118 hi (", "N7 M117 Printing X10 #1 ["] {
        for dialect in [Dialect::LinuxCnc, Dialect::Grbl, Dialect::Marlin, Dialect::Klipper] {
            let (rows, result) = run(&format!("G1 X10 F600\n{program}\nX20"), &of(dialect));
            assert_eq!((rows.len(), rows[1].cut.to[0], rows[1].feed), (2, 20.0, 10.0), "{program}");
            assert_eq!(result.expect("timed").notices, 0);
        }
    }
    for program in ["M862.3 P \"MK3S X9\"", "M0 Click X50", "M23 file.g", "M486 AX50"] {
        assert_eq!(run(&format!("G1 X10 F600\n{program}\nX20"), &of(Dialect::Marlin)).0.len(), 2, "{program}");
    }
}

#[test]
fn printers() {
    let marlin = of(Dialect::Marlin);
    let total = |program: &str| run(program, &marlin).1.expect("timed").time;
    near(total("M83\nG1 X10 F600\nG1 E-5 F300\nG1 X20 F600"), 2.0 * time(10.0, 10.0) + time(5.0, 5.0));
    near(total("G0 X100 F600"), time(100.0, 10.0));
    near(total("G28\nG92 E0\nG1 X10 E1 F600\nG1 X20 E2"), 2.0 * time(10.0, 10.0));
    let line = "N1 G1 X10 F600";
    let sum = line.bytes().fold(0, |sum, byte| sum ^ byte);
    near(total(&format!("{line}*{sum}\n")), time(10.0, 10.0));
    near(total("G28 X Y\nG4 P1500"), 1.5);
    near(total("G4 S2"), 2.0);
    let klipper = run("START_PRINT BED=60 X=50\nG1 X10 F600\nSET_VELOCITY_LIMIT ACCEL=100", &of(Dialect::Klipper));
    assert_eq!((klipper.0.len(), klipper.1.expect("timed").notices), (1, 1));
    // After homing the axes are at 0.
    assert_eq!(ends("G1 X10 F600\nG28 X\nG1 Y1", &marlin)[1], [0.0, 1.0, 0.0]);
}

#[test]
fn a_dwell_comes_before_the_motion_of_its_block() {
    // The block moves too: 10 mm and back and again, and a second of rest.
    let (rows, result) = run("G1 F600\nX10 G4 P1\nX0\nX10", &Reading::default());
    assert_eq!(rows.iter().map(|row| row.length).collect::<Vec<f64>>(), [10.0; 3]);
    near(rows[0].total - rows[0].time, 1.0);
    near(result.expect("timed").time, 1.0 + 3.0 * time(10.0, 10.0));
}

#[test]
fn cycles() {
    let z = |program: &str| ends(program, &Reading::default()).iter().map(|end| end[2]).collect::<Vec<f64>>();
    // From 10: over the hole, to R, down, back to where it began, or to R.
    assert_eq!(z("G0 Z10\nG98 G81 X5 Y5 Z-3 R2 F100\nX9"), [10.0, 10.0, 2.0, -3.0, 10.0, 10.0, 2.0, -3.0, 10.0]);
    assert_eq!(z("G0 Z10\nG99 G81 X5 Y5 Z-3 R2 F100\nX9\nG80"), [10.0, 10.0, 2.0, -3.0, 2.0, 2.0, -3.0, 2.0]);
    // Pecks of 2: 0, -2, -3, each out to R and down again to a hundredth of an inch above.
    assert_eq!(
        z("G0 Z10\nG99 G83 X5 Z-3 R2 Q2 F100"),
        [10.0, 10.0, 2.0, 0.0, 2.0, 0.254, -2.0, 2.0, -1.746, -3.0, 2.0]
    );
    assert_eq!(z("G0 Z10\nG99 G73 X5 Z-1 R2 Q2 F100"), [10.0, 10.0, 2.0, 0.0, 0.254, -1.0, 2.0]);
    // In increments: R from where it is, Z from R, three holes.
    let holes = ends("G0 Z5\nG91 G99 G81 X1 Z-4 R-3 L3 F100", &Reading::default());
    let deep: Vec<[f64; 3]> = holes.into_iter().filter(|end| end[2] < 0.0).collect();
    assert_eq!(deep, [[1.0, 0.0, -2.0], [2.0, 0.0, -2.0], [3.0, 0.0, -2.0]]);
    // Boring comes out at feed; a dwell stays at the bottom.
    let (rows, result) = run("G0 Z2\nG99 G89 X1 Z-3 R2 P0.5 F600", &Reading::default());
    let slow: Vec<f64> = rows.iter().filter(|row| !row.cut.feed.is_rapid()).map(|row| row.length).collect();
    assert_eq!((slow, result.expect("timed").dwell_time), (vec![5.0, 5.0], 0.5));
    // In another plane.
    assert_eq!(ends("G18 G0 Y9\nG99 G81 X1 Y-1 R1 F9", &Reading::default())[3], [1.0, -1.0, 0.0]);
}

#[test]
fn offsets() {
    let cases: [(&str, [f64; 3]); 14] = [
        ("G10 L2 P1 X10\nG54 G0 X1", [11.0, 0.0, 0.0]),
        ("G10 L2 P2 Y5\nG55 G0 Y1\nG54 Y1", [0.0, 1.0, 0.0]),
        ("G0 X4\nG10 L20 P1 X1\nG0 X2", [5.0, 0.0, 0.0]),
        ("G59.3 G10 L2 P0 Z3\nG0 Z1", [0.0, 0.0, 4.0]),
        ("G10 L2 P1 X10\nG53 G0 X1", [1.0, 0.0, 0.0]),
        ("G0 X5\nG92 X0\nG0 X1\nG92.1\nX1", [1.0, 0.0, 0.0]),
        ("G0 X5\nG92 X0\nG92.2\nG0 X1\nG92.3\nX1", [6.0, 0.0, 0.0]),
        ("G52 X2\nG0 X1\nG52 X0\nX3", [3.0, 0.0, 0.0]),
        ("G10 L1 P3 Z7\nG43 H3\nG0 Z1", [0.0, 0.0, 8.0]),
        ("G43.1 Z2\nG0 Z1\nG49 Z1", [0.0, 0.0, 1.0]),
        ("G20 G10 L2 P1 X1\nG0 X1", [50.8, 0.0, 0.0]),
        ("G0 X9 Z9\nG28.1\nG0 X0 Z0\nG91 G28 Z1", [0.0, 0.0, 9.0]),
        ("G7 G0 X8", [4.0, 0.0, 0.0]),
        // Units of Mach and Siemens.
        ("G70\nG0 X1\nG71\nX2", [2.0, 0.0, 0.0]),
    ];
    for (program, expected) in cases {
        let found = ends(program, &Reading::default());
        let last = found[found.len() - 1];
        (0..3).for_each(|axis| near(last[axis], expected[axis]));
    }
    // A coordinate system that is turned by a right angle.
    let turned = ends("G10 L2 P1 X1 R90\nG0 X2 Y0", &Reading::default())[0];
    near(turned[0], 1.0);
    near(turned[1], 2.0);
}

#[test]
fn home() {
    let home = Reading { home: Some([1.0, 2.0, 50.0]), ..Reading::default() };
    assert_eq!(ends("G28 G91 Z0\nG90\nG0 X3", &home), [[0.0, 0.0, 0.0], [0.0, 0.0, 50.0], [3.0, 0.0, 50.0]]);
    assert_eq!(ends("G0 X9\nG28", &home)[1], [1.0, 2.0, 50.0]);
    assert_eq!(ends("G0 X9\nG30 X5", &home)[1..], [[5.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
}

#[test]
fn other_axes_and_feeds() {
    let total = |program: &str| run(program, &Reading::default()).1.expect("timed").time;
    // Degrees a minute where only turning axes move, not in inches either.
    near(total("G1 A90 F600"), time(90.0, 10.0));
    near(total("G20 G1 A90 F600"), time(90.0, 10.0));
    near(total("G1 U30 F600"), time(30.0, 10.0));
    // Beside X they take its time.
    near(total("G1 X30 B10 F600"), time(30.0, 10.0));
    near(total("G93 G1 X30 F20"), time(30.0, 10.0));
    near(total("S600 G95 G1 X30 F1"), time(30.0, 10.0));
    near(
        run("G96 S30 G95 G0 X10\nG1 Z-1 F0.5", &Reading::default()).0[1].time,
        time(1.0, 0.5 * 500.0 / (std::f64::consts::TAU * 10.0)),
    );
}

#[test]
fn curves() {
    // A straight line as a curve of the third and of the second degree, and as a NURBS.
    let length = |program: &str| {
        let (rows, result) = run(program, &Reading::default());
        result.unwrap_or_else(|error| panic!("{program}: {error}"));
        (rows.iter().map(|row| row.length).sum::<f64>(), rows[rows.len() - 1].cut.to)
    };
    for program in [
        "G1 F600 X0\nG5 I1 J0 P-1 Q0 X9 Y0",
        "G1 F600 X0\nG5.1 I4.5 J0 X9 Y0",
        "G1 F600 X0\nG5.2 P1 L3\nX3 Y0 P1\nX6 Y0 P1\nX9 Y0 P1\nG5.3",
        "G1 F600 X0\nG6.2 X0 Y0 R1 K0 P3\nX4 Y0 R1 K0\nX9 Y0 R1 K0\nK1\nK1\nK1\nG6.3",
    ] {
        let (way, end) = length(program);
        near(way, 9.0);
        assert_eq!(end, [9.0, 0.0, 0.0], "{program}");
    }
    // A quarter of a circle is a rational curve of the second degree.
    let (way, _) = length("G1 F600 X1\nG5.2 P1 L3\nX1 Y1 P0.7071067811865476\nX0 Y1 P1\nG5.3");
    let quarter = std::f64::consts::FRAC_PI_2;
    assert!((way - 1.0 - quarter).abs() < 1e-3, "{way}");
}

#[test]
fn arcs_of_rounded_files() {
    // Within LinuxCNC's tolerance, 0.00283 inch: accepted without a word.
    let (rows, result) = run("G20 G90\nG0 X-0.305 Y-0.127\nG3 X0.304 Y-0.127 I0.305 J0.115 F50", &Reading::default());
    assert_eq!(result.expect("accepted").notices, 0);
    // From 0.305 left of the centre and 0.115 below it to 0.304 right: less than half a turn, counter-clockwise.
    let angle = (0.305_f64).atan2(0.115) + (0.304_f64).atan2(0.115);
    let expected = 25.4 * (0.305_f64.hypot(0.115) + 0.304_f64.hypot(0.115)) / 2.0 * angle;
    assert!((rows[1].length - expected).abs() < 1e-9, "{} {expected}", rows[1].length);
    // A twentieth of a millimetre: told. More: refused.
    assert_eq!(run("G0 X0\nG2 X2.05 I1 F50", &Reading::default()).1.expect("told").notices, 1);
    assert!(run("G0 X0\nG2 X2.3 I1 F50", &Reading::default()).1.is_err());
    // E is no axis of a mill.
    let (_, result) = run("G0 X1 E5", &of(Dialect::Grbl));
    assert!(result.expect_err("refused").to_string().contains("the word E is nothing that grbl has"));
    // Several turns.
    near(run("G2 X2 I1 P2 F60", &Reading::default()).0[0].length, 3.0 * std::f64::consts::PI);
    assert!(run("G17 G3 X1 I0.5 J0.5 G90.1 F60", &Reading::default()).1.is_ok());
}

#[test]
fn marks_switches_and_ends() {
    assert_eq!(xs("title of the job\n%\nG0 X1\n%\nG0 X2"), [1.0]);
    assert_eq!(xs("G0 X1\n\u{1a}"), [1.0]);
    assert_eq!(xs("/1 G0 X1\n/ X2"), [1.0, 2.0]);
    assert_eq!(ends("/1 G0 X1\n/ X2\nG0 X3", &Reading { block_delete: true, ..Reading::default() }), [[3.0, 0.0, 0.0]]);
    assert_eq!(xs("g0 x 10 0  y2 00 .0"), [100.0]);
    assert_eq!(xs("G0 X1 (a ((b)) c) (MSG, X9)\n(++)\nG0 X2"), [1.0, 2.0]);
    assert_eq!(xs("G0 X1 F100000000"), [1.0]);
    assert_eq!(xs("G1. X1 F9"), [1.0]);
}

#[test]
fn times_by_tool_and_feature() {
    let program = "T1 M6\n(pocket)\nG1 X10 F600\n(MSG, no feature)\nT2 M6\nM3 S1000\n(holes)\nX20\n(pocket)\nX40";
    let machine = Machine { tool_change: 5.0, spindle_start: 2.0, ..Machine::default() };
    let milling = Milling::new(machine, Model::ExactStop).expect("a machine");
    let summary = milling.gcode(program.as_bytes(), &Reading::default(), |_| ()).expect("timed");
    let (ten, twenty) = (time(10.0, 10.0), time(20.0, 10.0));
    assert_eq!((summary.tool_changes, summary.tool_change_time, summary.spindle_time), (2, 10.0, 2.0));
    assert_eq!(summary.tools.iter().map(|(tool, _)| *tool).collect::<Vec<u32>>(), [1, 2]);
    near(summary.tools[1].1, ten + twenty);
    let names: Vec<&str> = summary.features.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["pocket", "holes"]);
    near(summary.features[0].1, ten + twenty);
    near(summary.time, 12.0 + 2.0 * ten + twenty);
}
