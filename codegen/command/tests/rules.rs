//! Every rule by numbers: a formula that needs it loses digits as written and keeps them by the rule.

mod common;

use closedform_generator::stable::strategy::ALL;
use closedform_maxima::{BinaryOperator, Definition, Expr, ExprKind, UnaryOperator, definitions};
use closedform_measure::accuracy::{REFERENCE_BITS, Reference, covers, measure, ulp_error};
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_project::Project;
use closedform_project::sample::sample;
use common::{repository, succeeds, turn};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The rules that save operations, or some last ulp: without them no formula loses its digits.
const NO_RESCUE: [&str; 7] =
    ["distributed", "double-double", "fused", "known-sum", "merge-cubes", "merge-roots", "one-reciprocal"];

/// What the formula as written must be off by, in ulp, for a rule to be worth its name.
const LOST: f64 = 1000.0;

fn generated() -> (tempfile::TempDir, Catalogue) {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let worksheet: PathBuf = repository().join("codegen/command/tests/rules/rules.mac");
    let out = folder.path().join("made");
    succeeds(&repository(), &["generate", "--input", worksheet.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let catalogue = Catalogue::open(&Project::at(&out).unwrap()).unwrap();
    (folder, catalogue)
}

#[test]
fn every_rule_keeps_digits_that_the_plain_form_loses() {
    let (_folder, catalogue) = generated();
    for rule in ALL {
        let entry = catalogue.find(&format!("needs_{}", rule.name.replace('-', "_"))).unwrap();
        assert!(
            entry.kernel.meta.rules.iter().any(|name| name == rule.name),
            "{} is not made by {}",
            entry.name,
            rule.name
        );
        let points = points(entry);
        let reference = Reference::of(&entry.kernel).unwrap();
        let measured = measure(&entry.kernel, &reference, &points, || ()).unwrap();
        for (result, worst) in entry.kernel.meta.results.iter().zip(&measured.worst) {
            let worst = worst.as_ref().unwrap();
            assert!(worst.ulp <= result.bound.unwrap(), "{}: {} ulp at {:?}", rule.name, worst.ulp, worst.inputs);
        }
        if !NO_RESCUE.contains(&rule.name) && rule.name != "monotone-newton" {
            let lost = worst_plain(entry, &reference, &points);
            assert!(
                lost > LOST,
                "{}: the formula as written loses only {lost} ulp, so this test shows nothing",
                rule.name
            );
        }
    }
}

/// Points that a sampler does not find: near a zero of the formula, not of an input or a condition.
fn hurting(rule: &str) -> Vec<Vec<f64>> {
    let power = |exponent| 2.0_f64.powi(exponent);
    match rule {
        "needs_compensated" => vec![vec![1.0 + power(-17) + power(-40), 1.0 - power(-17), 1.0, 1.0]],
        "needs_certified" => vec![vec![1.0 + power(-30), 4.0 + power(-30), 4.0, 1.0]],
        "needs_conjugate" | "needs_cube_conjugate" => vec![vec![1e12]],
        "needs_cube_quotient" => vec![vec![1.0, 1.0 + power(-30)], vec![-7.0, -7.0 - power(-30)]],
        "needs_differences_first" => {
            vec![vec![1.0, 1.0 + power(-27), 3.0 * power(-27) / 0.7 * (1.0 + power(-20)), 0.7]]
        }
        _ => Vec::new(),
    }
}

fn points(entry: &Entry) -> Vec<Vec<f64>> {
    let mut points = sample(&entry.domain().unwrap(), &entry.inputs().iter().collect::<Vec<_>>(), 400, 3).unwrap();
    points.extend(hurting(&entry.name));
    points.into_iter().filter(|point| covers(&entry.kernel, point)).collect()
}

/// The worst error of the formulas as written, evaluated in `f64`.
fn worst_plain(entry: &Entry, reference: &Reference, points: &[Vec<f64>]) -> f64 {
    let text: String = entry.kernel.meta.maxima.as_deref().unwrap().lines().map(|line| format!("{line}$\n")).collect();
    let formulas = definitions(&text).unwrap();
    let mut worst: f64 = 0.0;
    for point in points {
        let exact = reference.values(point, REFERENCE_BITS).unwrap();
        for (formula, exact) in formulas.iter().zip(&exact) {
            worst = worst.max(ulp_error(plain(formula, point), exact));
        }
    }
    worst
}

fn plain(formula: &Definition, point: &[f64]) -> f64 {
    let names = formula.parameters.iter().map(String::as_str).zip(point.iter().copied()).collect();
    value(&formula.body, &names)
}

fn value(expr: &Expr, names: &BTreeMap<&str, f64>) -> f64 {
    let of = |expr| value(expr, names);
    match &expr.kind {
        ExprKind::Integer(number) => number.to_string().parse().unwrap(),
        ExprKind::Symbol(name) => names[name.as_str()],
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => -of(operand),
        ExprKind::Binary { operator, left, right } => match operator {
            BinaryOperator::Add => of(left) + of(right),
            BinaryOperator::Subtract => of(left) - of(right),
            BinaryOperator::Multiply => of(left) * of(right),
            BinaryOperator::Divide => of(left) / of(right),
            BinaryOperator::Power if of(right) == 1.0 / 3.0 => of(left).cbrt(),
            BinaryOperator::Power => of(left).powf(of(right)),
            _ => panic!("{expr:?}"),
        },
        ExprKind::Call { .. } => match expr.as_call() {
            Some(("sqrt", [operand])) => of(operand).sqrt(),
            _ => panic!("{expr:?}"),
        },
        _ => panic!("{expr:?}"),
    }
}
