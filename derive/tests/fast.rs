//! Hand-written kernels, naive ones too: `fast` keeps its promise, and `with_bound` its bound, whatever the body.

use closedform::{FAST_PROMISE, Mpfr, kernel};

/// A root by the textbook's formula, which cancels.
#[kernel]
pub fn naive(a: f64, t: f64, d: f64) -> f64 {
    require!(a > 0.0 && t >= 0.0 && d > 0.0);
    sqrt(a * (a * t * t + 2.0 * d)) - a * t
}

/// A domain whose condition is rounded.
#[kernel]
pub fn edge(a: f64, b: f64, c: f64) -> f64 {
    require!(a * b - c >= 0.0);
    sqrt(a * b - c)
}

/// A branch for each sign of a rounded number.
#[kernel]
pub fn branch(x: f64, y: f64) -> f64 {
    require!(y > 0.0);
    if x * x - y * y > 0.0 { (x * x - y * y) / y } else { abs(x - y) }
}

/// The root of a polynomial whose coefficients are rounded.
#[kernel]
pub fn root(a: f64, b: f64) -> f64 {
    require!(a > 0.0 && b > 0.0);
    positive_root([-a * b, a - b, a + b / 3.0])
}

/// Numbers with few bits, whose sums cancel, and others.
fn numbers() -> Vec<f64> {
    let mut list: Vec<f64> = [1.0, 2.0, 3.0, 0.1, 1e-3, 1e3, 7.7, 1e-9, 1e9, 1e-40, 1e40].to_vec();
    list.extend([1.0_f64.next_up(), 1.0_f64.next_down(), 2.0_f64.next_up()]);
    list
}

/// The value in MPFR; `None` where it is not a number.
fn exact<const N: usize>(inputs: [f64; N], evaluate: fn(&[Mpfr; N]) -> [Mpfr; 1]) -> rug::Float {
    evaluate(&inputs.map(|input| Mpfr::new(4000, input)))[0].0.clone()
}

/// Demands that both calls keep what they say.
fn demand(exact: &rug::Float, fast: f64, (value, error): (f64, f64), inputs: &[f64]) {
    let off = |value: f64| rug::Float::with_val(4000, exact - value).abs();
    assert!(off(fast) <= exact.clone().abs() * FAST_PROMISE, "{inputs:?}: fast {fast:e}, not {exact:.30}");
    assert!(off(value) <= error, "{inputs:?}: {value:e} +- {error:e}, not {exact:.30}");
}

#[test]
fn a_naive_formula_keeps_the_promise() {
    for a in numbers() {
        for t in numbers() {
            for d in numbers() {
                let exact = exact([a, t, d], naive::evaluate);
                demand(&exact, naive::fast(a, t, d), naive::with_bound(a, t, d), &[a, t, d]);
            }
        }
    }
}

#[test]
fn a_rounded_condition_is_decided_as_it_is_written() {
    let inside = |a: f64, b: f64, c: f64| !edge::fast(a, b, c).is_nan();
    let (up, down) = (1.0_f64.next_up(), 1.0_f64.next_down());
    // (1 + 2^-52)(1 - 2^-53) = 1 + 2^-53 - 2^-105
    assert!(inside(up, down, 1.0));
    assert!(!inside(1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 1.0));
    assert!(inside(1.0, 1.0, 1.0) && !inside(1.0, down, 1.0));
    assert_eq!(edge::fast(1.0, 1.0, 1.0), 0.0);
    let exact = exact([up, down, 1.0], edge::evaluate);
    demand(&exact, edge::fast(up, down, 1.0), edge::with_bound(up, down, 1.0), &[up, down]);
}

#[test]
fn a_branch_on_a_rounded_number_is_the_right_one() {
    for x in numbers() {
        for y in numbers() {
            let exact = exact([x, y], branch::evaluate);
            demand(&exact, branch::fast(x, y), branch::with_bound(x, y), &[x, y]);
        }
    }
}

#[test]
fn roots_of_rounded_coefficients_keep_the_promise() {
    for a in numbers() {
        for b in numbers() {
            let exact = exact([a, b], root::evaluate);
            if exact.is_finite() {
                demand(&exact, root::fast(a, b), root::with_bound(a, b), &[a, b]);
            }
        }
    }
}

#[test]
fn outside_there_is_no_number() {
    assert!(naive::fast(-1.0, 1.0, 1.0).is_nan() && naive::fast(f64::NAN, 1.0, 1.0).is_nan());
    let (value, error) = naive::with_bound(-1.0, 1.0, 1.0);
    assert!(value.is_nan() && error.is_nan());
}

#[test]
fn a_batch_has_the_bits_of_single_calls_in_every_block() {
    let list = numbers();
    let rows: Vec<[f64; 3]> = (0..1000).map(|n| [n, n / 3, n / 7].map(|n| list[n % list.len()])).collect();
    let column = |at: usize| rows.iter().map(|row| row[at] - 0.5).collect::<Vec<f64>>();
    let (a, t, d, mut results) = (column(0), column(1), column(2), vec![0.0; rows.len()]);
    naive::fast_batch(&a, &t, &d, &mut results).expect("slices of one length");
    let alone = (0..rows.len()).map(|row| naive::fast(a[row], t[row], d[row]).to_bits());
    assert!(results.iter().zip(alone).all(|(batch, alone)| batch.to_bits() == alone || batch.is_nan()));
    assert!(results.iter().any(|value| value.is_nan()) && results.iter().any(|value| !value.is_nan()));
    naive::batch(&a, &t, &d, &mut results).expect("slices of one length");
    let alone = (0..rows.len()).map(|row| naive(a[row], t[row], d[row]).to_bits());
    assert!(results.iter().zip(alone).all(|(batch, alone)| batch.to_bits() == alone || batch.is_nan()));
}

#[test]
fn batches_of_every_length_fill_their_results_and_nothing_else() {
    for length in 0..100 {
        // outside of the domain, in doubt, and ordinary
        let numbers: Vec<f64> = (0..length).map(|row| [2.0, -1.0, 1e-30, 0.1][row % 4] + row as f64).collect();
        let mut results = vec![f64::INFINITY; length + 1];
        naive::batch(&numbers, &numbers, &numbers, &mut results[..length]).expect("slices of one length");
        let alone = |number: &f64| naive(*number, *number, *number).to_bits();
        let of_batch = results[..length].iter().map(|result| result.to_bits());
        assert!(of_batch.eq(numbers.iter().map(alone)), "{length}");
        assert_eq!(results[length], f64::INFINITY);
    }
}
