//! What `#[kernel]` emits, called in every shape.

use closedform::{CallError, LengthError, Mpfr, Real, ValueError, kernel};
use closedform_arith::tier::{self, Rounded, Steps};
use closedform_syntax::{Kernel, Violation};

/// The text between `source!` braces both compiled and kept, so that the interpreter reads what the macro read.
macro_rules! source {
    ($($item:item)*) => {
        $($item)*
        const SOURCE: &str = stringify!($($item)*);
    };
}

source! {
    /// Time of the ramp in
    /// of a turn-around.
    ///
    /// More.
    #[kernel(
        family = "turnaround",
        maxima = "tInFn(tOut) := ..",
        latex = "t",
        source = "2.3.1 %o50",
        rules("conjugate", "compensated"),
        bound = 6.01,
        certificate = "1-eb2a753ef912f47f",
        result(worksheet = "tInFn", unit = "s")
    )]
    pub fn t_in(
        #[input(maxima = "tOut", unit = "s", typical(1e-4, 1e-1))] t_out: f64,
        #[input(maxima = "a2Max", unit = "m/s^2", typical(0.1, 50.0))] a2_max: f64,
        d: f64,
    ) -> f64 {
        require!(a2_max > 0.0, "a2Max > 0");
        require!(compensated!(3.0 * d - a2_max * t_out * (2.0 * t_out)) > 0.0 && (d < 1e9 || !(t_out >= 0.0)));
        let tau = 2.0 * t_out;
        let n = compensated!(3.0 * d - a2_max * t_out * tau);
        n / (sqrt(tau * tau + d) + abs(tau)) + PI
    }

    /// Two results.
    #[kernel(
        family = "turnaround",
        bound(t1 = 0.5, a1 = 5.01),
        certificate = "1-793e6608cd034f8c",
        results(a1(worksheet = "a1Fn", unit = "m"), t1(unit = "s"))
    )]
    fn ramp(x: f64, out: f64) -> Ramp {
        require!(x != out);
        let t1 = if x < out && x <= 1.0 || out == 3.0 { abs(x) } else if x > out { -x } else { x / out };
        Ramp { t1, a1: positive_root([-abs(out) - 1.0, 0.0, x * x + 0.5]) }
    }

    /// Every combination of kinds inside a compensated expression.
    #[kernel]
    pub fn sums(a: f64, b: f64) -> f64 {
        compensated!(
            -(a * b - (-a + b)) * (a + 2.0) - -b * (a * a + b) + 3.0 * -(b - 1.0) + a + (0.5 + (a + b))
                - ((a - b) * (a + b) - b * b * b)
        )
    }

    /// Rounded once.
    #[kernel(precision = "double-double", bound = 0.51, certificate = "1-511fda88e0911232")]
    pub fn precise(a: f64, b: f64) -> f64 {
        require!(compensated!(a * b - 1.0) != 0.0 && (a - b) * (a + b) > 0.0);
        let root = sqrt(a * a + b * b);
        a * root / compensated!(a * b - 1.0)
    }

    /// Names that the expansion uses itself.
    #[kernel]
    pub fn inputs(inputs: f64, results: f64, sums: f64, context: f64, length: f64, value_0: f64, f32: f64) -> f64 {
        let batch = inputs + results;
        let checked = batch - sums * context;
        let evaluate = checked / length;
        let domain = compensated!(evaluate - value_0 * f32);
        domain
    }
}

/// What `ramp` returns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    t1: f64,
    a1: f64,
}

fn interpreted(name: &str) -> Kernel {
    let kernels = closedform_syntax::parse_file(SOURCE).expect("the source above is kernel language");
    kernels.into_iter().find(|kernel| kernel.name == name).expect("the kernel is in the source above")
}

