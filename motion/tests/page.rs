//! Pages: the numbers in them are those of the motion, and text from elsewhere stays text.

use closedform_motion::plan::fastest::{Together, together};
use closedform_motion::plot::{Panel, Picture, PlotError, Theme};
use closedform_motion::{Limits, Motion, State};
use serde_json::Value;

fn motion() -> Motion {
    let limits = Limits { velocity: 0.1, acceleration: 2.0, jerk: 100.0 };
    let axis =
        |name: &str, to| Together { name: name.to_owned(), start: State::rest(0.0), end: State::rest(to), limits };
    together(&[axis("x", 0.02), axis("y", -0.01), axis("still", 0.0)], None).expect("a motion")
}

fn data(html: &str) -> Value {
    let start = "<script type=\"application/json\" id=\"data\">";
    let text = html.split_once(start).expect("data").1.split_once("</script>").expect("an end").0;
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn a_page_has_the_numbers_of_the_motion() {
    let motion = motion();
    let page = Picture::new(&motion).title("A </script> & B").page().expect("a page");
    let html = page.html().expect("text");
    assert!(html.contains("<title>A &lt;/script&gt; &amp; B</title>") && html.matches("</script>").count() == 2);
    assert!(!html.contains("{{") && !html.contains("http://") || html.contains("www.w3.org/2000/svg"));
    let data = data(&html);
    // an axis that never moves is left out
    assert_eq!(data["names"], serde_json::json!(["x", "y"]));
    let panels = data["panels"].as_array().expect("panels");
    assert_eq!(panels.len(), 5);
    assert!(panels[0]["arrows"] == true && panels[0]["linked"] == false);
    let velocity = &panels[2]["curves"][0];
    let (times, values) = (velocity["x"].as_array().expect("x"), velocity["y"].as_array().expect("y"));
    assert_eq!(times.len(), values.len());
    for (time, value) in times.iter().zip(values) {
        let (time, value) = (time.as_f64().expect("a time") * 1e-3, value.as_f64().expect("a value") * 1e-3);
        let right = motion.axes()[0].profile.at(time).velocity;
        assert!((value - right).abs() < 1e-6 * 0.1, "{time}: {value} and {right}");
    }
}

#[test]
fn a_page_is_dark_or_as_the_screen_is() {
    let motion = motion();
    let html = |theme| Picture::new(&motion).theme(theme).page().expect("a page").html().expect("text");
    assert!(html(Theme::LIGHT).contains("prefers-color-scheme: dark"));
    assert!(html(Theme::DARK).contains("color-scheme: dark;") && !html(Theme::DARK).contains("prefers-color-scheme"));
}

#[test]
fn what_cannot_be_drawn_makes_no_page() {
    let motion = motion();
    assert!(matches!(Picture::new(&motion).panels(&[]).page(), Err(PlotError::Empty { .. })));
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.html");
    Picture::new(&motion).panels(&[Panel::Velocity]).save(&path).expect("written");
    assert!(std::fs::read_to_string(&path).expect("a page").starts_with("<!DOCTYPE html>"));
}
