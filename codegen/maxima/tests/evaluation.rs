//! Values against numbers known from elsewhere.
#![cfg(feature = "mpfr")]

use std::collections::BTreeMap;

use closedform_maxima::{EvalError, evaluate, evaluate_stable, parse_expression};
use proptest::prelude::*;
use rug::{Float, Rational};

fn value(text: &str, inputs: &[(&str, f64)]) -> Result<Float, EvalError> {
    let inputs = inputs.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    evaluate_stable(&parse_expression(text).expect(text), &inputs, 120)
}

/// The error of the text, for `x = -2`, and the part of the text that it points at.
fn error(text: &str) -> (EvalError, &str) {
    let error = value(text, &[("x", -2.0)]).expect_err(text);
    let span = *miette::Diagnostic::labels(&error).and_then(|mut labels| labels.next()).expect("a place").inner();
    (error, &text[span.offset()..span.offset() + span.len()])
}

#[test]
fn what_a_function_makes_small_is_not_lost_beside_one() {
    for x in [-460.75, -177.5, -800.0] {
        let found = value("log(1+%e^x)", &[("x", x)]).unwrap();
        let exact = Float::with_val(400, x).exp().ln_1p();
        assert!((Float::with_val(400, &found - &exact) / exact).abs() < 1e-30, "{x}: {found:e}");
    }
}

#[test]
fn values_are_right() {
    let inputs = [("x", 2.0), ("y", 0.5), ("z", -8.0)];
    for (text, wanted) in [
        ("x+y*3-1", "2.5"),
        ("-x^2", "-4"),
        ("-2^-2", "-0.25"),
        ("x^y", "1.41421356237309504880168872420969807857"),
        ("sqrt(x)", "1.41421356237309504880168872420969807857"),
        ("x^(3/2)", "2.82842712474619009760337744841939615714"),
        ("x^(-1/2)", "0.70710678118654752440084436210484903928"),
        ("z^(1/3)", "-2"),
        ("z^(2/3)", "4"),
        ("z^3", "-512"),
        ("%pi", "3.14159265358979323846264338327950288420"),
        ("%e^x-exp(x)", "0"),
        ("log(%e)", "1"),
        ("sin(x)^2+cos(x)^2-1", "0"),
        ("4*atan(1)-%pi", "0"),
        ("atan2(-1,-1)", "-2.35619449019234492884698253745962716315"),
        ("max(x,y,z)+min(x,y,z)", "-6"),
        ("abs(z)", "8"),
        ("signum(z)+floor(y)+ceiling(y)", "0"),
        ("floor(-y)+10*ceiling(-y)+100*truncate(-y)", "-1"),
        ("round(y)+10*round(3*y)+100*round(5*y)+1000*round(-3*y)", "-1780"),
        ("entier(y*5)-mod(z,3)+mod(-z,-3)", "0"),
        ("if x>y then 1 else 2", "1"),
        ("if x<=y or not y#0.5 then 1 elseif x=2 and true then 2 else 3", "1"),
        ("0.1b0", "0.1"),
        ("1.5b-3", "0.0015"),
        ("123456789012345678901234567890", "123456789012345678901234567890"),
        ("positive_root(t^2-x,t)", "1.41421356237309504880168872420969807857"),
        ("positive_root(t^2-t-1,t)", "1.61803398874989484820458683436563811772"),
        ("positive_root(34-t-t^5,t)", "2"),
        ("positive_root(x-t,t)", "2"),
        ("positive_root(t^2-t,t)", "1"),
        ("positive_root(t^2-1b-300,t)*1b150", "1"),
        ("positive_root((t+1)^2-1-1b-90,t)*2b90", "1"),
        ("positive_root(s-positive_root(t^2-s-x,t),s)", "2"),
    ] {
        let actual = value(text, &inputs).expect(text);
        let wanted = Float::with_val(200, Float::parse(wanted).expect(wanted));
        assert!(Float::with_val(200, &actual - &wanted).abs() <= 1e-37, "{text}: {actual}");
    }
}

