//! The check: every result's bound as derived, held against the one that is stated.

use crate::count::{Counter, integer};
use crate::forms::number;
use crate::refusal::{Reason, Refusal, TextError};
use crate::room::with_room;
use crate::trusted;
use closedform_syntax::{Kernel, Precision};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// A proved bound.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultBound {
    /// The kernel.
    pub kernel: String,
    /// The result.
    pub result: String,
    /// The count of its roundings: its relative error in units of 2^-53.
    pub units: BigRational,
    /// The bound in ulp, rounded up to a hundredth.
    pub ulp: f64,
    /// As stated.
    pub stated: f64,
}

/// A bound that was derived, whatever is stated.
#[derive(Clone, Debug, PartialEq)]
pub struct Derived {
    /// The result.
    pub result: String,
    /// The count of its roundings: its relative error in units of 2^-53.
    pub units: BigRational,
    /// The bound in ulp, rounded up to a hundredth.
    pub ulp: f64,
}

/// The bounds of a kernel's results, derived from its text. Its domain must be decided without rounding errors.
///
/// # Errors
/// One refusal for every result whose bound cannot be derived, and for every comparison that rounding may turn.
pub fn derive(kernel: &Kernel) -> Result<Vec<Derived>, Vec<Refusal>> {
    if kernel.meta.precision == Precision::Certified {
        let results = kernel.meta.results.iter().map(|meta| meta.name.to_string());
        return Ok(results.map(|result| derived(result, trusted::certified())).collect());
    }
    let counter = Counter::new(kernel);
    let (cases, mut refusals) = counter.domain();
    let mut bounds = Vec::new();
    for (value, meta) in kernel.output.values().zip(&kernel.meta.results) {
        let result = meta.name.to_string();
        let counts = cases.iter().map(|case| counter.count(value, case, &result));
        let worst = counts.reduce(|a, b| Ok(a?.max(b?))).unwrap_or_else(|| Ok(BigRational::zero()));
        match worst.map(|units| units + counter.last_rounding()) {
            Ok(units) => bounds.push(derived(result, units)),
            Err(refusal) if refusals.contains(&refusal) => {}
            Err(refusal) => refusals.push(refusal),
        }
    }
    if refusals.is_empty() { Ok(bounds) } else { Err(refusals) }
}

/// The bounds of a kernel's results, derived from its text and equal to those stated: not smaller, and larger by their
/// rounding up at most.
///
/// # Errors
/// As [`derive()`], and one refusal for every bound that is not the one stated.
pub fn check(kernel: &Kernel) -> Result<Vec<ResultBound>, Vec<Refusal>> {
    let held = derive(kernel)?.into_iter().zip(&kernel.meta.results).map(|(bound, meta)| {
        let name = kernel.name.to_string();
        held(&name, bound, meta.bound)
    });
    let (bounds, refusals): (Vec<_>, Vec<_>) = held.partition(Result::is_ok);
    if refusals.is_empty() {
        Ok(bounds.into_iter().flatten().collect())
    } else {
        Err(refusals.into_iter().filter_map(Result::err).collect())
    }
}

/// The bounds of every kernel of a source file.
///
/// # Errors
/// What keeps the text from being read, or every refusal.
pub fn check_text(text: &str) -> Result<Vec<ResultBound>, TextError> {
    with_room(|| {
        let kernels = closedform_syntax::parse_file(text).map_err(|cause| TextError::Unreadable(cause.to_string()))?;
        let (mut bounds, mut refusals) = (Vec::new(), Vec::new());
        for kernel in &kernels {
            match check(kernel) {
                Ok(more) => bounds.extend(more),
                Err(more) => refusals.extend(more),
            }
        }
        if refusals.is_empty() { Ok(bounds) } else { Err(TextError::Refused(refusals)) }
    })
}

/// How much larger than the derived bound the stated one may be, in ulp: both are rounded up to a hundredth.
fn slack() -> BigRational {
    BigRational::new(1.into(), 100.into())
}

fn derived(result: String, units: BigRational) -> Derived {
    let ulp = rounded_up(&in_ulp(&units)).to_f64().unwrap_or(f64::INFINITY);
    Derived { result, units, ulp }
}

fn held(kernel: &str, bound: Derived, stated: Option<f64>) -> Result<ResultBound, Refusal> {
    let Derived { result, units, ulp } = bound;
    let exact = in_ulp(&units);
    let refused = |reason| Refusal { kernel: kernel.to_owned(), step: result.clone(), reason };
    let Some(stated) = stated else { return Err(refused(Reason::Unstated { derived: ulp })) };
    if hundredths(stated) < exact {
        return Err(refused(Reason::Understated { stated, derived: ulp }));
    }
    if hundredths(stated) > rounded_up(&exact) + slack() {
        return Err(refused(Reason::Overstated { stated, derived: ulp }));
    }
    Ok(ResultBound { kernel: kernel.to_owned(), result, units, ulp, stated })
}