/// Reproducible numbers of mixed magnitude and sign.
fn samples(count: usize) -> Vec<f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    let special = [0.0, -0.0, 1.0, 3.0, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE, 1e300, -1e-300];
    let random = std::iter::repeat_with(|| {
        let mantissa = (next() >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
        mantissa * 2f64.powi((next() % 20) as i32 - 10)
    });
    special.into_iter().chain(random).take(count).collect()
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

#[test]
fn a_value_inside_the_domain() {
    let expected = (3.0 * 2.0 - 0.5 * 0.25 * 0.5) / ((0.25f64 + 2.0).sqrt() + 0.5) + std::f64::consts::PI;
    assert_eq!(t_in(0.25, 0.5, 2.0), expected);
    assert_eq!(t_in::checked(0.25, 0.5, 2.0), Ok(expected));
}

#[test]
fn outside_the_domain_a_value_is_nan_and_the_error_names_the_condition() {
    assert!(t_in(0.25, -0.5, 2.0).is_nan());
    let Err(ValueError::Domain(error)) = t_in::checked(0.25, -0.5, 2.0) else { panic!("outside") };
    assert_eq!(error.kernel(), "turnaround::t_in");
    assert_eq!(error.condition(), "a2Max > 0");
    assert_eq!(error.inputs().collect::<Vec<_>>(), [("t_out", 0.25), ("a2_max", -0.5), ("d", 2.0)]);
    let text =
        "turnaround::t_in: outside the domain: `a2Max > 0` does not hold for t_out = 0.25, a2_max = -0.5, d = 2.0";
    assert_eq!(error.to_string(), text);
}

#[test]
fn a_condition_without_text_names_itself() {
    let error = t_in::checked(1.0, 1.0, 0.5).unwrap_err();
    let text = "compensated!(3.0 * d - a2_max * t_out * (2.0 * t_out)) > 0.0 && (d < 1000000000.0 || !(t_out >= 0.0))";
    assert_eq!(error.condition(), Some(text));
}

#[test]
fn every_input_must_be_finite() {
    assert!(inputs(1.0, 1.0, 1.0, 1.0, 1.0, f64::INFINITY, 0.0).is_nan());
    assert_eq!(sums::checked(f64::INFINITY, 0.0).unwrap_err().condition(), Some("every input is finite"));
    assert!(sums::checked(f64::NAN, 0.0).is_err());
}

#[test]
fn a_struct_is_nan_in_every_field_outside_the_domain() {
    let Ramp { t1, a1 } = ramp(1.0, 1.0);
    assert!(t1.is_nan() && a1.is_nan());
    assert_eq!(ramp::checked(1.0, 1.0).unwrap_err().condition(), Some("x != out"));
    assert_eq!(ramp::checked(0.5, 2.0), Ok(ramp(0.5, 2.0)));
    assert_eq!(ramp(0.5, 2.0), Ramp { t1: 0.5, a1: 2.0 });
}

#[test]
fn batches_are_bit_identical_to_single_calls() {
    let x = samples(1000);
    let y: Vec<f64> = x.iter().rev().copied().collect();
    let mut t1 = vec![0.0; x.len()];
    let mut a1 = vec![0.0; x.len()];
    ramp::batch(&x, &y, &mut t1, &mut a1).unwrap();
    let mut sliced = vec![0.0; x.len()];
    sums::batch(&x, &y, &mut sliced).unwrap();
    for row in 0..x.len() {
        let single = ramp(x[row], y[row]);
        assert!(same(single.t1, t1[row]) && same(single.a1, a1[row]), "{} {}", x[row], y[row]);
        assert!(same(sums(x[row], y[row]), sliced[row]), "{} {}", x[row], y[row]);
    }
}

#[test]
fn a_batch_needs_slices_of_equal_length() {
    let mut t1 = [0.0; 2];
    let error = ramp::batch(&[0.5, 2.0], &[2.0, 3.0], &mut t1, &mut [0.0]).unwrap_err();
    assert_eq!(error, LengthError { kernel: "turnaround::ramp", name: "a1", expected: 2, found: 1 });
    assert_eq!(error.to_string(), "turnaround::ramp: `a1` must have length 2, not 1");
    assert_eq!(t1, [0.0; 2]);
    assert_eq!(t_in::batch(&[1.0], &[], &[1.0], &mut [0.0]).unwrap_err().name, "a2_max");
}

#[test]
fn single_precision_is_rounded_once() {
    assert_eq!(t_in::f32(0.1, 0.5, 2.0), t_in(0.1f32.into(), 0.5, 2.0) as f32);
    assert_eq!(ramp::f32(0.5, 2.0), [0.5, 2.0]);
    assert!(t_in::f32(0.1, -0.5, 2.0).is_nan());
}

#[test]
fn the_interpreter_agrees_bit_for_bit() {
    let [t_in_read, ramp_read, sums_read] = ["t_in", "ramp", "sums"].map(interpreted);
    let numbers = [samples(300), extremes(3000)].concat();
    for window in numbers.windows(3) {
        let &[a, b, c] = window else { continue };
        agree(&t_in_read, &[a, b, c], &t_in::KERNEL);
        agree(&ramp_read, &[a, b], &ramp::KERNEL);
        agree(&sums_read, &[a, b], &sums::KERNEL);
    }
}

/// Reproducible numbers of all exponents, subnormal ones among them.
fn extremes(count: usize) -> Vec<f64> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let random = std::iter::repeat_with(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from_bits(state ^ state >> 29)
    });
    random.filter(|number| number.is_finite()).take(count).collect()
}