#[test]
fn errors_point_at_their_cause() {
    for (text, place, message) in [
        ("1+y*2", "y", "`y` has no value"),
        ("1+foo(x)", "foo(x)", "unknown function `foo`"),
        ("sqrt(1,2)", "sqrt(1,2)", "`sqrt` takes one argument, not 2"),
        ("1+sqrt(x)", "sqrt(x)", "not a real number"),
        ("x^(1/2)", "x", "not a real number"),
        ("1/(x+2)", "(x+2)", "division by zero"),
        ("(x+2)^(-1)", "(x+2)", "division by zero"),
        ("1+[x]", "[x]", "a list has no numeric value"),
        ("if x then 1", "x", "not a condition"),
        ("if x>0 then 1", "if x>0 then 1", "no branch applies"),
        ("positive_root(t^2+1,t)", "t^2+1", "no positive root"),
        ("1e999", "1e999", "not a finite number"),
        ("exp(exp(1b99))", "exp(1b99)", "not a finite number"),
        ("x=1", "x=1", "a condition has no numeric value"),
        ("2^0.5b0^x!", "x!", "a factorial has no numeric value"),
    ] {
        let (error, found) = error(text);
        assert_eq!((error.to_string().as_str(), found), (message, place), "{text}");
    }
}

/// What rounding makes of a number at a step is on either side of it, and differs from precision to precision.
#[test]
fn numbers_at_a_step_are_told_from_those_beside_it() {
    let inputs = [("a", 0.1), ("b", 0.2), ("t", 1.0 / 3.0), ("n", 1e15 + 37.0), ("e", 1e-300), ("h", 1e300)];
    for (text, wanted) in [
        ("floor(3*(1/3))", 1.0),
        ("floor(n*(1/n))+ceiling(n*(1/n))+truncate(n*(1/n))", 3.0),
        ("floor(49*(1/49))+floor(41*(1/41))+floor(47*(1/47))+floor(-107*(1/107))", 2.0),
        ("ceiling(sqrt(2)*sqrt(8))+floor(sqrt(2)*sqrt(8))", 8.0),
        ("round(n*(1/n)/2)+round(3*n*(1/n)/2)", 2.0),
        ("floor(3*t)", 0.0),
        ("floor((a+b)*10)", 3.0),
        ("ceiling((a+b)*10)", 4.0),
        ("ceiling((0.1+0.2)*10)", 4.0),
        ("floor(1-e)+ceiling(e)", 1.0),
        ("floor(1-e^3)+round(1/2+e^3)", 1.0),
        ("floor(h+1/2)-h", 0.0),
        ("7*floor(h^2/7)-h^2", -1.0),
        ("floor(log(%e^a)/a)", 1.0),
        ("mod(h,7)", 1.0),
        ("1-floor(%e^-700)", 1.0),
        ("if sqrt(2)*sqrt(8) = 4 then 1 else 0", 1.0),
        ("if 3*(1/3) < 1 then 0 elseif n*(1/n) > 1 then 0 else 1", 1.0),
        ("if 1+e^3 > 1 and 1-e^3 < 1 then 1 else 0", 1.0),
        ("if e^3 = 0 or h^2 = 0 then 0 else 1", 1.0),
        // a root is not enclosed
        ("if positive_root(u^2-2,u) > 1.41421356237 and positive_root(u^2-2,u) < 1.41421356238 then 1 else 0", 1.0),
        ("if positive_root(u^2-2,u)^2*h^5 = 2*h^5 then 1 else 0", 1.0),
        ("if positive_root(u^2-2,u)^2 = 2 and positive_root(u^2-2,u)^2-2 <= 0 then 1 else 0", 1.0),
        // Kahan's monster: the quotient of what rounding leaves
        (
            "if (abs(h-sqrt(h*h+1))-1/(h+sqrt(h*h+1)))^2 = 0 then 1 else (exp((abs(h-sqrt(h*h+1))-1/(h+sqrt(h*h+1)))^2)-1)/(abs(h-sqrt(h*h+1))-1/(h+sqrt(h*h+1)))^2",
            1.0,
        ),
    ] {
        assert_eq!(value(text, &inputs).map(|found| found.to_f64()), Ok(wanted), "{text}");
    }
}

