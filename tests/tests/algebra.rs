//! Every program, run in MPFR, equals Maxima's own numbers to all their digits.

use closedform_tests::algebra::check_golden;
use closedform_tests::{golden, kernels, parallel};

#[test]
fn programs_equal_golden_values() {
    let failures: Vec<String> = parallel::map(&kernels::judges(), |judge| {
        let checked = check_golden(judge, &golden::load(judge.kernel.info.family));
        checked.map(|judged| assert!(judged > 0, "{}: no golden values", judge.kernel.info.name)).err()
    })
    .into_iter()
    .flatten()
    .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