/// A kernel as the interpreter reads it, at a point.
struct Read<'a>(&'a Kernel, &'a [f64]);

impl Steps for Read<'_> {
    type Results<T> = Vec<T>;

    fn violated<R: Real>(&self, number: impl Fn(f64) -> R) -> Option<usize> {
        let numbers: Vec<R> = self.1.iter().map(|value| number(*value)).collect();
        match closedform_syntax::violated(self.0, &numbers)? {
            Violation::Require(position) => Some(position),
            Violation::NotFinite(_) => panic!("finite numbers only"),
        }
    }

    fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> Vec<T> {
        let numbers: Vec<R> = self.1.iter().map(|value| number(*value)).collect();
        closedform_syntax::evaluate(self.0, &numbers).into_iter().map(end).collect()
    }
}

/// Demands that the interpreter, which looks at every step, returns what the compiled kernel does.
fn agree(read: &Kernel, inputs: &[f64], compiled: &closedform::Kernel) {
    let mut plain = vec![0.0; compiled.info.results.len()];
    compiled.eval(inputs, &mut plain).unwrap();
    let refused = match compiled.checked(inputs, &mut plain.clone()) {
        Err(CallError::Domain(error)) => Some(error.condition()),
        _ => None,
    };
    if !inputs.iter().all(|input| input.is_finite()) {
        assert_eq!(refused, Some("every input is finite"));
        return;
    }
    match tier::default(&Read(read, inputs)) {
        Ok(results) => {
            let same = results.iter().zip(&plain).all(|(Rounded { value, .. }, plain)| same(*value, *plain));
            assert!(same && refused.is_none(), "{} of {inputs:?}: {results:?} interpreted, {plain:?}", read.name);
        }
        Err(condition) => assert_eq!(Some(read.requires[condition].text.as_str()), refused, "{} {inputs:?}", read.name),
    }
}

#[test]
fn the_program_runs_in_mpfr() {
    let precise = |value| Mpfr::new(200, value);
    let [sum] = sums::evaluate(&[precise(0.1), precise(0.3)]);
    assert_eq!(sum.0.prec(), 200);
    assert_eq!(sum.0.to_f64(), sums(0.1, 0.3));
    let [_, root] = ramp::evaluate(&[precise(1.0), precise(0.5)]);
    assert_eq!(root, precise(1.0));
    let [time] = t_in::evaluate(&[precise(0.1), precise(0.2), precise(0.3)]);
    assert!((time.0 - t_in(0.1, 0.2, 0.3)).abs() < 1e-15);
}

