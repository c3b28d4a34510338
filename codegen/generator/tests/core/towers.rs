//! Towers: a canonical form has the value of its expression, and equal expressions have one form.

use super::values::{ALGEBRA, BITS, agree, cases, float, positive_point, rational, real_value};
use closedform_generator::algebra::Var;
use closedform_generator::field::{Element, Sign, Tower, TowerError};
use closedform_project::expression::Expr;
use closedform_syntax::Function;
use num_rational::BigRational;
use proptest::prelude::*;
use rug::Float;
use rug::ops::Pow;

const NAMES: [&str; 2] = ["x", "y"];

/// The tower over two positive inputs.
fn tower() -> Tower {
    let mut tower = Tower::new(ALGEBRA, &NAMES.map(str::to_owned));
    for var in [0, 1] {
        tower.facts.set_variable(Var(var), Sign::POSITIVE);
    }
    tower
}

/// Expressions that are positive where the inputs are, so that roots and quotients have values.
fn positive(depth: u32) -> BoxedStrategy<Expr> {
    let leaf = prop_oneof![(1_i64..6).prop_map(Expr::integer), prop::sample::select(&NAMES[..]).prop_map(Expr::symbol)];
    leaf.prop_recursive(depth, 8, 2, |inner| {
        let two = (inner.clone(), inner.clone());
        prop_oneof![
            two.clone().prop_map(|(a, b)| a.plus(b)),
            two.clone().prop_map(|(a, b)| a.times(b)),
            two.prop_map(|(a, b)| a.over(b)),
            inner.clone().prop_map(|a| Expr::Power(Box::new(a), 2)),
            (inner, prop::sample::select(&[Function::Sqrt, Function::Cbrt][..]))
                .prop_map(|(a, root)| Expr::call(root, a)),
        ]
    })
    .boxed()
}

/// Roots of which those in a row depend on each other, which the tower does not see.
const DEPENDENT: [&[&str]; 3] = [
    // Cardano's pair, and its product
    &["(x+sqrt(y))^(1/3)", "(x-sqrt(y))^(1/3)", "(x^2-y)^(1/3)", "(x+sqrt(y))^(1/3)*(x-sqrt(y))^(1/3)"],
    // a root of a sum of roots, the sum that it is, and roots above them
    &["sqrt(2+sqrt(3))", "(sqrt(6)+sqrt(2))/2", "(y+sqrt(2+sqrt(3))-(sqrt(6)+sqrt(2))/2)^(1/3)", "y^(1/3)"],
    &["sqrt(x+y+2*sqrt(x*y))", "sqrt(x)+sqrt(y)", "sqrt(x)"],
];

/// Two differences of such.
fn dependent() -> impl Strategy<Value = [Expr; 2]> {
    let of_row = |row: &'static [&'static str]| {
        let root = prop::sample::select(row).prop_map(read);
        let sum = (root.clone(), root, 1_i64..3).prop_map(|(a, b, n)| a.minus(Expr::integer(n).times(b)));
        (sum.clone(), sum).prop_map(|(a, b)| [a, b])
    };
    prop::sample::select(&DEPENDENT[..]).prop_flat_map(of_row)
}

/// Points where nothing of that is zero by chance; at one of them a radicand is negative.
const APART: [[(i64, i64); 2]; 2] = [[(17, 5), (23, 7)], [(3, 11), (29, 13)]];

fn read(text: &str) -> Expr {
    closedform_project::expression::lower(&closedform_maxima::parse_expression(text).unwrap()).unwrap()
}

/// What is zero is so but for rounding.
fn is_zero(value: &Float) -> bool {
    value.clone().abs() < 1e-60
}

/// Differences of such, of which nobody knows the sign.
fn expression() -> impl Strategy<Value = Expr> {
    (positive(2), positive(2), positive(1)).prop_map(|(a, b, c)| a.minus(b).times(c))
}