/// A count as a bound in ulp.
///
/// A relative error of k units is at most k ulp. Where the last operation rounds a value that is right to less than a
/// quarter of a unit, that rounding is at most half an ulp of the exact value, whose neighbour beyond a power of two it
/// cannot reach.
fn in_ulp(units: &BigRational) -> BigRational {
    let single = *units < BigRational::new(5.into(), 4.into());
    let bound = if single { units - BigRational::new(1.into(), 2.into()) } else { units.clone() };
    if bound.is_negative() { BigRational::zero() } else { bound }
}

fn rounded_up(bound: &BigRational) -> BigRational {
    (bound * integer(100)).ceil() / integer(100)
}

/// The decimal that a number of two digits after the point was before it became binary; other numbers as they are.
fn hundredths(stated: f64) -> BigRational {
    let rounded = (number(stated) * integer(100)).round() / integer(100);
    if rounded.to_f64() == Some(stated) { rounded } else { number(stated) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bound of a kernel with these conditions and this body, or what is refused.
    fn bound(conditions: &str, body: &str) -> Result<f64, String> {
        let text = format!("#[kernel(bound = 0)]\npub fn f(x: f64, y: f64, z: f64) -> f64 {{ {conditions} {body} }}");
        let kernels = closedform_syntax::parse_file(&text).map_err(|error| error.to_string())?;
        let Err(refusals) = check(&kernels[0]) else { return Ok(0.0) };
        match &refusals[..] {
            [Refusal { reason: Reason::Understated { derived, .. }, .. }] => Ok(*derived),
            other => Err(other.iter().map(ToString::to_string).collect()),
        }
    }

    const POSITIVE: &str = "require!(x > 0.0); require!(y > 0.0); require!(z > 0.0);";

    #[test]
    fn operations_count_as_they_round() {
        let counts = [
            ("x", 0.0),
            ("-x", 0.0),
            ("2.0 * x", 0.0),
            ("x / 8.0", 0.0),
            ("8.0 / x", 0.5),
            ("3.0 * x", 0.5),
            ("x - y", 0.5),
            ("x * y * z", 2.0),
            ("x * y / z", 2.0),
            ("sqrt(x)", 0.5),
            ("sqrt(x * y)", 1.5),
            ("abs(x * y)", 0.5),
            ("PI * x", 2.0),
            ("x * y + z", 2.0),
            ("x * y + y * z", 2.0),
            ("(x * y + z) * (x - y)", 4.0),
            ("compensated!(x * y - z)", 0.51),
            ("compensated!(x * y - z) * x", 2.01),
            ("if x > y { x * y } else { x * y * z }", 2.0),
            ("positive_root([-x, 0.0, y])", 0.51),
        ];
        for (body, expected) in counts {
            assert_eq!(bound(POSITIVE, body), Ok(expected), "{body}");
        }
    }

    #[test]
    fn in_double_double_only_the_last_rounding_counts() {
        let body = "sqrt(x) / (compensated!(x * y + z) * (x + y) + PI)";
        let text = |precision: &str, bound: f64, body: &str| {
            format!(
                "#[kernel(precision = {precision:?}, bound = {bound})]\npub fn f(x: f64, y: f64, z: f64) -> f64 {{ {POSITIVE} {body} }}"
            )
        };
        assert!(check_text(&text("double-double", 0.51, body)).is_ok());
        assert!(check_text(&text("double-double", 0.5, body)).is_err(), "understated");
        assert!(check_text(&text("double-double", 6.01, body)).is_err(), "overstated");
        assert!(check_text(&text("double", 0.51, body)).is_err(), "another precision");
        assert!(check_text(&text("double-double", 0.51, "x * y - z")).is_err(), "it may cancel");
    }

    #[test]
    fn signs_come_from_conditions_that_rounding_cannot_turn() {
        let body = "x * y - z";
        assert!(bound(POSITIVE, body).is_err());
        let needs = |condition: &str| bound(&format!("{POSITIVE} {condition}"), "x * (x - y) + z * (x - y)");
        assert!(needs("").unwrap_err().contains("may cancel"));
        assert_eq!(needs("require!(x >= y);"), Ok(3.0));
        assert_eq!(needs("require!(!(x < y));"), Ok(3.0));
        assert_eq!(needs("require!(x >= y || z > x && x >= y);"), Ok(3.0));
        assert_eq!(needs("require!(compensated!(x * x - x * y) > 0.0);"), Ok(3.0));
        assert!(needs("require!(x * x > y * y);").is_err(), "rounding may turn it");
        assert!(needs("require!(x >= y || z > x);").is_err());
        assert!(needs("require!(x >= 0.5 * y);").is_err());
    }

    #[test]
    fn no_rounding_decides_about_the_domain() {
        let decided = |condition: &str| bound(&format!("require!({condition});"), "x").map(|_| ());
        for condition in ["x >= 3.0 * y - 2.0 * y", "x * x > y * y", "x - y > z", "x > 0.0 || y * z > 1.0"] {
            assert!(decided(condition).unwrap_err().contains("rounding may turn"), "{condition}");
        }
        for condition in
            ["x >= 2.0 * y", "x - y > 0.0", "x * y > 0.0 && !(x * x + y * y == 0.0)", "sqrt(abs(x)) != 0.0"]
        {
            assert_eq!(decided(condition), Ok(()), "{condition}");
        }
        assert!(bound("require!(x > 0.0); require!(x * y - y > 0.0);", "x").is_err());
        assert_eq!(bound("require!(x > 0.0); require!(compensated!(x * y - y) > 0.0);", "x"), Ok(0.0));
    }

    #[test]
    fn branches_use_their_conditions() {
        let body = "if x >= y { z * z + (x - y) * z } else { z * z + (y - x) * z }";
        assert_eq!(bound(POSITIVE, body), Ok(3.0));
        assert!(bound(POSITIVE, &body.replace("x >= y", "y >= x")).is_err());
        let by_step = "let d = x - y; let e = if d >= 0.0 { d * z } else { -d * z }; z * z + e";
        assert_eq!(bound(POSITIVE, by_step), Ok(3.0));
        assert!(bound(POSITIVE, &by_step.replace("-d * z", "d * z")).is_err());
    }

    #[test]
    fn no_rounding_decides_between_different_values() {
        let refused = |body: &str| bound(POSITIVE, body).is_err_and(|said| said.contains("rounding may turn"));
        let turned = [
            "if x * y > 1.0 { x } else { 2.0 * y }",
            "if !(y < 1.0 && 1.0 >= x * y) { x } else { 2.0 * y }",
            "let p = x * y; let q = z * z; if p > q { x } else { 2.0 * y }",
            "if sqrt(x) > y { x } else { y }",
            "if x - y > z { x } else { y }",
            "let s = if x / y > z { x } else { y }; s * s",
            "max(x, if x * y == 1.0 { y } else { z })",
            "positive_root([-x, if x * y == 1.0 { y } else { z }])",
            "compensated!(x * y - 1.0) * (if PI * x > y { x } else { y })",
        ];
        for body in turned {
            assert!(refused(body), "{body}");
        }
        let but_for_a_pole = "if x * y > z * z { x + y } else { compensated!(x * x - y * y) / (x - y) }";
        assert!(bound(POSITIVE, but_for_a_pole).is_err_and(|said| said.contains("x - y")), "the same but for a pole");
        let kept = [
            ("if x > 2.0 * y { x } else { 2.0 * y }", 0.0),
            ("if x - y > 0.0 { x } else { 2.0 * y }", 0.0),
            ("if !(x * (x - y) / z < 0.0) { x } else { 2.0 * y }", 0.0),
            ("let c = compensated!(x * y - 1.0); if c > 0.0 { x } else { 2.0 * y }", 0.0),
            ("if -compensated!(x * y - 1.0) * sqrt(z) >= 0.0 { x } else { 2.0 * y }", 0.0),
            // the same function, whatever is turned
            ("if x * y > 1.0 { x * y } else { y * x }", 0.5),
            ("if x * y > 1.0 { x / y + z } else { (x + y * z) / y }", 3.0),
            (
                "let r = sqrt(x * x + y); if x * y > 1.0 { r + x } else { (y + 2.0 * (x * x) + 2.0 * (x * r)) / (r + x) }",
                8.0,
            ),
        ];
        for (body, expected) in kept {
            assert_eq!(bound(POSITIVE, body), Ok(expected), "{body}");
        }
    }

    #[test]
    fn roots_and_quotients_are_atoms_of_known_sign() {
        assert_eq!(bound("require!(x > 0.0);", "let r = sqrt(x * x + y * y); r * x + x"), Ok(4.0));
        assert_eq!(bound("", "x * x * (y - z) * (y - z) + 1.0"), Ok(6.0));
        assert!(bound("", "x * x * (y - z) * (y - x) + 1.0").is_err());
        assert_eq!(bound(POSITIVE, "x + x / (y + z)"), Ok(3.0));
        assert!(bound(POSITIVE, "x + x / (y - z)").is_err());
        assert!(bound("require!(x > 0.0);", "let r = sqrt(x * x + y * y); r * x + y").is_err());
    }

    #[test]
    fn bounds_are_rounded_up() {
        let printed = |thousandths: i64| {
            rounded_up(&in_ulp(&BigRational::new(thousandths.into(), 1000.into()))).to_f64().unwrap_or(f64::NAN)
        };
        assert_eq!([0, 1000, 1001, 1249, 1250, 2001, 4000].map(printed), [0.0, 0.5, 0.51, 0.75, 1.25, 2.01, 4.0]);
        assert_eq!(hundredths(8.01), BigRational::new(801.into(), 100.into()));
        assert!(hundredths(8.0099) < BigRational::new(801.into(), 100.into()));
    }
}
