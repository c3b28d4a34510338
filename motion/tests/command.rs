//! The command `closedform-motion`: what it prints and writes, and how it fails.
#![cfg(feature = "command")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use closedform_motion::table::load;
use serde_json::Value;

const SCAN: &str = "--v1-scan 0.1 --a1-max 50 --d2-step 2e-4 --a2-max 2 --line-length 0.005 --lines 4";
const STEP: &str = "--travel 1e-3 --a3 -2.5e-1 --t1 0.015";
const FASTEST: &str = "--travel 1e-3 --v-max 0.1 --a-max 2 --j-max 200";
const FIVE: &str = "--delta-x 0.01 --ki 0.1 --t0 0.1 --t1 0.1 --t2 0.1";
const WAYPOINTS: &str = "--point 0,0 --point 0.2,0.4 --point 0.7,-0.5 --point -1,0.1";
const PROGRAM: &str = "G21 G90\nG0 X10 Y10\nG1 Z-1 F1200\nX50\nY40\nG2 X30 Y20 I-20 J0\nG0 Z5\nM30\n";

fn run(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform-motion"));
    command.current_dir(folder).args(arguments.split_whitespace()).output().expect("runs")
}

fn good(folder: &Path, arguments: &str) -> String {
    let output = run(folder, arguments);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments}: {error}");
    assert!(error.is_empty(), "{arguments}: {error}");
    String::from_utf8(output.stdout).expect("text")
}

/// One line of error, exit code 1, and no file that was not there.
fn bad(folder: &Path, arguments: &str) -> String {
    let count = || fs::read_dir(folder).expect("a folder").count();
    let before = count();
    let output = run(folder, arguments);
    let error = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(1), "{arguments}: {error}");
    assert_eq!(error.lines().count(), 1, "{arguments}: {error}");
    assert!(output.stdout.is_empty());
    assert_eq!(count(), before, "{arguments}: files were left behind");
    error
}

fn kinds() -> Vec<(&'static str, String)> {
    vec![
        ("raster-scan", SCAN.to_owned()),
        ("raster-scan", format!("{SCAN} --shape derivation")),
        ("step", STEP.to_owned()),
        ("step", FASTEST.to_owned()),
        ("five-segment", FIVE.to_owned()),
        ("waypoints", WAYPOINTS.to_owned()),
        ("milling", "--gcode a.nc".to_owned()),
    ]
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.nc"), PROGRAM).expect("written");
    folder
}

#[test]
fn every_kind_is_planned_tabled_and_drawn() {
    let folder = folder();
    let path = folder.path();
    for (kind, flags) in kinds() {
        let text = good(path, &format!("plan {kind} {flags}"));
        assert!(text.contains("duration"), "{text}");
        let json = good(path, &format!("plan {kind} {flags} --json --table {kind}.csv --picture {kind}.png"));
        let summary: Value = serde_json::from_str(&json).expect("JSON");
        assert_eq!(summary["plan"], kind);
        assert!(summary["facts"]["duration"]["value"].as_f64().expect("a number") > 0.0);
        assert_eq!(summary["files"].as_array().expect("files").len(), 2);
        assert!(fs::read(path.join(format!("{kind}.png"))).expect("a picture").starts_with(b"\x89PNG"));
        let rows = summary["files"][0]["rows"].as_u64().expect("rows");
        let lines = fs::read_to_string(path.join(format!("{kind}.csv"))).expect("a table").lines().count() as u64;
        assert_eq!(lines, rows + 1);
        good(path, &format!("plan {kind} {flags} --table {kind}.json"));
        let table = fs::read_to_string(path.join(format!("{kind}.json"))).expect("a table");
        assert_eq!(
            serde_json::from_str::<Value>(&table).expect("JSON")["rows"].as_array().expect("rows").len() as u64,
            rows
        );
        good(path, &format!("plot {kind} {flags} --dark"));
        assert!(fs::read_to_string(path.join(format!("{kind}.svg"))).expect("a picture").contains("#0D1117"));
    }
}

