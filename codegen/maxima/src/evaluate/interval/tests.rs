//! Values of functions lie in the intervals that are found of them.

use super::*;

type Named = (&'static str, fn(Float) -> Float);

/// Few bits, so that every rounding shows.
const COARSE: u32 = 12;

fn interval(low: f64, high: f64) -> Interval {
    Interval { low: Float::with_val(COARSE, low), high: Float::with_val(COARSE, high) }
}

/// Numbers of all signs and sizes that fit `COARSE` bits, and zero.
fn numbers() -> impl Iterator<Item = f64> + Clone {
    let sizes = [0.0, 1e-3, 0.3, 0.999, 1.0, 1.5, 2.9, 7.3, 40.0].map(|size| Float::with_val(COARSE, size).to_f64());
    sizes.into_iter().flat_map(|size| [-size, size])
}

fn contains(found: &Interval, value: &Float) -> bool {
    found.low <= *value && *value <= found.high
}

/// Asserts that values at both ends and within lie in what is found, if anything is.
fn judge(name: &str, found: Result<Interval>, values: impl IntoIterator<Item = Float>) -> bool {
    let Ok(found) = found else { return false };
    for value in values.into_iter().filter(|value| !value.is_nan()) {
        assert!(contains(&found, &value), "{name}: {value} is not in {found:?}");
    }
    true
}

fn within(low: f64, high: f64) -> impl Iterator<Item = Float> {
    (0..=8).map(move |eighth| Float::with_val(300, low) + Float::with_val(300, high - low) * eighth / 8)
}

#[test]
fn values_of_functions_lie_within() {
    let functions: [Named; 17] = [
        ("sqrt", Float::sqrt),
        ("abs", Float::abs),
        ("exp", Float::exp),
        ("log", Float::ln),
        ("sin", Float::sin),
        ("cos", Float::cos),
        ("tan", Float::tan),
        ("asin", Float::asin),
        ("acos", Float::acos),
        ("atan", Float::atan),
        ("sinh", Float::sinh),
        ("cosh", Float::cosh),
        ("tanh", Float::tanh),
        ("asinh", Float::asinh),
        ("acosh", Float::acosh),
        ("atanh", Float::atanh),
        ("signum", |value| if value.is_zero() { value } else { value.signum() }),
    ];
    for (name, function) in functions {
        let mut found = 0;
        for low in numbers() {
            for high in numbers().filter(|high| *high >= low) {
                let values = within(low, high).map(function);
                found += u32::from(judge(name, interval(low, high).function(name), values));
            }
        }
        assert!(found > 20, "{name}: {found}");
    }
    assert_eq!(interval(0.0, 1.0).function("gamma").unwrap_err(), Unknown::Unsupported);
}

#[test]
fn values_of_operations_lie_within() {
    let pairs = || numbers().flat_map(|low| numbers().filter(move |high| *high >= low).map(move |high| (low, high)));
    let mut angles = 0;
    for (a, b) in pairs().step_by(3) {
        for (c, d) in pairs().step_by(5) {
            let (x, y) = (interval(a, b), interval(c, d));
            let of = |operation: fn(Float, Float) -> Float| {
                within(a, b).flat_map(move |x| within(c, d).map(move |y| operation(x.clone(), y)))
            };
            assert!(judge("sum", x.add(&y), of(|x, y| x + y)));
            assert!(judge("difference", x.sub(&y), of(|x, y| x - y)));
            assert!(judge("product", x.mul(&y), of(|x, y| x * y)));
            let divided = judge("quotient", x.div(&y), of(|x, y| x / y));
            assert_eq!(divided, c > 0.0 || d < 0.0);
            assert!(judge("maximum", Ok(x.clone().max(&y)), of(|x, y| x.max(&y))));
            angles += u32::from(judge("angle", Interval::angle(&x, &y), of(|x, y| x.atan2(&y))));
            judge("power", x.clone().real_power(&y), of(|x, y| if x.is_zero() { x } else { x.pow(y) }));
            if let Some(order) = x.order(&y) {
                assert!(of(|x, y| x - y).all(|difference| difference.cmp0() == Some(order)));
            }
        }
    }
    assert!(angles > 100, "{angles}");
}

#[test]
fn powers_and_roots_lie_within() {
    for low in numbers() {
        for high in numbers().filter(|high| *high >= low) {
            let x = interval(low, high);
            for exponent in [-3, -2, -1, 1, 2, 3, 4] {
                let whole = Integer::from(exponent);
                let found = judge("power", x.clone().power(&whole), within(low, high).map(|x| x.pow(exponent)));
                assert!(found || (exponent < 0 && low <= 0.0 && high >= 0.0));
            }
            assert!(judge("cube root", x.clone().root(3), within(low, high).map(Float::cbrt)));
            assert_eq!(judge("root", x.root(2), within(low, high).map(Float::sqrt)), high >= 0.0);
        }
    }
}

#[test]
fn a_value_is_told_where_both_ends_share_its_bits() {
    assert_eq!(interval(1.0, 1.0).value(50), Some(Float::with_val(COARSE, 1)));
    assert_eq!(interval(0.0, 0.0).value(50), Some(Float::new(COARSE)));
    assert_eq!(interval(1000.0, 1001.0).value(12), None);
    assert!(interval(1000.0, 1001.0).value(8).is_some());
    assert_eq!(interval(-1e-300, 1e-300).value(1), None);
    let tiny = Float::with_val(COARSE, Float::i_exp(1, -NOTHING - 2));
    assert_eq!(Interval { low: -tiny.clone(), high: tiny }.value(50), Some(Float::new(COARSE)));
    assert_eq!(interval(1.0, f64::INFINITY).value(1), None);
}