#[test]
fn in_double_double_every_shape_is_rounded_once() {
    let numbers = samples(1000);
    let swapped: Vec<f64> = numbers.iter().rev().copied().collect();
    let mut rows = vec![0.0; numbers.len()];
    precise::batch(&numbers, &swapped, &mut rows).unwrap();
    let mut inside = 0;
    for ((&a, &b), &row) in numbers.iter().zip(&swapped).zip(&rows) {
        let single = precise(a, b);
        let (faithful, checked) = (precise::faithful(a, b), precise::checked(a, b).unwrap_or(f64::NAN));
        assert!([row, faithful, checked].iter().all(|&other| same(single, other)), "{a:?} {b:?}");
        let [exact] = precise::evaluate(&[Mpfr::new(2000, a), Mpfr::new(2000, b)]);
        assert!(single.is_nan() || single == exact.0.to_f64(), "{a:?} {b:?}");
        inside += usize::from(!single.is_nan());
    }
    assert!(inside > 100, "{inside}");
}

#[test]
fn in_double_double_nothing_overflows_on_the_way() {
    for (a, b) in [(2e200, 1e100), (3e-200, -1e-250), (3e200, 1e-210)] {
        let [exact] = precise::evaluate(&[Mpfr::new(2000, a), Mpfr::new(2000, b)]);
        assert_eq!(precise(a, b), exact.0.to_f64(), "{a:?} {b:?}");
    }
    assert_eq!(precise(3e200, 1e-210), f64::NEG_INFINITY, "the result does");
    assert_eq!(precise::checked(1.0, 2.0).unwrap_err().condition(), Some(precise::INFO.domain[0]));
    assert_eq!(precise::checked(f64::NAN, 2.0).unwrap_err().condition(), Some("every input is finite"));
    assert_eq!(precise::INFO.precision, closedform::Precision::DoubleDouble);
    assert_eq!(sums::INFO.precision, closedform::Precision::Double);
}

#[test]
fn a_compensated_expression_is_rounded_once() {
    for window in samples(2000).windows(2) {
        let &[a, b] = window else { continue };
        let [exact] = sums::evaluate(&[Mpfr::new(2000, a), Mpfr::new(2000, b)]);
        let moderate = exact.0.clone().abs().to_f64() > 1e-250 && exact.0.is_finite() && exact.0.to_f64().abs() < 1e290;
        assert!(!moderate || sums(a, b) == exact.0.to_f64(), "{a:?} {b:?}");
    }
}

#[test]
fn info_tells_what_was_written() {
    let info = t_in::INFO;
    assert_eq!((info.name, info.family), ("turnaround::t_in", "turnaround"));
    assert_eq!(info.summary, "Time of the ramp in of a turn-around.");
    assert_eq!((info.maxima, info.latex, info.source), ("tInFn(tOut) := ..", "t", "2.3.1 %o50"));
    assert_eq!(info.rules, ["conjugate", "compensated"]);
    let [t_out, _, d] = info.inputs else { panic!("three inputs") };
    assert_eq!((t_out.name, t_out.maxima, t_out.unit, t_out.typical), ("t_out", "tOut", "s", (1e-4, 1e-1)));
    assert_eq!((d.name, d.maxima, d.unit), ("d", "d", ""));
    assert_eq!(info.results[0].bound_ulp, Some(6.01));
    assert_eq!((info.results[0].name, info.results[0].worksheet, info.results[0].unit), ("t_in", "tInFn", "s"));
    let operations = closedform::Operations {
        add: 3,
        mul: 2,
        div: 1,
        sqrt: 1,
        compensated: 4,
        compensated_expressions: 1,
        ..closedform::Operations::default()
    };
    assert_eq!(info.operations, operations);
    // (a b - ..) (a + 2) is no less than 2^(-3 (k + 52)) unless it is zero, and 2^-968 is the least that keeps its error
    assert_eq!((info.ordinary, sums::INFO.ordinary), (244, 270));
    assert_eq!(sums::INFO.name, "sums");
}