#[test]
fn the_table_ends_when_the_plan_does() {
    let folder = folder();
    for (kind, flags) in kinds().into_iter().filter(|(kind, _)| *kind != "milling") {
        let json = good(folder.path(), &format!("plan {kind} {flags} --json --durations --table a.json"));
        let duration = serde_json::from_str::<Value>(&json).expect("JSON")["facts"]["duration"]["value"].as_f64();
        let table = load(&folder.path().join("a.json")).expect("a table");
        let end = table.rows[table.rows.len() - 1].time;
        // Both are sums of the same durations in another order, none with more than 32 terms.
        assert!((end - duration.expect("a number")).abs() <= 32.0 * f64::EPSILON * end, "{kind}");
    }
}

#[test]
fn a_file_says_what_flags_say_and_flags_come_first() {
    let folder = folder();
    let file = "v1-scan = 0.1\na1-max = 50\nd2-step = 2e-4\na2-max = 2\nline-length = 0.005\nlines = 4\n";
    fs::write(folder.path().join("plan.toml"), file).expect("written");
    let flags = good(folder.path(), &format!("plan scan-skip {SCAN}"));
    assert_eq!(good(folder.path(), "plan scan-skip --file plan.toml"), flags);
    let other = good(folder.path(), "plan scan-skip --file plan.toml --lines 8 --one-way");
    assert!(other.contains("lines") && other != flags);
    fs::write(
        folder.path().join("points.toml"),
        "problem = \"e\"\npoints = [[0, 0], [0.2, 0.4], [0.7, -0.5], [-1, 0.1]]\n",
    )
    .expect("written");
    assert_eq!(
        good(folder.path(), "plan waypoints --file points.toml"),
        good(folder.path(), &format!("plan waypoints {WAYPOINTS}"))
    );
    fs::write(folder.path().join("points.csv"), "x,y\n0,0\n0.2,0.4\n0.7,-0.5\n-1,0.1\n").expect("written");
    let output = run(folder.path(), "plan waypoints --points-file points.csv");
    assert_eq!(String::from_utf8_lossy(&output.stdout), good(folder.path(), &format!("plan waypoints {WAYPOINTS}")));
    let said = "points.csv: passed over: line 1: names of columns\n";
    assert_eq!(String::from_utf8_lossy(&output.stderr), said);
}

#[test]
fn bad_input_is_one_line_and_exit_code_1() {
    let folder = folder();
    let path = folder.path();
    let error = bad(path, "plan scan-skip --v1-scan 0.1 --table a.csv");
    assert!(error.contains("line-length is missing: give"), "{error}");
    let error = bad(path, &format!("plan step {STEP} --travel -1").replace("--travel 1e-3 ", ""));
    assert!(error.contains("travel is -1"), "{error}");
    for number in ["nan", "inf", "0", "-5"] {
        bad(path, &format!("plan step --travel {number} --a3 -0.25 --t1 0.015 --table a.csv --picture a.svg"));
        let scan = SCAN.replace("--a1-max 50", &format!("--a1-max {number}"));
        bad(path, &format!("plan scan-skip {scan} --table a.csv --picture a.svg"));
    }
    bad(path, &format!("plan step {STEP} --ki 0.5"));
    bad(path, &format!("plan step {STEP} --v-max 1e-3"));
    bad(path, "plan milling --gcode none.nc");
    bad(path, "plan milling");
    bad(path, "plan milling --gcode a.nc --acceleration 1,2 --table a.csv");
    bad(path, "plan waypoints --point 0,0");
    bad(path, "plan waypoints --point 0,0 --point 1,1 --problem d");
    bad(path, &format!("plan waypoints {WAYPOINTS} --problem z"));
    bad(path, &format!("plan waypoints {WAYPOINTS} --problem a --table a.csv"));
    bad(path, &format!("plan waypoints {WAYPOINTS} --tolerance 0 --table a.csv"));
    bad(path, &format!("plan scan-skip {SCAN} --tolerance -1 --table a.csv"));
    // A wrong ending is found before anything is written.
    bad(path, &format!("plan step {STEP} --table a.csv --picture a.bmp"));
    bad(path, &format!("plan step {STEP} --table a.xls"));
}

