//! Ordinary formulas for which the generator has no stable form: they are made all the same, and keep their bounds.

mod common;

use closedform_measure::accuracy::{Reference, measure, results};
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_project::Project;
use closedform_project::sample::sample;
use common::{repository, succeeds, turn};

fn generated() -> (tempfile::TempDir, Catalogue) {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (worksheet, out) = (repository().join("codegen/command/tests/ordinary.mac"), folder.path().join("made"));
    succeeds(&repository(), &["generate", "--input", worksheet.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let catalogue = Catalogue::open(&Project::at(&out).unwrap()).unwrap();
    (folder, catalogue)
}

/// Points at which a formula cancels, and no sampler looks.
fn hurting(name: &str) -> Vec<Vec<f64>> {
    let near = |x: f64, steps: i32| (0..steps).fold(x, |x, _| x.next_up());
    let squares = [1.0, 3.7, 1e9].map(|y: f64| (std::f64::consts::PI * y).sqrt());
    match name {
        "circle_less_square" => squares.iter().zip([1.0, 3.7, 1e9]).map(|(x, y)| vec![*x, y]).collect(),
        "softened" => vec![vec![1e-150], vec![1e-170], vec![1e150], vec![0.0]],
        "beyond" => vec![vec![-1e300], vec![-near(1e300, 1)], vec![1e284]],
        "tiny_square" => vec![vec![1e-150], vec![near(1e-150, 2)]],
        "chebyshev16" => (0..16).map(|k| vec![(f64::from(2 * k + 1) * std::f64::consts::PI / 32.0).cos()]).collect(),
        "four_roots" => vec![vec![2.0, 3.0, near(3.0, 1), 2.0], vec![10.0, 11.0, 5.0, 18.0], vec![1e8, 0.1, 1e8, 0.2]],
        "four_differences" => vec![vec![1e12; 4], vec![0.0; 4], vec![1e300, 1.0, 2.0, 3.0]],
        "hohmann" => vec![vec![1.0, 1.0, near(1.0, 3)], vec![4e14, 7e6, 7e6 + 1e-6]],
        "one_and_largest" => vec![vec![2.0], vec![near(2.0, 1)], vec![-1e300]],
        _ => Vec::new(),
    }
}

#[test]
fn every_one_is_made_and_keeps_its_bound() {
    let (_folder, catalogue) = generated();
    for entry in catalogue.entries() {
        let bound = entry.kernel.meta.results[0].bound.unwrap();
        assert!(bound <= 2.0, "{}: {bound}", entry.name);
        let mut points = sample(&entry.domain().unwrap(), &entry.inputs().iter().collect::<Vec<_>>(), 200, 5).unwrap();
        points.extend(hurting(&entry.name));
        let measured = measure(&entry.kernel, &Reference::of(&entry.kernel).unwrap(), &points, || ()).unwrap();
        let worst = measured.worst[0].as_ref().unwrap();
        assert!(worst.ulp <= bound, "{}: {} ulp at {:?}", entry.name, worst.ulp, worst.inputs);
    }
}

fn value(entry: &Entry, point: &[f64]) -> f64 {
    results(&entry.kernel, point).unwrap_or_else(|violation| panic!("{}: {violation:?}", entry.name))[0]
}

#[test]
fn what_is_exactly_zero_is_zero() {
    let (_folder, catalogue) = generated();
    let zero = |name: &str, point: &[f64]| assert_eq!(value(catalogue.find(name).unwrap(), point), 0.0, "{name}");
    zero("twice_negative", &[3.7]);
    zero("twice_negative", &[1e-300]);
    zero("no_sign", &[0.3]);
    zero("four_roots", &[2.0, 3.0, 3.0, 2.0]);
    zero("four_roots", &[0.1, 7.3, 7.3, 0.1]);
    // 2 sqrt(2) + sqrt(2) = 3 sqrt(2)
    zero("four_roots", &[8.0, 2.0, 18.0, 0.0]);
    zero("hohmann", &[398_600.0, 7_000.0, 7_000.0]);
    let no_sign = catalogue.find("no_sign").unwrap();
    assert_eq!(value(no_sign, &[-0.3]), 2.0);
    assert_eq!(value(catalogue.find("no_power").unwrap(), &[0.0, 4.0]), 5.0, "x^0 is 1");
}
