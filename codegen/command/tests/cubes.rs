//! Cube roots through the whole road: kernels of a worksheet, held to their bounds where they cancel, vanish and change sign.

mod common;

use closedform_measure::accuracy::{Reference, measure, results};
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_project::sample::sample;
use closedform_syntax::Precision;
use common::{repository, succeeds, turn};

fn generated() -> (tempfile::TempDir, Catalogue) {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (worksheet, out) = (repository().join("codegen/command/tests/cubes.mac"), folder.path().join("made"));
    succeeds(&repository(), &["generate", "--input", worksheet.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let catalogue = Catalogue::open(&closedform_project::Project::at(&out).unwrap()).unwrap();
    (folder, catalogue)
}

/// Points at which a formula cancels or nearly vanishes, of all signs and sizes.
fn hurting(name: &str) -> Vec<Vec<f64>> {
    let pairs = |x: f64| [[x, x.next_up()], [x, -x], [-x, -x.next_down()], [x, 1e-300], [0.0, x]].map(Vec::from);
    match name {
        "apart" | "squares_apart" | "over_difference" => [1.0, 3e-200, 7e250].into_iter().flat_map(pairs).collect(),
        "step_of_roots" => vec![vec![1.0, 1e-17], vec![-1.0, 1e-9], vec![0.0, 8.0], vec![5.0, -5.0], vec![1e200, 1.0]],
        "near_one" | "nested" => [1e-300, 1e-20, 1e-9, 0.5, 7.0].map(|x| vec![x]).to_vec(),
        "minus" | "magnitude" | "reciprocal" => [1e-310, -1e-310, 27.0, -27.0, 1e308].map(|x| vec![x]).to_vec(),
        "ratio" => vec![vec![-1.0, 8.0], vec![1e300, -1e-300], vec![0.0, 3.0]],
        "semi_major" => vec![vec![3.986e14, 86_164.1], vec![-1.0, 2.0], vec![1e-300, 1e-300]],
        "cardano_term" => vec![vec![3.0, -1e9], vec![1e-9, 2.0], vec![1e-9, -2.0]],
        "cardano" => vec![vec![3.0, 1e-12], vec![3.0, 4.0], vec![1e-6, -1e6]],
        "three" => vec![vec![1.0, 1.0, 8.0_f64.next_up()], vec![2.0, 3.0, 19.34]],
        _ => Vec::new(),
    }
}

/// What has no stable form: three terms with cube roots of which one stands against two. And what vanishes on one side of an
/// `if`, which no proof that leaves conditions out finds equal to the formula.
const CERTIFIED: [&str; 2] = ["magnitude", "three"];

#[test]
fn every_one_keeps_its_bound() {
    let (_folder, catalogue) = generated();
    let mut certified = Vec::new();
    for entry in catalogue.entries() {
        let bound = entry.kernel.meta.results[0].bound.unwrap();
        assert!(bound <= 2.0, "{}: {bound}", entry.name);
        let mut points = sample(&entry.domain().unwrap(), &entry.inputs().iter().collect::<Vec<_>>(), 300, 5).unwrap();
        points.extend(hurting(&entry.name));
        let measured = measure(&entry.kernel, &Reference::of(&entry.kernel).unwrap(), &points, || ()).unwrap();
        let worst = measured.worst[0].as_ref().unwrap();
        assert!(worst.ulp <= bound, "{}: {} ulp at {:?}", entry.name, worst.ulp, worst.inputs);
        certified.extend((entry.kernel.meta.precision == Precision::Certified).then_some(entry.name.clone()));
    }
    assert_eq!(certified, CERTIFIED);
}

fn value(entry: &Entry, point: &[f64]) -> f64 {
    results(&entry.kernel, point).unwrap_or_else(|violation| panic!("{}: {violation:?}", entry.name))[0]
}

#[test]
fn roots_of_negative_numbers_are_real_and_zeros_are_zero() {
    let (_folder, catalogue) = generated();
    let value = |name: &str, point: &[f64]| value(catalogue.find(name).unwrap(), point);
    assert_eq!(value("ratio", &[-8.0, 27.0]), 4.0 / 9.0);
    assert_eq!(value("reciprocal", &[-8.0]), -0.5);
    assert_eq!(value("apart", &[-27.0, 8.0]), -5.0);
    assert_eq!(value("apart", &[0.3, 0.3]), 0.0);
    assert_eq!(value("squares_apart", &[0.3, -0.3]), 0.0);
    assert_eq!(value("magnitude", &[-0.3]), 0.0);
    assert_eq!(value("three", &[1.0, 8.0, 27.0]), 0.0);
    assert_eq!(value("three", &[-0.3, 0.3, 0.0]), 0.0);
    assert_eq!(value("cardano", &[1.7, 0.0]), 0.0);
    assert!(value("apart", &[1.0, 0.0]) == 1.0 && value("apart", &[0.0, -1.0]) == 1.0);
}