#[test]
fn numbers_that_are_wrong_are_told_by_the_names_of_their_flags() {
    let folder = folder();
    for number in ["nan", "-1", "0"] {
        for (arguments, flag) in [
            ("plan step --travel 1 --a-max 2", "v-max"),
            ("plan step --travel 1 --v-max 2", "a-max"),
            ("plan step --travel 1 --a-max 2", "j-max"),
            ("plan waypoints --point 0,0 --point 1,1 --a-max 2", "j-max"),
            (
                "plan raster-scan --v-scan 0.1 --line-length 1 --step 0.1 --lines 3 --step-a-max 1 --fly-v-max 1",
                "fly-a-max",
            ),
        ] {
            let error = bad(folder.path(), &format!("{arguments} --{flag} {number}"));
            let number = number.replace("nan", "NaN");
            assert!(error.starts_with(&format!("error: {flag} is {number}: give a positive limit")), "{error}");
        }
    }
    let error = bad(folder.path(), &format!("plan five-segment {}", FIVE.replace("--delta-x 0.01", "--delta-x 0")));
    assert!(error.starts_with("error: delta-x is 0: "), "{error}");
    let error = bad(
        folder.path(),
        "plan raster-scan --v-scan 0.1 --line-length nan --step 0.1 --lines 3 --step-a-max 1 --fly-a-max 1",
    );
    assert!(error.starts_with("error: the magnitude of line-length is NaN: "), "{error}");
    for number in ["nan", "inf", "0"] {
        let error = bad(folder.path(), &format!("plan step --a-max 2 --travel {number}"));
        assert!(
            error.starts_with("error: travel is ") && error.contains(": give a finite number other than 0"),
            "{error}"
        );
    }
}

#[test]
fn broken_files_are_told_with_their_line() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("plan.toml"), "v1-scan = 0.1\nspeed = 3\n").expect("written");
    assert!(
        bad(path, "plan scan-skip --file plan.toml").contains("plan.toml: line 2, column 1: unknown field `speed`")
    );
    fs::write(path.join("plan.toml"), "v1-scan = 0.1\nline-length = \"1 m\"\n").expect("written");
    let said = bad(path, "plan scan-skip --file plan.toml");
    assert!(said.contains("plan.toml: line 2, column 15: invalid type: string \"1 m\""), "{said}");
    fs::write(path.join("plan.toml"), "v1-scan = \n").expect("written");
    assert!(bad(path, "plan scan-skip --file plan.toml").contains("plan.toml: line 1"));
    assert!(bad(path, "plan scan-skip --file none.toml").contains("none.toml"));
    fs::write(path.join("b.nc"), "G1 X1 F100\nG999 X2\n").expect("written");
    assert!(bad(path, "plan milling --gcode b.nc --table a.csv").contains("b.nc: line 2: G999"));
    let skipped = run(path, "plan milling --gcode b.nc --unknown skip");
    assert!(skipped.status.success());
    assert!(String::from_utf8_lossy(&skipped.stderr).contains("b.nc: passed over: line 2: G999"));
    fs::write(path.join("c.csv"), "0,0\n1,b\n").expect("written");
    assert!(bad(path, "plan waypoints --points-file c.csv").contains("c.csv: line 2: `b` is not a number"));
}

#[test]
fn a_place_that_cannot_be_written_is_exit_code_1() {
    let folder = folder();
    let error = bad(folder.path(), &format!("plan step {STEP} --table none/a.csv"));
    let said = "none/a.csv: No such file or directory (os error 2): make room, and get the right to write there\n";
    assert_eq!(error, format!("error: {said}"));
    let error = bad(folder.path(), &format!("plot step {STEP} --picture none/a.svg"));
    assert_eq!(error, format!("error: {}", said.replace("csv", "svg")));
}

