//! Functions whose values are integers, at their steps and beside them: in every arithmetic, and of arguments that are rounded.

#![cfg(feature = "mpfr")]

use std::cell::Cell;

use closedform_arith::tier::{Steps, certified, default};
use closedform_arith::{Filtered, FilteredDoubleDouble, Function, Real, SoftFloat};
use rug::Float;

const BITS: u32 = 2200;

fn functions() -> impl Iterator<Item = Function> {
    Function::ALL.into_iter().filter(|function| function.has_steps())
}

/// Integers and the middles between them, with their neighbours, small ones and those near 2^52 and 2^53, and numbers without steps.
fn points() -> Vec<f64> {
    let small = (0..40).map(|n| f64::from(n) / 2.0);
    let large = [51, 52, 53, 54, 63, 64, 127, 128, 1000]
        .map(|k| f64::powi(2.0, k))
        .into_iter()
        .flat_map(|x| [x, x + 0.5, x - 0.5, x + 1.0, x - 1.0, x + 1.5, x - 1.5, x + 3.0]);
    let others = [f64::from_bits(1), f64::MIN_POSITIVE, 1e-300, 1e-17, 0.3, 0.7, 1e10 + 0.25, f64::MAX];
    let points = small.chain(large).chain(others).flat_map(|x| [x, x.next_up(), x.next_down()]);
    points.filter(|x| x.is_finite()).flat_map(|x| [x, -x]).collect()
}

fn exact(function: Function, x: &Float) -> f64 {
    let mut value = x.clone();
    function.mpfr(&mut value);
    value.to_f64()
}

#[test]
fn names_and_values_are_those_of_maxima() {
    let table = [
        ("floor", [-3.0, -1.0, 0.0, 0.0, 1.0, 2.0]),
        ("ceiling", [-2.0, 0.0, 1.0, 1.0, 2.0, 3.0]),
        ("round", [-2.0, 0.0, 0.0, 1.0, 2.0, 2.0]),
        ("truncate", [-2.0, 0.0, 0.0, 0.0, 1.0, 2.0]),
    ];
    assert_eq!(functions().count(), table.len());
    for (name, values) in table {
        let function = Function::in_worksheets(name).unwrap();
        assert_eq!([-2.5, -0.5, 0.5, 0.7, 1.5, 2.5].map(|x| x.call(function)), values, "{name}");
    }
}

/// A function of an input, and one of a sum of two of them.
struct Called(Function, [f64; 2]);

impl Steps for Called {
    type Results<T> = T;

    fn violated<R: Real>(&self, _: impl Fn(f64) -> R) -> Option<usize> {
        None
    }

    fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> T {
        let [high, low] = self.1;
        end(if low == 0.0 { number(high) } else { number(high).add(&number(low)) }.call(self.0))
    }
}

#[test]
fn an_input_becomes_the_same_integer_in_every_arithmetic() {
    for function in functions() {
        for x in points() {
            let (expected, escalate) = (exact(function, &Float::with_val(BITS, x)), Cell::new(false));
            assert_eq!(x.call(function), expected, "{function:?} of {x:e}");
            assert_eq!(Filtered::<true>::new(x, &escalate).call(function).value(), expected);
            assert_eq!(SoftFloat::from_f64(x).call(function).to_f64(), expected, "{function:?} of {x:e} in integers");
            assert!(!escalate.get(), "{function:?} of {x:e}");
            for answer in [default(&Called(function, [x, 0.0])), certified(&Called(function, [x, 0.0]))] {
                assert_eq!(answer.map(|found| found.value), Ok(expected), "{function:?} of {x:e}");
            }
        }
    }
}

#[test]
fn what_lies_beside_a_double_decides() {
    for function in functions() {
        for (x, low) in points().into_iter().flat_map(|x| [1e-30, -1e-30, 0.5, -0.5].map(|low| (x, low))) {
            let sum = Float::with_val(BITS, x) + low;
            let (expected, left) = (exact(function, &sum), Cell::new(false));
            let number = |x| FilteredDoubleDouble::<true>::new(x, &left);
            let (found, soft) = (number(x).add(&number(low)), SoftFloat::from_f64(x).add(&SoftFloat::from_f64(low)));
            let value = Float::with_val(BITS, found.value().round()) + found.value().low();
            let stepped = found.call(function);
            if !left.get() {
                let mut argument = value.clone();
                function.mpfr(&mut argument);
                let parts = stepped.value();
                assert_eq!(
                    Float::with_val(BITS, parts.round()) + parts.low(),
                    argument,
                    "{function:?} of {x:e} + {low:e}"
                );
            }
            // 128 bits hold the sum
            if x == 0.0 || (x.abs() > 1e-5 && x.abs() < 1e5) {
                assert_eq!(soft.call(function).to_f64(), expected, "{function:?} of {x:e} + {low:e} in integers");
            }
            let balls = certified(&Called(function, [x, low])).map(|found| found.value);
            assert_eq!(balls, Ok(expected), "{function:?} of {x:e} + {low:e}");
        }
    }
}