/// Where all digits cancel, or a number on the way is beyond MPFR, precision after precision may agree on what is wrong.
#[test]
fn agreement_is_not_taken_for_truth() {
    let inputs = [("c", 159.0), ("s", 1e-13), ("x", 0.5), ("y", 700.5)];
    for (text, same) in [
        ("1/tanh(c)-1/tanh(c)^3", "-cosh(c)/sinh(c)^3"),
        ("1-4/tanh(c)^2+3/tanh(c)^4", "(1-tanh(c)^2)*(3/tanh(c)^2-1)/tanh(c)^2"),
        ("log(1+%e^(-3*c))", "2*atanh(%e^(-3*c)/(2+%e^(-3*c)))"),
        ("1/(1+exp(-x/s))", "1"),
        ("-s*log(1/(x*(1/(1+exp(-%pi/s))-1/(1+exp(%pi/s)))+1/(1+exp(%pi/s)))-1)+1", "1"),
        ("cos(y)^2-(1-sin(y)^2)+%e^-y", "%e^-y"),
    ] {
        let [found, wanted] = [text, same].map(|text| value(text, &inputs).expect(text));
        let off = Float::with_val(300, &found - &wanted).abs() / wanted.abs();
        assert!(off < 1e-33, "{text}: {found}");
    }
    assert!(value("1/(1+exp(x/s))", &inputs).expect("a number that no double tells from zero").is_zero());
}

/// (1+tiny)-1 loses everything at 128 bits.
#[test]
fn lost_digits_are_found_again() {
    let inputs = [("a", 1.0), ("b", 1e-100), ("c", 1e-300)];
    for (text, wanted) in [("a+b-a", 1e-100), ("a+c-a", 1e-300), ("(a+b)-a+c*0", 1e-100), ("sqrt(a+c)^2-a", 1e-300)] {
        assert_eq!(value(text, &inputs).map(|found| found.to_f64()), Ok(wanted), "{text}");
    }
    let zero = value("sqrt(a+b)^2-a-b", &inputs).expect("zero");
    assert!(zero.is_zero());
}

#[test]
fn long_sums_fit_the_stack() {
    let text = format!("x{}", "+x^2".repeat(1000));
    assert_eq!(value(&text, &[("x", 1.0)]).map(|sum| sum.to_f64()), Ok(1001.0));
}

proptest! {
    /// Sums, differences, products and quotients are what exact rationals say.
    #[test]
    fn rational_arithmetic_is_exact(a in -1e9..1e9_f64, b in -1e9..1e9_f64, c in 1e-9..1e9_f64) {
        let found = value("(a+b)*(a-b)/c-a^2/c+1", &[("a", a), ("b", b), ("c", c)]).expect("a value");
        let [_, b, c] = [a, b, c].map(|x| Rational::from_f64(x).expect("finite"));
        let wanted = Rational::from(1) - Rational::from(&b * &b) / c;
        let scale = Float::with_val(64, &wanted).abs() / Float::with_val(64, Float::i_exp(1, 119));
        prop_assert!(Float::with_val(400, found - wanted).abs() <= scale);
    }

    /// The root of a product of known factors.
    #[test]
    fn roots_are_found(root in 1e-200..1e200_f64, other in 1e-9..1e9_f64) {
        let inputs: BTreeMap<_, _> =
            [("r", root), ("s", other)].map(|(name, value)| (name.to_owned(), Float::with_val(53, value))).into();
        let expression = parse_expression("positive_root((t-r)*(t+s)*(t^2+s),t)").expect("parses");
        let found = evaluate(&expression, &inputs, 300).expect("a root");
        prop_assert!(Float::with_val(300, found / root - 1).abs() < Float::with_val(64, Float::i_exp(1, -295)));
    }
}
