//! Laws: results put back into the equations they solve.

use std::collections::BTreeMap;

use closedform_maxima::ast::BinaryOperator;
use closedform_maxima::{Expr, ExprKind, evaluate, parse_expression};
use rug::{Float, Rational};

use crate::check::Judge;
use crate::failure::{list, replay};
use crate::inputs::Points;
use crate::rational::{self, Names};
use crate::ulp::{self, F64};

/// Bits in which equations are evaluated.
const PRECISION: u32 = 512;

/// An equation or a condition between the inputs of a kernel, by their Maxima names, and its results, by names of the
/// law's own.
#[derive(Clone, Debug)]
pub struct Law {
    text: &'static str,
    claim: Expr,
}

impl Law {
    /// The law that a text states.
    ///
    /// # Panics
    ///
    /// It is not Maxima text.
    pub fn new(text: &'static str) -> Self {
        let claim = parse_expression(text).unwrap_or_else(|errors| panic!("law `{text}`: {errors}"));
        Law { text, claim }
    }

    /// Demands the law at every point: a condition of the results as they are, an equation up to what the bounds of the
    /// results allow. `names` are those of the results, in order.
    ///
    /// # Errors
    ///
    /// The first point where it does not hold.
    ///
    /// # Panics
    ///
    /// The law names what the kernel does not have.
    pub fn check(&self, judge: &Judge, names: &[&str], points: &Points) -> Result<(), String> {
        assert_eq!(names.len(), judge.kernel.info.results.len(), "{}: names of its results", judge.kernel.info.name);
        for inputs in &points.list {
            let results = judge.actual(inputs);
            let broken = match &self.claim.kind {
                ExprKind::Binary { operator: BinaryOperator::Equal, left, right } => {
                    let difference = |results: &[Float]| {
                        let names = names.iter().copied().zip(results);
                        self.side(judge, left, inputs, names.clone()) - self.side(judge, right, inputs, names)
                    };
                    exceeds(judge, inputs, &results, difference)
                }
                _ => (!self.holds(judge, inputs, names.iter().copied().zip(&results))).then(|| "is false".to_owned()),
            };
            if let Some(what) = broken {
                return Err(self.told(judge, inputs, &results, &points.origin, &what));
            }
        }
        Ok(())
    }

    fn holds<'a>(&self, judge: &Judge, inputs: &[f64], results: impl Iterator<Item = (&'a str, &'a f64)>) -> bool {
        let mut names: Names = judge.space.domain().exactly(inputs);
        names.extend(results.filter_map(|(name, value)| Some((name, Rational::from_f64(*value)?))));
        rational::holds(&self.claim, &names).unwrap_or(false)
    }

    fn side<'a>(
        &self,
        judge: &Judge,
        side: &Expr,
        inputs: &[f64],
        results: impl Iterator<Item = (&'a str, &'a Float)>,
    ) -> Float {
        let inputs = inputs.iter().map(|value| Float::with_val(PRECISION, value));
        let mut names: BTreeMap<String, Float> =
            judge.oracle.names().iter().map(|name| (*name).to_owned()).zip(inputs).collect();
        names.extend(results.map(|(name, value)| (name.to_owned(), value.clone())));
        evaluate(side, &names, PRECISION).unwrap_or_else(|error| panic!("law `{}`: {error}", self.text))
    }

    fn told(&self, judge: &Judge, inputs: &[f64], results: &[f64], origin: &str, what: &str) -> String {
        let info = judge.kernel.info;
        let (list, replay) = (list(info, inputs), replay(info, inputs));
        format!("{}: law `{}` {what}\n{list}  results {results:?}\n  from {origin}\n  {replay}", info.name, self.text)
    }
}

/// How `difference` is farther from zero at `results` than their bounds allow, if it is.
///
/// What they allow is how far the difference moves when each result moves by its bound.
fn exceeds(judge: &Judge, inputs: &[f64], results: &[f64], difference: impl Fn(&[Float]) -> Float) -> Option<String> {
    if !results.iter().all(|result| result.is_finite()) {
        return Some("has no finite results".to_owned());
    }
    let results: Vec<Float> = results.iter().map(|result| Float::with_val(PRECISION, result)).collect();
    let residual = difference(&results);
    let mut allowed = Float::new(PRECISION);
    for result in 0..results.len() {
        let error = ulp::unit(&judge.exact(result, inputs), F64) * judge.bound(result);
        let moved = |error: Float| {
            let mut moved = results.clone();
            moved[result] += error;
            (difference(&moved) - &residual).abs()
        };
        allowed += moved(error.clone()).max(&moved(-error));
    }
    (residual.clone().abs() > allowed).then(|| format!("is off by {residual:.6e}, allowed {allowed:.6e}"))
}

