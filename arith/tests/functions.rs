//! Every function of the table in every arithmetic, against MPFR: values, errors, edges and signs.

#![cfg(feature = "mpfr")]

use std::cell::Cell;
use std::cmp::Ordering;

use closedform_arith::error_model::UNIT;
use closedform_arith::tier::{Steps, certified, faithful};
use closedform_arith::{Filtered, FilteredDoubleDouble, Function, Mpfr, Real, SoftFloat};
use rug::Float;
use rug::ops::Pow;

const BITS: u32 = 2200;

/// Numbers of all exponents and both signs; cubes and squares, and their neighbours; the ends of the range.
fn points() -> Vec<f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state ^ state >> 29
    };
    let edges = [0.0, f64::from_bits(1), f64::from_bits(7), f64::MIN_POSITIVE, 1.0, 2.0, 8.0, f64::MAX];
    let mut points: Vec<f64> = edges.iter().flat_map(|x| [*x, x.next_up(), x.next_down()]).collect();
    points.extend((1..2000).map(|n| f64::from(n).powi(3)).flat_map(|x| [x, x.next_up(), x.next_down()]));
    points.extend((-357..341).map(|k| f64::powi(8.0, k)));
    points.extend((0..40_000).map(|_| f64::from_bits(random())));
    // angles, exponents and logarithms of ordinary size, and multiples of a right angle
    points.extend((1..3_000).map(|n| f64::from(n) * core::f64::consts::FRAC_PI_2));
    points.extend(
        (0..20_000).map(|_| f64::from_bits(random() >> 12 | 1023 << 52) * f64::powi(2.0, (random() % 50) as i32 - 40)),
    );
    // where fractions change over: at powers of two
    points.extend((0..3_000).map(|_| f64::from_bits(random() % (1 << 54) + (1022 << 52))));
    points.retain(|x| x.is_finite());
    points.iter().flat_map(|x| [*x, -x]).collect()
}

fn exact(function: Function, x: f64) -> Float {
    let mut value = Float::with_val(BITS, x);
    function.mpfr(&mut value);
    value
}

/// The error of `found` in units of 2^-53, relative to the true value.
fn units(found: &Float, exact: &Float) -> f64 {
    if exact.is_zero() {
        return if found.is_zero() { 0.0 } else { f64::INFINITY };
    }
    (Float::with_val(BITS, found - exact) / exact).abs().to_f64() / UNIT
}

/// Where a function has a value, besides MPFR's word for it the table's.
fn defined(function: Function) -> impl Iterator<Item = f64> {
    // MPFR takes some hundred microseconds for what is no power
    let step = if function.is_power() { 1 } else { 17 };
    points().into_iter().step_by(step).filter(move |x| {
        let (defined, exact) = (function.properties().domain.holds(*x), exact(function, *x));
        // MPFR has infinities where a function has none
        assert_eq!(defined, exact.is_finite() || function.name() == "exp", "{function:?} at {x:e}");
        defined
    })
}

#[test]
fn in_f64_the_error_is_what_the_table_says() {
    for function in Function::ALL {
        let (mut worst, promised) = (0.0_f64, function.properties().error.to_f64());
        for x in defined(function) {
            let found = x.call(function);
            let escalate = Cell::new(false);
            let plain = Filtered::<true>::new(x, &escalate).call(function);
            assert_eq!(plain.value().to_bits(), found.to_bits(), "{function:?} at {x:e}");
            assert!(!escalate.get() || !function.is_power(), "{function:?} at {x:e}");
            if found != 0.0 && !found.is_normal() || found == 0.0 && x != 0.0 {
                assert!(function.is_exact() || !function.is_power(), "{function:?} at {x:e}");
                continue;
            }
            worst = worst.max(units(&Float::with_val(53, found), &exact(function, x)));
        }
        assert!(worst <= promised, "{function:?}: {worst} units, {promised} promised");
    }
}

#[test]
fn where_there_is_no_value_there_is_none_in_any_arithmetic() {
    // -2 is in no domain but that of all numbers
    for function in Function::ALL.into_iter().filter(|function| !function.is_total()) {
        let (escalate, left) = (Cell::new(false), Cell::new(false));
        assert!((-2.0).call(function).is_nan());
        assert!(Filtered::<false>::new(-2.0, &escalate).call(function).value().is_nan() && escalate.get());
        assert!(FilteredDoubleDouble::<false>::new(-2.0, &left).call(function).round().is_nan() && left.get());
        assert!(SoftFloat::from_f64(-2.0).call(function).to_f64().is_nan());
        assert!(Mpfr::new(60, -2.0).call(function).0.is_nan());
    }
}

#[test]
fn zero_and_its_sign_stay() {
    for function in Function::ALL.into_iter().filter(|function| function.signs(Ordering::Equal) == [Ordering::Equal]) {
        assert_eq!(0.0.call(function).to_bits(), 0.0_f64.to_bits());
        let expected = if function.is_even() { 0.0_f64 } else { -0.0 };
        assert_eq!((-0.0).call(function).to_bits(), expected.to_bits(), "{function:?}");
    }
}