#[test]
fn files_that_the_plan_is_read_from_stay() {
    let folder = folder();
    let path = folder.path();
    let points = "0,0\n0.2,0.4\n0.7,-0.5\n-1,0.1\n";
    fs::write(path.join("p.csv"), points).expect("written");
    fs::write(path.join("p.toml"), "points-file = \"p.csv\"\n").expect("written");
    fs::write(path.join("m.svg"), PROGRAM).expect("written");
    let read = |name: &str| fs::read_to_string(path.join(name)).expect("a file");
    for arguments in [
        "plan waypoints --points-file p.csv --table p.csv",
        "plan waypoints --points-file ./p.csv --table p.csv",
        "plan waypoints --file p.toml --table p.csv",
        "plan milling --points-file p.csv --feed 10 --table p.csv",
        "plan milling --gcode m.svg --picture m.svg",
    ] {
        assert!(bad(path, arguments).contains("the plan is read from this file: give --"), "{arguments}");
        assert_eq!((read("p.csv"), read("m.svg")), (points.to_owned(), PROGRAM.to_owned()), "{arguments}");
    }
    fs::rename(path.join("p.toml"), path.join("p.json")).expect("renamed");
    bad(path, "plan waypoints --file p.json --table p.json");
    // A table that was written before is written anew.
    good(path, "plan waypoints --points-file p.csv --table q.csv");
    good(path, "plan waypoints --points-file p.csv --table q.csv");
}

#[test]
fn help_and_version_name_the_command_that_was_typed() {
    let folder = folder();
    assert!(
        good(folder.path(), "plan scan-skip --help").contains("Usage: closedform-motion plan raster-scan [OPTIONS]")
    );
    assert!(good(folder.path(), "--help").contains("Usage: closedform-motion <COMMAND>"));
    assert!(good(folder.path(), "--version").starts_with("closedform-motion "));
    assert!(!good(folder.path(), "--help").contains("gallery"));
    let mut handed_on = Command::new(env!("CARGO_BIN_EXE_closedform-motion"));
    let output = handed_on.env("CLOSEDFORM_HANDS_ON", "1").args(["plan", "--help"]).output().expect("runs");
    assert!(String::from_utf8_lossy(&output.stdout).contains("Usage: closedform plan <COMMAND>"));
}

#[cfg(target_os = "linux")]
#[test]
fn nobody_reads_on_or_the_disk_is_full() {
    use std::io;
    use std::process::Stdio;

    let folder = folder();
    let full = || Stdio::from(fs::OpenOptions::new().write(true).open("/dev/full").expect("opens"));
    let closed = || Stdio::from(io::pipe().expect("a pipe").1);
    let run = |arguments: &str, output: Stdio, errors: Stdio| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_closedform-motion"));
        command.current_dir(&folder).args(arguments.split_whitespace()).stdout(output).stderr(errors);
        command.spawn().expect("starts").wait_with_output().expect("ends")
    };
    let plans = kinds().into_iter().map(|(kind, inputs)| format!("plan {kind} {inputs}"));
    for arguments in plans.chain(["--help".to_owned(), "--version".to_owned(), "plan step --help".to_owned()]) {
        let unread = run(&arguments, closed(), Stdio::piped());
        assert_eq!((unread.status.code(), &*unread.stderr), (Some(0), &b""[..]), "{arguments}");
        let lost = run(&arguments, full(), Stdio::piped());
        let error = String::from_utf8(lost.stderr).expect("text");
        assert_eq!(lost.status.code(), Some(1), "{arguments}: {error}");
        assert!(error.starts_with("error: cannot write to standard output: "), "{arguments}: {error}");
        assert_eq!(error.lines().count(), 1, "{arguments}: {error}");
    }
    for errors in [full(), closed()] {
        assert_eq!(run("plan step", Stdio::null(), errors).status.code(), Some(1));
    }
}