/// A program of its inputs.
macro_rules! program {
    ($name:ident, |$number:ident| $value:expr) => {
        struct $name(Function, [f64; 3]);

        impl Steps for $name {
            type Results<T> = T;

            fn violated<R: Real>(&self, _: impl Fn(f64) -> R) -> Option<usize> {
                None
            }

            fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> T {
                let $number = self.1.map(number);
                end($value.call(self.0))
            }
        }
    };
}

program!(Quotient, |x| x[0].mul(&x[1].div(&x[2])));
program!(Roots, |x| x[0].call(Function::Sqrt).mul(&x[1].call(Function::Sqrt)).add(&x[2]));
program!(Cubes, |x| x[0].call(Function::Cbrt).add(&x[1].call(Function::Cbrt)).mul(&x[2]));
program!(OfPi, |x| x[0].pi().sub(&x[1].pi()).add(&x[2]));
program!(Powers, |x| x[0].mul(&x[1].call(Function::Exp)).add(&x[2]));
program!(Logarithm, |x| x[0].call(Function::Log).call(Function::Exp));

/// What certified calls make of a program, in the order of the table: floor, ceiling, round, truncate.
fn values<S: Steps<Results<closedform_arith::tier::Rounded> = closedform_arith::tier::Rounded>>(
    of: impl Fn(Function) -> S,
) -> Vec<f64> {
    functions().map(|function| certified(&of(function)).unwrap().value).collect()
}

#[test]
fn arguments_that_are_shown_to_be_at_a_step_are_decided() {
    for n in [3.0, 7.0, 49.0, 1e15 + 37.0] {
        assert_eq!(values(|function| Quotient(function, [n, 1.0, n])), [1.0; 4], "{n}*(1/{n})");
        assert_eq!(values(|function| Quotient(function, [-n, 5.0, n])), [-5.0; 4]);
        assert_eq!(values(|function| Quotient(function, [n, -0.5, n])), [-1.0, 0.0, 0.0, 0.0]);
        assert_eq!(values(|function| Quotient(function, [n, 3.5, n])), [3.0, 4.0, 4.0, 3.0]);
    }
    // sqrt(2) sqrt(8) is 4
    assert_eq!(values(|function| Roots(function, [2.0, 8.0, 0.0])), [4.0; 4]);
    assert_eq!(values(|function| Roots(function, [2.0, 8.0, -3.5])), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(values(|function| Roots(function, [2.0, 8.0, -4.0])), [0.0; 4]);
    assert_eq!(values(|function| Cubes(function, [8.0, 27.0, 0.5])), [2.0, 3.0, 2.0, 2.0]);
}

#[test]
fn arguments_beside_a_step_are_decided() {
    // 0.1 and 0.2 are larger than their decimals, and so is their sum
    assert_eq!(values(|function| Quotient(function, [0.1 + 0.2, 10.0, 1.0])), [3.0, 4.0, 3.0, 3.0]);
    // the neighbours of 1/3 in `f64`
    let third = 1.0 / 3.0;
    assert_eq!(values(|function| Quotient(function, [third, 3.0, 1.0])), [0.0, 1.0, 1.0, 0.0]);
    assert_eq!(values(|function| Quotient(function, [-third, 3.0, 1.0])), [-1.0, 0.0, -1.0, 0.0]);
    assert_eq!(values(|function| Quotient(function, [third.next_up(), 3.0, 1.0])), [1.0, 2.0, 1.0, 1.0]);
    let two = 2.0_f64;
    assert_eq!(values(|function| Roots(function, [two.next_up(), 8.0, 0.0])), [4.0, 5.0, 4.0, 4.0]);
    assert_eq!(values(|function| Roots(function, [two.next_down(), 8.0, 0.0])), [3.0, 4.0, 4.0, 3.0]);
    assert_eq!(values(|function| Roots(function, [two.next_up(), 8.0, -3.5])), [0.0, 1.0, 1.0, 0.0]);
    assert_eq!(values(|function| Powers(function, [1e-300, 2.0, 3.0])), [3.0, 4.0, 3.0, 3.0]);
    assert_eq!(values(|function| Powers(function, [-1e-300, 2.0, 3.5])), [3.0, 4.0, 3.0, 3.0]);
}

#[test]
fn what_is_not_shown_to_be_at_a_step_stays_open() {
    // pi - pi has no separation bound
    for number in [[1.0, 1.0, 1.0], [1.0, 1.0, 0.5]] {
        let open = values(|function| OfPi(function, number)).into_iter().filter(|value| value.is_nan()).count();
        assert_eq!(open, if number[2] == 1.0 { 3 } else { 1 }, "{number:?}");
    }
    let [floor, ceiling, round, truncate] = values(|function| Logarithm(function, [2.0; 3]))[..] else {
        panic!("four")
    };
    assert!(floor.is_nan() && ceiling.is_nan() && round == 2.0 && truncate.is_nan());
}
