//! Pictures: what is in them, that nothing overlaps, and what is refused.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Once;

use closedform_motion::plot::{Chart, Mark, Panel, Picture, PlotError, Series, Theme};
use closedform_motion::{Axis, Limits, Motion, Profile, Segment, State};
use plotters::style::{FontDesc, FontFamily, FontStyle, register_font};
use proptest::prelude::*;

fn profile(segments: Vec<Segment>) -> Profile {
    Profile::new(segments).expect("a profile")
}

/// A move there and half back, with all quantities, in any units of length and time.
fn motion(lengths: &[f64], time: f64, limits: [f64; 3]) -> Motion {
    let axis = |(index, length): (usize, &f64)| {
        let there = Segment::with_jerk(
            State { acceleration: 6.0 * length / time / time, ..State::rest(0.0) },
            time,
            -12.0 * length / time.powi(3),
        );
        let back = Segment::with_jerk(State::cruise(there.end.position, -length / time), time / 2.0, 0.0);
        Axis {
            name: ["fly", "step", "focus"][index].to_owned(),
            profile: profile(vec![there, back]),
            limits: Limits {
                velocity: limits[0] * length / time,
                acceleration: limits[1] * length / time / time,
                jerk: limits[2] * length / time.powi(3),
            },
        }
    };
    Motion::new(lengths.iter().enumerate().map(axis).collect())
}

/// A text of a picture and the box that it fills in DejaVu Sans.
#[derive(Debug)]
struct Text {
    text: String,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// Coordinates of the SVG a pixel of the picture.
const FINE: f64 = 10.0;

fn texts(svg: &str) -> Vec<Text> {
    let lines: Vec<&str> = svg.lines().collect();
    lines.windows(2).filter(|pair| pair[0].starts_with("<text ")).map(|pair| text(pair[0], pair[1])).collect()
}

fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = line.split_once(&format!(" {name}=\""))?;
    rest.split_once('"').map(|(value, _)| value)
}

fn wide(text: &str, size: f64, is_bold: bool) -> f64 {
    static FONTS: Once = Once::new();
    FONTS.call_once(|| {
        for (style, bytes) in [(FontStyle::Normal, dejavu::sans::regular()), (FontStyle::Bold, dejavu::sans::bold())] {
            assert!(register_font("DejaVu", style, bytes).is_ok());
        }
    });
    // The size of the plotting library is the height of a line, 1.164 of the size of the font.
    let style = if is_bold { FontStyle::Bold } else { FontStyle::Normal };
    let font = FontDesc::new(FontFamily::Name("DejaVu"), 1000.0 * 1.164, style);
    let text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
    f64::from(font.box_size(&text).expect("a width").0) * size / 1000.0
}

fn text(line: &str, content: &str) -> Text {
    let number =
        |name: &str| attribute(line, name).and_then(|value| value.parse::<f64>().ok()).expect("a number") / FINE;
    let size = number("font-size");
    let width = wide(content, size, attribute(line, "font-weight").is_some());
    let before = match attribute(line, "text-anchor") {
        Some("start") => 0.0,
        Some("middle") => 0.5,
        _ => 1.0,
    };
    let left = number("x") - width * before;
    let below = match attribute(line, "dy").expect("a shift") {
        "0.76em" => 0.76,
        "0.5ex" => 0.27,
        "-0.5ex" => -0.27,
        other => panic!("{other}"),
    };
    let base = number("y") + below * size;
    Text { text: content.to_owned(), left, right: left + width, top: base - 0.75 * size, bottom: base + 0.15 * size }
}

/// The heights of dashed lines, in pixels of the picture, each with the number of its dashes.
fn dashed(svg: &str) -> BTreeMap<String, usize> {
    let is_limit = |line: &&str| line.starts_with("<polyline ") && attribute(line, "stroke-width") == Some("16");
    let mut heights = BTreeMap::new();
    for line in svg.lines().filter(is_limit) {
        let points = attribute(line, "points").expect("points");
        let heights_of: BTreeSet<&str> = points.split_whitespace().filter_map(|at| at.split(',').nth(1)).collect();
        assert_eq!(heights_of.len(), 1, "{line}");
        *heights.entry(heights_of.first().expect("a point").to_string()).or_insert(0) += 1;
    }
    heights
}