#[test]
fn limits_in_and_the_fastest_out() {
    let folder = folder();
    let path = folder.path();
    let duration = |arguments: &str| {
        let json = good(path, &format!("{arguments} --json"));
        serde_json::from_str::<Value>(&json).expect("JSON")["facts"]["duration"]["value"].as_f64().expect("a number")
    };
    // twice the square root of travel by acceleration
    assert!((duration("plan step --travel 1e-3 --a-max 2") - 2.0 * (5e-4_f64).sqrt()).abs() < 1e-15);
    assert!((duration("plan step --travel -1e-3 --j-max 4") - 4.0 * (1e-3_f64 / 8.0).cbrt()).abs() < 1e-15);
    assert!((duration("plan step --travel 1e-3 --a-max 2 --time 3") - 3.0).abs() < 1e-15);
    assert!(bad(path, "plan step --travel 1e-3 --a-max 2 --time 1e-3").contains("time is limited to"));
    assert!(bad(path, "plan step --travel 1e-3 --v-max 2").contains("give --a-max"));
    let jump = bad(path, "plan step --travel 1e-3 --a3 -0.25 --t1 0.015 --j-max 200");
    assert!(jump.contains("the acceleration jumps by 0.0026"), "{jump}");
    assert!(good(path, &format!("plan scan-skip {SCAN}")).contains("jump of acceleration of fly   50 m/s²"));
    assert!((duration(&format!("plan raster-scan {}", SCAN.replace("--lines 4", "--lines 2"))) - 0.124).abs() < 1e-15);
    let two = "plan waypoints --point 0,0,0,0,0,0,0 --point 1,2,3,4,5,6,7 --v-max 1";
    assert!((duration(two) - 10.5).abs() < 1e-12);
    assert!(
        good(path, "plan waypoints --point 0 --point 0.5 --point 1 --point 10 --times 1,1,1").contains("overshoot")
    );
}

#[test]
fn one_line_has_no_turn_around_and_names_are_aliases() {
    let folder = folder();
    let path = folder.path();
    let text = good(path, &format!("plan scan-skip {}", SCAN.replace("--lines 4", "--lines 1")));
    assert!(!text.contains("turn-around ") && !text.contains("overhead"), "{text}");
    let new = SCAN.replace("--v1-scan", "--v-scan").replace("--a1-max", "--fly-a-max");
    let new = new.replace("--d2-step", "--step").replace("--a2-max", "--step-a-max");
    assert_eq!(good(path, &format!("plan raster-scan {new}")), good(path, &format!("plan scan-skip {SCAN}")));
    let endless = run(path, &format!("plan scan-skip {}", SCAN.replace("--lines 4", "--lines 18446744073709551615")));
    assert_eq!(endless.status.code(), Some(2), "a number that no flag takes is a mistake of the command line");
    bad(path, &format!("plan raster-scan {SCAN} --v1-diff 0 --fly-j-max 3"));
    bad(path, &format!("plan raster-scan {SCAN} --triggers t.csv"));
    let flags =
        format!("plan raster-scan {SCAN} --pixels 10 --triggers t.csv --tick 0.00025 --durations --table d.csv");
    good(path, &flags);
    assert_eq!(fs::read_to_string(path.join("t.csv")).expect("triggers").lines().count(), 41);
    for line in fs::read_to_string(path.join("d.csv")).expect("a table").lines().skip(1) {
        let duration = line.split(',').next().expect("a field");
        assert!(["0.0", "0.002", "0.05", "0.01"].contains(&duration), "{duration}");
    }
}