/// Another expression of the same value.
fn rewritten(expr: &Expr) -> Expr {
    match expr {
        Expr::Sum(items) => Expr::Sum(items.iter().rev().map(rewritten).collect()),
        // a*b = (a*x^2)*(b/x^2)
        Expr::Product(items) => {
            let square = Expr::Power(Box::new(Expr::symbol("x")), 2);
            let mut items: Vec<Expr> = items.iter().rev().map(rewritten).collect();
            items.extend([square.clone(), Expr::Power(Box::new(square), -1)]);
            Expr::Product(items)
        }
        Expr::Power(base, 2) => rewritten(base).times(rewritten(base)),
        Expr::Power(base, exponent) => Expr::Power(Box::new(rewritten(base)), *exponent),
        // sqrt(a) = sqrt(4*a*y^2)/(2*y)
        Expr::Call(Function::Sqrt, base) => {
            let double = Expr::integer(2).times(Expr::symbol("y"));
            let inside = rewritten(base).times(Expr::Power(Box::new(double.clone()), 2));
            Expr::call(Function::Sqrt, inside).over(double)
        }
        // cbrt(a) = -cbrt(-a*y^3)/y
        Expr::Call(Function::Cbrt, base) => {
            let y = Expr::symbol("y");
            let inside = rewritten(base).times(Expr::Power(Box::new(y.clone()), 3)).negated();
            Expr::call(Function::Cbrt, inside).negated().over(y)
        }
        other => other.clone(),
    }
}

fn value_of(expr: &Expr, point: &[BigRational]) -> Float {
    let of = |expr: &Expr| value_of(expr, point);
    match expr {
        Expr::Rational(number) => float(number),
        Expr::Symbol(name) => float(&point[NAMES.iter().position(|known| known == name).unwrap()]),
        Expr::Sum(items) => items.iter().map(of).fold(Float::new(BITS), |sum, item| sum + item),
        Expr::Product(items) => items.iter().map(of).fold(Float::with_val(BITS, 1), |product, item| product * item),
        Expr::Power(base, exponent) => of(base).pow(*exponent),
        Expr::Call(function, base) => {
            let mut value = of(base);
            function.mpfr(&mut value);
            value
        }
        _ => panic!("{expr:?} stands alone"),
    }
}

/// The values of an element and of its numerator's terms together, by those of the radicals.
fn value_of_element(tower: &Tower, element: &Element, point: &[BigRational]) -> Float {
    let mut values: Vec<(Var, Float)> = point.iter().enumerate().map(|(at, value)| (Var(at), float(value))).collect();
    for radical in tower.radicals() {
        let inside = real_value(&radical.radicand, |var| lookup(&values, var));
        values.push((radical.var, inside.root(radical.degree)));
    }
    real_value(&element.numerator, |var| lookup(&values, var))
        / real_value(&element.denominator, |var| lookup(&values, var))
}

fn lookup(values: &[(Var, Float)], var: Var) -> Float {
    values.iter().find(|(known, _)| *known == var).map(|(_, value)| value.clone()).unwrap()
}

