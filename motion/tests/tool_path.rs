//! Pictures of milling jobs: what they show, however many moves there are.

use closedform_motion::plan::milling::gcode::{Event, Reading};
use closedform_motion::plan::milling::{Machine, Milling, Model};
use closedform_motion::plot::{Colouring, PageCurve, Theme, ToolPath};

fn gathered(program: &str) -> ToolPath {
    let milling = Milling::new(Machine::default(), Model::default()).expect("a machine");
    let mut path = ToolPath::new();
    let event = |event: Event| match event {
        Event::Row(row) => path.add(row),
        Event::Dwell(time) => path.dwell(time),
        _ => {}
    };
    milling.gcode(program.as_bytes(), &Reading::default(), event).expect("timed");
    path
}

fn svg(program: &str, colouring: Colouring) -> String {
    gathered(program).draw(colouring, "Job", "", Theme::LIGHT).expect("drawn").svg()
}

/// Points of the longest polyline that comes back to where it begins.
fn longest(svg: &str) -> Vec<(f64, f64)> {
    let lines = svg.split("points=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let points = |line: &str| -> Vec<(f64, f64)> {
        let pair = |text: &str| text.split_once(',').map(|(x, y)| (x.parse().expect("x"), y.parse().expect("y")));
        line.split_ascii_whitespace().filter_map(pair).collect()
    };
    let is_closed = |points: &Vec<(f64, f64)>| {
        let (first, last) = (points[0], points[points.len() - 1]);
        points.len() > 10 && (first.0 - last.0).hypot(first.1 - last.1) < 20.0
    };
    lines.map(points).filter(is_closed).max_by_key(Vec::len).unwrap_or_default()
}

#[test]
fn a_circle_is_round() {
    let points = longest(&svg("G0 X0 Y0\nG2 I5 J0 F600", Colouring::Speed));
    let (mut low, mut high) = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    for (x, y) in &points {
        (low, high) = ((low.0.min(*x), low.1.min(*y)), (high.0.max(*x), high.1.max(*y)));
    }
    let (wide, tall) = (high.0 - low.0, high.1 - low.1);
    assert!(points.len() > 60 && (wide / tall - 1.0).abs() < 0.01, "{wide} {tall}");
    let (x, y) = ((low.0 + high.0) / 2.0, (low.1 + high.1) / 2.0);
    for point in &points {
        let radius = (point.0 - x).hypot(point.1 - y);
        assert!((radius / (wide / 2.0) - 1.0).abs() < 0.01, "{point:?}");
    }
}

#[test]
fn the_time_axis_has_dwells() {
    let page = gathered("G1 X10 F600\nG4 P30\nG1 X0").page("Job", "", Theme::LIGHT).expect("a page");
    // 30 s, and twice 10 mm at 10 mm/s with two ramps of 20 ms.
    assert!((page.end - 32.04).abs() < 1e-9, "{}", page.end);
    let x = page.panels.iter().find(|panel| panel.title == "X (mm)").expect("a panel of X");
    assert!(page.panels.iter().all(|panel| panel.title != "Z (mm)"), "an axis that rests has a panel");
    let still = x.curves[0].x.iter().zip(&x.curves[0].y).filter(|(_, at)| **at == 10.0);
    let times: Vec<f64> = still.map(|(time, _)| *time).collect();
    assert!((times[times.len() - 1] - times[0] - 30.0).abs() < 1e-6, "{times:?}");
    assert!(page.html().expect("text").contains("Speed"));
}

#[test]
fn the_path_of_a_page_knows_what_cuts_and_when() {
    let page = gathered("G0 X10\nG1 Y10 F600\nG4 P5\nG1 Y20\nG0 X0").page("Job", "", Theme::LIGHT).expect("a page");
    assert_eq!(page.names, ["cut", "rapid"]);
    let [cut, rapid] = &page.panels[0].curves[..] else { panic!("two kinds of lines") };
    let points = |curve: &PageCurve| curve.x.iter().copied().zip(curve.y.iter().copied()).collect::<Vec<_>>();
    // the dwell holds the point where it is
    assert_eq!(points(cut), [(10.0, 0.0), (10.0, 10.0), (10.0, 10.0), (10.0, 20.0)]);
    assert_eq!(points(rapid), [(0.0, 0.0), (10.0, 0.0), (10.0, 20.0), (0.0, 20.0)]);
    assert_eq!((cut.starts.as_slice(), rapid.starts.as_slice()), (&[0][..], &[0, 2][..]));
    // the panel of Y says when it begins, rests at 10 mm, and ends
    let y = &page.panels.iter().find(|panel| panel.title == "Y (mm)").expect("a panel of Y").curves[0];
    let at = |time: f64| {
        let index = y.x.partition_point(|x| *x < time - 1e-9).min(y.x.len() - 1);
        y.y[index]
    };
    for (when, place) in cut.when.iter().zip(&cut.y) {
        assert!((at(*when) - place).abs() < 1e-3, "{when}: {} and {place}", at(*when));
    }
    assert!((cut.when[2] - cut.when[1] - 5.0).abs() < 1e-9);
    assert_eq!((rapid.when[0], rapid.when[3]), (0.0, page.end));
}

#[test]
fn the_frame_is_of_millimetres_around_the_path() {
    // A path along one axis has room across it, not metres.
    let text = svg("G1 X20 F600", Colouring::Speed);
    assert!(text.contains("\nX (mm)\n") && text.contains("largest speed (mm/s) 10.0"), "{text}");
    let coloured = svg("G1 X20 Z-1 F600\nG1 Y20 Z-3 F1200", Colouring::Height);
    assert!(coloured.contains("\nZ (mm)\n") && coloured.contains("colour of cuts"));
    assert!(svg("G1 X20 F600\nG1 Y20 F1200", Colouring::Feed).contains("\nFeed (mm/s)\n"));
}

#[test]
fn all_moves_of_a_large_job_are_drawn_and_the_picture_stays_small() {
    // A raster of 300,000 moves, with a mark at its very end.
    let mut program = String::from("G21 G1 F6000 X0 Y0\n");
    for row in 0..1000 {
        for column in 0..300 {
            let x = if row % 2 == 0 { column } else { 299 - column };
            program.push_str(&format!("X{x} Y{}.{}\n", row / 10, row % 10));
        }
    }
    program.push_str("G0 X400 Y50\n");
    let text = svg(&program, Colouring::Speed);
    assert!(text.len() < 4_000_000, "{} bytes", text.len());
    assert!(text.contains("\n400\n"), "the end is not in the frame");
}

#[test]
fn nothing_to_draw_is_an_error() {
    let error = gathered("G4 P1").draw(Colouring::Speed, "", "", Theme::DARK).expect_err("nothing");
    assert!(error.to_string().contains("no move has a length"), "{error}");
}
