//! Towers: a canonical form has the value of its expression, and equal expressions have one form.

use super::values::{ALGEBRA, BITS, agree, cases, float, positive_point, real_value};
use closedform_generator::algebra::Var;
use closedform_generator::field::{Element, Sign, Tower};
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
        // what is zero is so but for rounding
        let sign_of_value = if value.clone().abs() < 1e-60 { Sign::ZERO } else if value.is_sign_negative() { Sign::NEGATIVE } else { Sign::POSITIVE };
        prop_assert!(sign_of_value.is(sign), "{value} is not {sign}");
    }
}

#[test]
fn roots_of_squares_and_products_of_roots_are_seen() {
    let form = |tower: &mut Tower, text: &str| {
        let parsed = closedform_maxima::parse_expression(text).unwrap();
        tower.canonical(&closedform_project::expression::lower(&parsed).unwrap())
    };
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