#[test]
fn powers_are_found_exactly() {
    for function in Function::ALL {
        let Some(degree) = function.degree() else { continue };
        for n in (1..2_000).map(f64::from).flat_map(|n| [n, n * 2f64.powi(-300), n * 2f64.powi(290), n + 0.5]) {
            assert_eq!(n.powi(degree as i32).call(function), n, "{function:?}");
            if function.is_odd() {
                assert_eq!((-n.powi(degree as i32)).call(function), -n, "{function:?}");
            }
        }
    }
}

#[test]
fn in_double_double_the_error_is_what_the_table_says() {
    for function in Function::ALL {
        let (mut worst, promised) = (0.0_f64, function.properties().double_double_error);
        for x in defined(function) {
            let left = Cell::new(false);
            // an argument of which the low part counts: x (1 + 2^-54/3)
            let input = FilteredDoubleDouble::<true>::new(x, &left);
            let third = input.literal(3.0);
            let ulp = input.mul(&input.literal(f64::powi(2.0, -54))).div(&third);
            let argument = input.add(&ulp);
            let value = argument.call(function);
            if left.get() {
                continue;
            }
            let read =
                |value: FilteredDoubleDouble<true>| Float::with_val(BITS, value.value().round()) + value.value().low();
            let mut exact = read(argument);
            function.mpfr(&mut exact);
            worst = worst.max(units(&read(value), &exact) / UNIT);
        }
        assert!(worst <= promised, "{function:?}: {worst} units of u^2, {promised} promised");
    }
}

/// The function as a program.
struct Call(Function);

impl Steps for Call {
    type Results<T> = T;

    fn violated<R: Real>(&self, _: impl Fn(f64) -> R) -> Option<usize> {
        None
    }

    fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> T {
        end(number(self.at()).call(self.0))
    }
}

thread_local!(static AT: Cell<f64> = const { Cell::new(0.0) });

impl Call {
    fn at(&self) -> f64 {
        AT.get()
    }
}

#[test]
fn faithful_and_certified_calls_keep_their_promises_everywhere() {
    for function in Function::ALL {
        for x in defined(function).step_by(7) {
            AT.set(x);
            let exact = exact(function, x);
            let near = faithful(&Call(function)).unwrap().value;
            let balls = certified(&Call(function)).unwrap().value;
            let nearest = exact.to_f64();
            if !nearest.is_normal() && x != 0.0 {
                // beyond all exponents of balls it stays open
                let is_near = |value: f64| [nearest.next_down(), nearest, nearest.next_up()].contains(&value);
                assert!(is_near(near) && (is_near(balls) || balls.is_nan()), "{function:?} at {x:e}");
                continue;
            }
            assert!(near == nearest || near == nearest.next_up() || near == nearest.next_down(), "{function:?} {x:e}");
            if exact.is_zero() || function.is_exact() {
                assert_eq!(balls, nearest);
                continue;
            }
            let ulp = Float::with_val(60, 2).pow(exact.get_exp().unwrap() - 53);
            let off = (Float::with_val(BITS, &exact - balls) / ulp).abs();
            assert!(off <= 0.51, "{function:?} at {x:e}: {off}");
        }
    }
}

#[test]
fn in_soft_floats_values_are_right_far_beyond_any_exponent() {
    for function in Function::ALL {
        let Some((p, q)) = function.properties().exponent else { continue };
        for x in [3.0, 0.7, 1e300, -5.0].into_iter().filter(|x| *x > 0.0 || function.is_total()) {
            // x^(4^8), whose value is x's to that power
            let power = |x: SoftFloat| (0..8).fold(x, |y, _| y.mul(&y).mul(&y).mul(&y));
            let (above, through) =
                (power(SoftFloat::from_f64(x)).call(function), power(SoftFloat::from_f64(x).call(function)));
            let ratio = above.div(&through).to_f64();
            // x^(p/q) is off by 2^-120, and its power by so many times that
            let expected = if function.is_odd() || x > 0.0 { 1.0 } else { ratio.signum() };
            assert!((ratio - expected).abs() < 1e-15, "{function:?} of {x}, {p}/{q}: {ratio}");
        }
    }
}

#[test]
fn signs_and_order_are_those_of_the_table() {
    for function in Function::ALL {
        let mut sorted: Vec<f64> = defined(function).filter(|x| x.is_normal() || *x == 0.0).collect();
        sorted.sort_by(f64::total_cmp);
        for pair in sorted.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|x| x.call(function));
            let sign = a.partial_cmp(&0.0).unwrap();
            // a value that underflows is zero
            let allowed = function.signs(pair[0].partial_cmp(&0.0).unwrap());
            assert!(allowed.contains(&sign) || sign == Ordering::Equal, "{function:?} at {:e}", pair[0]);
            assert!(!function.properties().increases || a <= b, "{function:?} between {:e} and {:e}", pair[0], pair[1]);
        }
    }
}