proptest! {
    #![proptest_config(cases(80))]

    #[test]
    fn a_form_has_the_value_of_its_expression(expr in expression(), at in positive_point(2)) {
        let mut tower = tower();
        let element = tower.canonical(&expr).unwrap();
        let (found, expected) = (value_of_element(&tower, &element, &at), value_of(&expr, &at));
        prop_assert!(agree(&found, &expected, &Float::with_val(BITS, 1)), "{found} for {expected}: {expr:?}");
    }

    #[test]
    fn equal_expressions_have_one_form(expr in expression()) {
        let mut tower = tower();
        let one = tower.canonical(&expr).unwrap();
        let other = tower.canonical(&rewritten(&expr)).unwrap();
        prop_assert_eq!(one, other);
    }

    #[test]
    fn signs_of_elements_hold(expr in expression(), at in positive_point(2)) {
        let mut tower = tower();
        let element = tower.canonical(&expr).unwrap();
        let value = value_of(&expr, &at);
        let sign = tower.sign(&element);
        prop_assert!(sign_of_value(&value).is(sign), "{value} is not {sign}");
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn what_depends_on_itself_is_not_taken_for_something_else([a, b] in dependent(), at in prop::sample::select(&APART[..])) {
        let mut tower = tower();
        let at = at.map(|(over, under)| rational(over, under));
        let [a_value, b_value] = [&a, &b].map(|expr| value_of(expr, &at));
        let Ok(form) = tower.canonical(&a) else { return Ok(()) };
        let sign = tower.sign(&form);
        prop_assert!(sign_of_value(&a_value).is(sign), "{a_value} is not {sign}: {a:?}");
        prop_assert!(!form.numerator.is_zero() || is_zero(&a_value), "{a:?} is no zero");
        match tower.canonical(&a.clone().over(b.clone())) {
            Ok(_) if is_zero(&b_value) => prop_assert!(false, "divides by zero: {b:?}"),
            Ok(quotient) => {
                let (found, expected) = (value_of_element(&tower, &quotient, &at), a_value / b_value);
                prop_assert!(agree(&found, &expected, &Float::with_val(BITS, 1)), "{found} for {expected}: {a:?} over {b:?}");
            }
            Err(refused) => prop_assert_eq!(refused, TowerError::DivisionByZero),
        }
    }
}

fn sign_of_value(value: &Float) -> Sign {
    if is_zero(value) {
        Sign::ZERO
    } else if value.is_sign_negative() {
        Sign::NEGATIVE
    } else {
        Sign::POSITIVE
    }
}

/// Zeros that the tower does not see as such: nothing is divided by them, nor by what is zero with them.
#[test]
fn a_zero_of_dependent_roots_divides_nothing() {
    let pair = "(x+sqrt(y))^(1/3)*(x-sqrt(y))^(1/3)-(x^2-y)^(1/3)";
    let nested = "sqrt(2+sqrt(3))-(sqrt(6)+sqrt(2))/2";
    for zero in [pair, nested, "sqrt(x+y+2*sqrt(x*y))-sqrt(x)-sqrt(y)"] {
        let mut tower = tower();
        let form = tower.canonical(&read(zero)).unwrap();
        assert!(!form.numerator.is_zero(), "{zero} is seen");
        assert!(Sign::ZERO.is(tower.sign(&form)), "{zero} has a sign");
        for above in [
            zero.to_owned(),
            format!("sqrt(x+{zero})-sqrt(x)"),
            format!("(y+{zero})^(1/3)-y^(1/3)"),
            format!("sqrt(1+sqrt(x+{zero}))-sqrt(1+sqrt(x))"),
        ] {
            let quotient = tower.canonical(&read(&format!("1/({above})")));
            assert_eq!(quotient, Err(TowerError::DivisionByZero), "{above}");
        }
    }
}

#[test]
fn roots_of_squares_and_products_of_roots_are_seen() {
    let form = |tower: &mut Tower, text: &str| tower.canonical(&read(text));
    for (one, other) in [
        ("sqrt(x^2+2*x*y+y^2)", "x+y"),
        ("sqrt(6)/sqrt(3)", "sqrt(2)"),
        ("sqrt(2)*sqrt(3)", "sqrt(6)"),
        ("1/(sqrt(x)+sqrt(y))", "(sqrt(x)-sqrt(y))/(x-y)"),
        ("sqrt(x/y)", "sqrt(x*y)/y"),
        ("abs(x-y)^2", "(x-y)^2"),
        ("(x-y)^(1/3)", "-(y-x)^(1/3)"),
        ("(x*y)^(1/3)", "x^(1/3)*y^(1/3)"),
        ("(x/y)^(2/3)", "(x^2*y)^(1/3)/y"),
        ("(54*x^4)^(1/3)", "3*x*2^(1/3)*x^(1/3)"),
        ("(2/9)^(1/3)", "6^(1/3)/3"),
        ("(x^2-2*x*y+y^2)^(1/3)", "(x-y)^(2/3)"),
        ("1/(x^(1/3)-y^(1/3))", "(x^(2/3)+(x*y)^(1/3)+y^(2/3))/(x-y)"),
        ("1/(1+x^(1/3)+x^(2/3))", "(x^(1/3)-1)/(x-1)"),
        ("1/((x+sqrt(y))^(1/3)-1)", "((x+sqrt(y))^(2/3)+(x+sqrt(y))^(1/3)+1)/(x+sqrt(y)-1)"),
        ("(x^(1/3)+y^(1/3))^3", "x+y+3*(x*y)^(1/3)*(x^(1/3)+y^(1/3))"),
    ] {
        let mut tower = tower();
        let one_form = form(&mut tower, one).unwrap();
        assert_eq!(one_form, form(&mut tower, other).unwrap(), "{one} and {other}");
    }
    let mut tower = tower();
    assert_ne!(form(&mut tower, "sqrt((x-y)^2)"), form(&mut tower, "x-y"), "the sign of x-y is open");
    for none in ["1/(x-x)", "sqrt(x-x-2)", "z", "1+max(x,y)"] {
        assert!(form(&mut tower, none).is_err(), "{none}");
    }
    assert!(tower.canonical(&Expr::Power(Box::new(Expr::symbol("x")), 65)).is_err());
}
