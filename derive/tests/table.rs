//! Tables: what the macro emits is what the reader of kernels lowers, and it computes what the function computes.

use closedform::{Aim, Certified, Domain, kernel, settle};

/// Everything that a table can hold.
#[kernel]
pub fn everything(x: f64, y: f64, unused: f64) -> f64 {
    require!(!(x <= 0.0) && (y > -2.0 || x > 5.0));
    require!(compensated!(x * x - y * y) != 0.0);
    let root = sqrt(x) + abs(y) / PI;
    let idle = x + 1.0;
    let largest = max(root, y, -x);
    let polynomial = positive_root([-x, 1.0, if y > 0.0 { y } else { min(1.0, x) }]);
    let sum = compensated!((x - 3.0) * (x + 3.0) - x * x);
    largest * polynomial + residual!(x * y - 1.0) + cbrt(sum)
}

/// The rest, and the results of a struct.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Two {
    /// The first.
    pub first: f64,
    /// The second.
    pub second: f64,
}

/// Two results.
#[kernel]
pub fn two(x: f64) -> Two {
    Two { first: 1.0 / x, second: x }
}

fn settled<const M: usize>(kernel: closedform::Kernel, inputs: &[f64]) -> (Domain, [Certified; M]) {
    let mut results = [Certified::default(); M];
    let domain = settle(kernel.table().expect("a table"), inputs, Aim::Nearest, &mut results);
    (domain, results)
}

#[test]
fn tables_compute_what_kernels_compute() {
    for (x, y) in [(2.0, 1.0), (2.0, -1.0), (7.5, -3.0), (0.1, 0.3), (1e-3, 20.0)] {
        let (domain, [result]) = settled(everything::KERNEL, &[x, y, 0.0]);
        assert_eq!(domain, Domain::Inside);
        let (value, faithful) = (result.rounded.value, everything::faithful(x, y, 0.0));
        assert!((value - faithful).abs() <= faithful.abs() * f64::EPSILON, "{value} and {faithful}");
        assert!(result.error <= value.abs() * f64::EPSILON * 0.51, "{}", result.error);
    }
    let (domain, [first, second]) = settled(two::KERNEL, &[3.0]);
    assert_eq!(
        (domain, first.rounded.value, second.rounded.value, second.error),
        (Domain::Inside, 1.0 / 3.0, 3.0, 0.0)
    );
}

#[test]
fn tables_say_which_condition_fails() {
    let domain = |x, y| settled::<1>(everything::KERNEL, &[x, y, 0.0]).0;
    assert_eq!(domain(-1.0, 0.0), Domain::Outside(0));
    assert_eq!(domain(4.0, -2.0), Domain::Outside(0));
    assert_eq!(domain(6.0, -2.0), Domain::Inside);
    assert_eq!(domain(1e-200, 1e-200), Domain::Outside(1), "an exact zero");
    assert_eq!(domain(1e-200, 1.1e-200), Domain::Inside, "a square that underflows");
}

#[test]
fn emitted_tables_are_the_lowered_ones() {
    let source = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/table.rs")).unwrap();
    let kernels = closedform_syntax::parse_file(&source).unwrap();
    assert_eq!(kernels.len(), 2);
    for (kernel, emitted) in kernels.iter().zip([everything::KERNEL, two::KERNEL]) {
        let lowered = closedform_syntax::lowered(kernel).expect("a table");
        lowered.with(|table| assert_eq!(Some(table), emitted.table()));
    }
}