#[test]
fn results_of_a_struct_keep_the_order_of_the_literal() {
    let [t1, a1] = ramp::INFO.results else { panic!("two results") };
    assert_eq!((t1.name, t1.unit, t1.bound_ulp), ("t1", "s", Some(0.5)));
    assert_eq!((a1.name, a1.worksheet, a1.bound_ulp), ("a1", "a1Fn", Some(5.01)));
}

#[test]
fn a_kernel_is_called_by_slices() {
    let kernel = &ramp::KERNEL;
    let mut results = [0.0; 2];
    kernel.eval(&[0.5, 2.0], &mut results).unwrap();
    assert_eq!(results, [0.5, 2.0]);
    kernel.eval(&[1.0, 1.0], &mut results).unwrap();
    assert!(results.iter().all(|result| result.is_nan()));
    assert!(matches!(kernel.checked(&[1.0, 1.0], &mut results), Err(CallError::Domain(_))));
    let (mut t1, mut a1) = ([0.0], [0.0]);
    kernel.batch(&[&[0.5], &[2.0]], &mut [&mut t1, &mut a1]).unwrap();
    assert_eq!([t1[0], a1[0]], [0.5, 2.0]);
    let mut singles = [0.0f32; 2];
    kernel.f32(&[0.5, 2.0], &mut singles).unwrap();
    assert_eq!(singles, [0.5, 2.0]);
    let mut precise = [Mpfr::new(100, 0.0), Mpfr::new(100, 0.0)];
    kernel.mpfr(&[Mpfr::new(100, 0.5), Mpfr::new(100, 2.0)], &mut precise).unwrap();
    assert_eq!(precise, [Mpfr::new(100, 0.5), Mpfr::new(100, 2.0)]);
}

#[test]
fn a_kernel_refuses_slices_of_the_wrong_length() {
    let wrong = |name, found| LengthError { kernel: "turnaround::ramp", name, expected: 2, found };
    let kernel = &ramp::KERNEL;
    assert_eq!(kernel.eval(&[0.5], &mut [0.0; 2]), Err(wrong("inputs", 1)));
    assert_eq!(kernel.checked(&[0.5, 2.0], &mut [0.0; 3]), Err(CallError::Length(wrong("results", 3))));
    assert_eq!(kernel.batch(&[&[0.5]], &mut []), Err(wrong("inputs", 1)));
}

mod inner {
    use closedform::kernel;

    /// A kernel without documentation of its arguments, in a module.
    #[kernel]
    pub(super) fn hyp(a: f64, b: f64) -> f64 {
        sqrt(a * a + b * b)
    }
}

/// Names that are keywords, of everything that has one.
mod raw {
    use closedform::kernel;

    pub struct Match {
        pub r#fn: f64,
    }

    #[kernel]
    pub fn r#type(r#in: f64) -> f64 {
        r#in
    }

    #[kernel]
    pub fn r#match(r#mod: f64) -> Match {
        Match { r#fn: r#mod * r#mod }
    }
}

#[test]
fn raw_names_are_names() {
    assert_eq!((raw::r#type(2.0), raw::r#type::faithful(2.0)), (2.0, 2.0));
    assert_eq!(raw::r#match::checked(2.0).map(|results| results.r#fn), Ok(4.0));
    assert_eq!((raw::r#type::INFO.name, raw::r#type::INFO.inputs[0].name), ("type", "in"));
    assert_eq!(raw::r#match::INFO.results[0].name, "fn");
    let mut squares = [0.0; 2];
    assert_eq!(raw::r#match::batch(&[1.0, 3.0], &mut squares), Ok(()));
    assert_eq!(squares, [1.0, 9.0]);
}

#[test]
fn a_kernel_may_be_private_to_its_parent_or_local_to_a_function() {
    #[kernel]
    fn local(x: f64) -> f64 {
        2.0 * x
    }
    assert_eq!((inner::hyp(3.0, 4.0), local(1.0)), (5.0, 2.0));
    assert_eq!(inner::hyp::checked(3.0, 4.0), Ok(5.0));
}
