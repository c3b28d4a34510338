//! Formulas with elementary functions, steps and branches become kernels that certify every call, and keep their bounds where digits cancel.

mod common;

use closedform_measure::accuracy::{Reference, measure, results};
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_project::Project;
use common::{repository, succeeds, turn};

fn generated() -> (tempfile::TempDir, Catalogue) {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (worksheet, out) = (repository().join("codegen/command/tests/elementary.mac"), folder.path().join("made"));
    let [input, out_folder] = [&worksheet, &out].map(|path| path.to_str().unwrap());
    succeeds(&repository(), &["generate", "--strict", "--input", input, "--out", out_folder]);
    let catalogue = Catalogue::open(&Project::at(&out).unwrap()).unwrap();
    (folder, catalogue)
}

/// Values between 2^-20 and 2^8, those of an input where its formula cancels, and large ones.
fn values(entry: &Entry) -> Vec<f64> {
    let ordinary = (0..40).map(|k| f64::powi(2.0, k * 28 / 40 - 20) * (1.0 + f64::from(k % 7) / 7.0));
    let cancelling = [1e-8, 1e-16, 1e-300, 0.5, 1.0 - 1e-12, 1.0, 1.5, std::f64::consts::PI, 355.0, 1e22];
    let of_domain = |x: &f64| entry.inputs().len() > 1 || entry.domain().unwrap().holds(&[*x]);
    ordinary.chain(cancelling).flat_map(|x| [x, -x]).filter(of_domain).collect()
}

/// Each value for the first input, beside others for the rest.
fn points(entry: &Entry) -> Vec<Vec<f64>> {
    let (values, inputs) = (values(entry), entry.inputs().len());
    let at = |first: usize, input: usize| values[(first + 7 * input * (1 + first % 3)) % values.len()];
    let points = (0..values.len()).map(|first| (0..inputs).map(|input| at(first, input)).collect::<Vec<f64>>());
    points.filter(|point| entry.domain().unwrap().holds(point)).collect()
}

#[test]
fn every_formula_is_made_and_keeps_its_bound() {
    let (_folder, catalogue) = generated();
    for entry in catalogue.entries() {
        let (reference, mut judged) = (Reference::of(&entry.kernel).unwrap(), 0);
        for point in points(entry) {
            // what the largest floats do not hold is told by `checked`
            let Ok(exact) = reference.values(&point, 200) else { continue };
            let exact = exact[0].to_f64();
            if !exact.is_normal() {
                continue;
            }
            let measured = measure(&entry.kernel, &reference, std::slice::from_ref(&point), || ()).unwrap();
            let worst = measured.worst[0].as_ref().unwrap();
            assert!(worst.ulp <= 0.51, "{}: {} ulp at {point:?}, {exact:e} is right", entry.name, worst.ulp);
            judged += 1;
        }
        assert!(judged > 10, "{}: {judged} points", entry.name);
    }
}

#[test]
fn values_that_are_rational_are_exact() {
    let (_folder, catalogue) = generated();
    let value = |name: &str, point: &[f64]| results(&catalogue.find(name).unwrap().kernel, point).unwrap()[0];
    assert_eq!(value("versine", &[0.0]), 0.0);
    assert_eq!(value("gap", &[0.0]), 0.0);
    assert_eq!(value("decay", &[0.0, 3.0]), 0.0);
    assert_eq!(value("sigmoid", &[0.0]), 0.5);
    assert_eq!(value("fifth", &[1.0]), 2.0);
    assert_eq!(value("fraction", &[-0.25]), 0.75);
    assert_eq!(value("ticks", &[2.5, 1.0]), 2.0);
}

#[test]
fn branches_are_taken_at_their_edges() {
    let (_folder, catalogue) = generated();
    let value = |name: &str, point: &[f64]| results(&catalogue.find(name).unwrap().kernel, point).unwrap()[0];
    assert_eq!(value("sinc", &[0.0]), 1.0);
    assert_eq!(value("guarded", &[9.0]), 8.0_f64.sqrt());
    assert!(value("guarded", &[9.0_f64.next_up()]) < 1.0 / 82.0, "the other side, beyond 9");
    assert_eq!([-1.0, 0.0, 1.0, 2.0].map(|x| value("tent", &[x])), [0.0, 1.0, 0.0, 1.0]);
    assert_eq!([-3.0, -2.0, 1.0].map(|r| value("huber", &[r, 2.0])), [4.0, 2.0, 0.5]);
    let pi = std::f64::consts::PI;
    assert_eq!([[-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(|point| value("slope", &point)), [pi, pi / 2.0, -pi / 2.0]);
    assert!(results(&catalogue.find("slope").unwrap().kernel, &[0.0, 0.0]).is_err(), "the origin has no angle");
    assert_eq!(value("sided", &[0.0]), 0.0);
}