/// No text leaves the picture or lies over another.
fn legible(svg: &str) -> Result<(), TestCaseError> {
    let texts = texts(svg);
    for (index, a) in texts.iter().enumerate() {
        prop_assert!(a.left >= 0.0 && a.right <= 480.0 && a.top >= 0.0, "outside: {a:?}");
        for b in &texts[..index] {
            let apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
            prop_assert!(apart, "{a:?} lies over {b:?}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn nothing_overlaps_in_any_units(
        lengths in prop::collection::vec((-9..4, 1.0..10.0), 1..4),
        time in (-7..4, 1.0..10.0),
        limits in prop::array::uniform3(prop_oneof![Just(f64::INFINITY), 0.5..20.0, Just(1e6)]),
    ) {
        let unit = |(exponent, digits): &(i32, f64)| digits * 10_f64.powi(*exponent);
        let lengths: Vec<f64> = lengths.iter().map(unit).collect();
        let motion = motion(&lengths, unit(&time), limits);
        let svg = Picture::new(&motion).title("A title").note("and a note").draw().expect("a picture").svg();
        legible(&svg)?;
        prop_assert_eq!(&svg, &Picture::new(&motion).title("A title").note("and a note").draw().expect("a picture").svg());
    }

    /// From 1e-300 to 1e300 there is a picture, without a number that is none.
    #[test]
    fn extreme_units_are_drawn(length in -90..90, time in -60..60) {
        let motion = motion(&[10_f64.powi(length), 1.0], 10_f64.powi(time), [1.5, 1.5, f64::INFINITY]);
        let svg = Picture::new(&motion).draw().expect("a picture").svg();
        prop_assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", svg);
    }
}

#[test]
fn limits_are_dashed_lines_with_their_value() {
    let motion = motion(&[1e-3], 0.1, [2.0, 1000.0, 20.0]);
    let svg = Picture::new(&motion).draw().expect("a picture").svg();
    let texts: Vec<String> = texts(&svg).into_iter().map(|text| text.text).collect();
    // Velocity 1.5 of 2 forward and 1 backward: both sides. Acceleration 6 of 1000: told. Jerk 12 of 20, backward only.
    assert!(texts.contains(&"limit 20 mm/s".to_owned()), "{texts:?}");
    assert!(texts.iter().any(|text| text.starts_with("limit 100 m/s²") && text.ends_with("not shown")), "{texts:?}");
    assert!(texts.contains(&"limit 20 m/s³".to_owned()), "{texts:?}");
    let dashed = dashed(&svg);
    assert!(dashed.len() == 3 && dashed.values().all(|dashes| *dashes > 20), "{dashed:?}");
}

#[test]
fn axes_share_a_panel_only_where_both_are_seen() {
    let titles = |lengths: &[f64]| {
        let svg = Picture::new(&motion(lengths, 0.1, [f64::INFINITY; 3]))
            .panels(&[Panel::Velocity])
            .draw()
            .expect("a picture")
            .svg();
        texts(&svg).into_iter().map(|text| text.text).filter(|text| text.starts_with("Velocity")).collect::<Vec<_>>()
    };
    assert_eq!(titles(&[1e-3, 2e-3]), ["Velocity (mm/s)"]);
    assert_eq!(titles(&[1e-3, 0.1]), ["Velocity of fly (mm/s)", "Velocity of step (m/s)"]);
    assert_eq!(titles(&[1e-3]), ["Velocity (mm/s)"]);
}

/// Red, green and blue of all pixels of a PNG, and how many are in a line.
#[cfg(feature = "png")]
fn pixels(png: &[u8]) -> (usize, Vec<[u8; 3]>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut bytes).expect("a frame");
    (frame.width as usize, bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect())
}

/// What the SVG says is there is there in the PNG, in its colour: letters, curves, limits; and the rest is background.
#[cfg(feature = "png")]
#[test]
fn a_png_shows_what_the_svg_says() {
    let motion = motion(&[1e-3, 2e-3], 0.1, [2.0; 3]);
    for theme in [Theme::LIGHT, Theme::DARK] {
        let mark = Mark { x: 0.0, y: 0.0, name: "<1> & \"2\"".to_owned() };
        let drawing =
            Picture::new(&motion).title("A < B & C").theme(theme).marks(vec![mark]).draw().expect("a picture");
        let (width, pixels) = pixels(&drawing.png().expect("a PNG"));
        assert_eq!(width, 960);
        let rgb = |colour: &str| [1, 3, 5].map(|at| u8::from_str_radix(&colour[at..at + 2], 16).expect("a colour"));
        let count = |colour: &str, rows: std::ops::Range<usize>| {
            pixels[rows.start * width..rows.end * width].iter().filter(|pixel| **pixel == rgb(colour)).count()
        };
        let title = &texts(&drawing.svg())[0];
        let rows = 2 * title.top as usize..2 * title.bottom as usize;
        assert!(count(theme.text, rows) > 200, "no title");
        let height = pixels.len() / width;
        assert!(theme.curves[..2].iter().all(|colour| count(colour, 0..height) > 5000), "no curves");
        assert!(count(theme.background, 0..height) > pixels.len() / 2);
    }
}

#[test]
fn many_segments_make_a_small_picture() {
    let mut state = State::rest(0.0);
    let wiggle = |index: u32| {
        let segment = Segment::with_jerk(state, 1e-3, if index % 4 < 2 { 1.0 } else { -1.0 });
        state = segment.end;
        segment
    };
    let many = Motion::new(vec![Axis {
        name: "x".to_owned(),
        profile: profile((0..100_000).map(wiggle).collect()),
        limits: Limits::NONE,
    }]);
    let svg = Picture::new(&many).draw().expect("a picture").svg();
    assert!(svg.len() < 400_000, "{} bytes", svg.len());
}

#[test]
fn what_cannot_be_drawn_is_said() {
    let one = motion(&[1.0], 1.0, [1.0; 3]);
    let refused = |picture: Picture| picture.draw().expect_err("refused").to_string();
    assert!(refused(Picture::new(&one).panels(&[])).contains("no panel"));
    assert!(refused(Picture::new(&one).panels(&[Panel::Path])).contains("two axes"));
    assert!(refused(Picture::new(&Motion::new(Vec::new()))).contains("no axes"));
    let still = Axis {
        name: "x".to_owned(),
        profile: profile(vec![Segment::with_jerk(State::rest(1.0), 0.0, 0.0)]),
        limits: Limits::NONE,
    };
    assert!(refused(Picture::new(&Motion::new(vec![still]))).contains("no time"));
    let folder = tempfile::tempdir().expect("a folder");
    let error = Picture::new(&one).save(&folder.path().join("a.bmp")).expect_err("no such format");
    assert!(error.to_string().ends_with("a picture is a file that ends in .svg, .png or .html"));
    assert!(matches!(Picture::new(&one).save(&folder.path().join("none/a.svg")), Err(PlotError::Io(_))));
}

#[test]
fn an_axis_at_rest_and_one_far_away_are_drawn() {
    let still = |position: f64| profile(vec![Segment::with_jerk(State::rest(position), 1.0, 0.0)]);
    let axis = |name: &str, position| Axis { name: name.to_owned(), profile: still(position), limits: Limits::NONE };
    let motion = Motion::new(vec![axis("x", 0.0), axis("y", 1e9)]);
    let svg = Picture::new(&motion).draw().expect("a picture").svg();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

#[test]
fn charts_take_what_has_a_place_on_their_scales() {
    let chart = |points: Vec<(f64, f64)>, logarithmic| Chart {
        title: "t".to_owned(),
        note: String::new(),
        x_title: "x".to_owned(),
        y_title: "y".to_owned(),
        logarithmic,
        series: vec![Series { name: "s".to_owned(), points }],
        theme: Theme::LIGHT,
    };
    for logarithmic in [(false, false), (true, true)] {
        for points in [vec![(1.0, 1.0)], vec![(1e-12, 1.0), (1e12, 1e3)], vec![(2.0, 3.0), (2.0, 4.0)]] {
            let svg = chart(points, logarithmic).draw().expect("a chart").svg();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
    }
    assert!(chart(vec![], (false, false)).draw().is_err());
    assert!(chart(vec![(0.0, 1.0)], (true, false)).draw().is_err());
    assert!(chart(vec![(0.0, f64::NAN)], (false, false)).draw().is_err());
}