/// The largest share of points whose result rounding may take out of the domain of the next kernel.
const LEFT_SHARE: f64 = 0.05;

/// A kernel of one result and the Maxima name that this result goes by.
pub type Named<'a> = (&'a Judge, &'a str);

/// Demands that `second`, fed with the result of `first` and with its inputs, returns what `first` was given.
///
/// Inputs of the second that the first neither has nor returns are `constants`.
///
/// # Errors
///
/// The first point where it does not, to what the bounds of both allow.
///
/// # Panics
///
/// The kernels do not fit together, or too many points lead out of the domain of the second.
pub fn check_inverse(first: Named, second: Named, constants: &[(&str, f64)], points: &Points) -> Result<(), String> {
    let mut skipped = 0;
    for inputs in &points.list {
        let between = Between::new(first, second, constants, inputs);
        if !second.0.space.admits(&between.inputs) {
            skipped += 1;
        } else if let Some(what) = between.broken(first.0, second.0, inputs) {
            let (one, two) = (first.0.kernel.info, second.0.kernel.info);
            return Err(format!("{} of {}: {what}\n{}", two.name, one.name, list(one, inputs)));
        }
    }
    let (all, name) = (points.list.len(), second.0.kernel.info.name);
    assert!(skipped as f64 <= LEFT_SHARE * all as f64, "{name}: {skipped} of {all} points lead out of its domain");
    Ok(())
}

/// The inputs of a second kernel, made of those of a first and its result.
struct Between {
    inputs: Vec<f64>,
    /// Which of them is the result of the first.
    passed: usize,
    /// Which input of the first the second must return.
    returned: usize,
}

impl Between {
    fn new(first: Named, second: Named, constants: &[(&str, f64)], inputs: &[f64]) -> Self {
        let (one, two) = (first.0.oracle.names(), second.0.oracle.names());
        let mut values: BTreeMap<&str, f64> = constants.iter().copied().collect();
        values.insert(first.1, first.0.actual(inputs)[0]);
        values.extend(one.iter().copied().zip(inputs.iter().copied()));
        let value = |name: &&str| *values.get(name).unwrap_or_else(|| panic!("no `{name}` to pass"));
        let position = |names: &[&str], wanted: &str| {
            names.iter().position(|name| *name == wanted).unwrap_or_else(|| panic!("no `{wanted}` to pass"))
        };
        Between {
            inputs: two.iter().map(value).collect(),
            passed: position(two, first.1),
            returned: position(one, second.1),
        }
    }

    /// How the second is farther from the input of the first than both bounds allow, if it is.
    fn broken(&self, first: &Judge, second: &Judge, inputs: &[f64]) -> Option<String> {
        let expected = inputs[self.returned];
        let actual = second.actual(&self.inputs)[0];
        let exact = second.exact(0, &self.inputs);
        let own = ulp::unit(&exact, F64) * second.bound(0);
        let error = ulp::unit(&first.exact(0, inputs), F64) * first.bound(0);
        let allowed = own + self.moved(second, &exact, &error).max(&self.moved(second, &exact, &-error.clone()));
        let off = Float::with_val(exact.prec(), actual) - expected;
        (!actual.is_finite() || off.clone().abs() > allowed)
            .then(|| format!("{actual:?}, not {expected:?}: off by {off:.6e}, allowed {allowed:.6e}"))
    }

    /// How far the exact second moves when the result of the first does; endlessly where it leaves the reals.
    fn moved(&self, second: &Judge, exact: &Float, error: &Float) -> Float {
        let precision = exact.prec();
        let mut inputs: Vec<Float> = self.inputs.iter().map(|value| Float::with_val(precision, value)).collect();
        inputs[self.passed] += error;
        let moved = second.oracle.value_at(0, &inputs, precision);
        moved.map_or_else(|_| Float::with_val(precision, f64::INFINITY), |moved| (moved - exact).abs())
    }
}