#[test]
fn points_come_as_people_write_them() {
    let folder = folder();
    let path = folder.path();
    let right = good(path, &format!("plan waypoints {WAYPOINTS}"));
    for text in [
        "\u{feff}0,0\n0.2,0.4\n0.7,-0.5\n-1,0.1\n",
        "0 0\n0.2\t0.4\n\n 0.7  -5e-1\r\n-1 0.1",
        "0;0\n0.2;0.4;\n0.7; -0.5\n\"-1\";\"0.1\"\n",
        "# points\n0,0,\n0.2,0.4,\n0.7,-0.5,\n-1,0.1,\n",
    ] {
        fs::write(path.join("p.csv"), text).expect("written");
        assert_eq!(good(path, "plan waypoints --points-file p.csv"), right, "{text:?}");
    }
    fs::write(path.join("p.csv"), "0.0.0,0\n0.2,0.4\n0.7,-0.5\n-1,0.1\n").expect("written");
    assert!(bad(path, "plan waypoints --points-file p.csv").contains("line 1: `0.0.0` is not a number"));
    fs::create_dir(path.join("sub")).expect("a folder");
    fs::write(path.join("sub/p.csv"), "0,0\n0.2,0.4\n0.7,-0.5\n-1,0.1\n").expect("written");
    fs::write(path.join("sub/p.toml"), "points-file = \"p.csv\"\n").expect("written");
    assert_eq!(good(path, "plan waypoints --file sub/p.toml"), right);
}

#[test]
fn a_dash_is_standard_input_and_output() {
    use std::io::Write;
    use std::process::Stdio;

    let folder = folder();
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform-motion"));
    command.current_dir(&folder).args("plan waypoints --points-file - --table -".split(' '));
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("starts");
    child.stdin.take().expect("a pipe").write_all(b"0,0\n1,2\n").expect("written");
    let output = child.wait_with_output().expect("ends");
    assert!(output.status.success());
    let table = String::from_utf8(output.stdout).expect("text");
    assert!(table.starts_with("time [s],X position [m],X velocity [m/s],Y position [m]") && table.lines().count() == 3);
    assert!(String::from_utf8(output.stderr).expect("text").contains("duration"));
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_file() {
    let folder = folder();
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform-motion"));
    let flags = SCAN.replace("--lines 4", "--lines 100000000");
    command.current_dir(&folder).args(format!("plan raster-scan {flags} --table a.csv").split(' '));
    let mut child = command.spawn().expect("starts");
    let begun = |name: &std::ffi::OsStr| name.to_string_lossy().starts_with(".closedform-");
    let names = || fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    while !names().any(|name| begun(&name)) {
        assert!(child.try_wait().expect("a child").is_none(), "it ended");
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    // the shell's own `kill`: small systems have no program of that name
    let kill = ["-c", r#"kill -INT "$0""#, &child.id().to_string()];
    let killed = Command::new("sh").args(kill).status().expect("the shell runs");
    assert!(killed.success());
    assert_eq!(child.wait().expect("ends").code(), Some(130));
    assert!(!names().any(|name| begun(&name)));
}

#[test]
fn controllers_take_their_forms() {
    let folder = folder();
    let raster = format!("plan raster-scan {SCAN} --pixels 5");
    for controller in ["pmac", "ophyd-async", "acs", "epics", "scanspec", "rust", "c"] {
        let said = good(folder.path(), &format!("{raster} --export out.txt --controller {controller}"));
        assert!(said.contains("out.txt"), "{said}");
        let step = format!("plan step {FASTEST} --export step.txt --controller {controller}");
        match controller {
            "scanspec" => assert!(bad(folder.path(), &step).contains("--pixels")),
            _ => assert!(good(folder.path(), &step).contains("step.txt")),
        }
    }
    let many = format!("{raster} --export x.txt --controller c --most-points 3");
    assert!(bad(folder.path(), &many).contains("more points than the 3"));
    let none = format!("{raster} --export x.txt --controller epics --longest-segment 0");
    assert!(bad(folder.path(), &none).contains("longest-segment is 0.0"));
    let milling = "plan milling --gcode a.nc --export x.txt --controller pmac";
    assert!(bad(folder.path(), milling).contains("no motion of the axes"));
}
