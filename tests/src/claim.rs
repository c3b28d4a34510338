//! The judge of claims: the true form of a row, evaluated in MPFR, against the kernel that is said to ship it.

use std::collections::BTreeMap;

use closedform_maxima::{EvalError, Expr, ExprKind, evaluate};
use rug::{Float, Rational};

use crate::check::Judge;
use crate::complex::real_value;
use crate::errata::{Claim, Row, part};
use crate::failure::{list, replay};
use crate::inputs::Maker;
use crate::kernels;
use crate::ulp::{self, F64};

/// Bits in which true forms are evaluated, and in which their digits are confirmed.
const PRECISIONS: (u32, u32) = (2_048, 4_096);

/// Bits that both must agree in.
const BITS: u32 = 80;

/// By what the bits are divided where parts of a true form are not real: logarithms take their time.
const COMPLEX: u32 = 4;

/// Below 2^-LOWEST a value is noise about 0.
const LOWEST: i32 = 1_100;

/// Steps of an inversion; a linear argument takes two, a root of a tiny number many.
const STEPS: usize = 1_000;

/// What makes the points: moderate magnitudes, and places where terms vanish.
const MAKERS: [Maker; 5] = [Maker::Logarithmic, Maker::Reals, Maker::Edges, Maker::Subterms, Maker::NearEqual];

/// Of so many points one is moderate.
const MODERATE: usize = 8;

/// Whether every input is of a size at which the digits of a printed form can settle: it cancels where a kernel does not.
fn is_moderate(point: &[f64]) -> bool {
    point.iter().all(|input| *input == 0.0 || (1e-60..=1e60).contains(&input.abs()))
}

/// Values of the variables of a row.
type Names = BTreeMap<String, Float>;

/// A claim with the kernel it is about.
#[derive(Debug)]
pub struct Case<'a> {
    row: &'a Row,
    claim: &'a Claim,
    judge: Judge,
    result: usize,
}

impl<'a> Case<'a> {
    /// The case of a claim of a row, if a kernel computes its function.
    pub fn new(row: &'a Row, claim: &'a Claim) -> Result<Self, String> {
        let position = |kernel: &closedform::Kernel| {
            kernel.info.results.iter().position(|result| result.worksheet == claim.function)
        };
        let found = kernels::all().find_map(|kernel| Some((kernel.info.name, position(kernel)?)));
        let (name, result) = found.ok_or_else(|| format!("no kernel computes `{}`", claim.function))?;
        let judge = kernels::judge_of(name);
        let (found, wanted) = (claim.arguments.len(), judge.kernel.info.inputs.len());
        if found != wanted {
            return Err(format!("`{}` takes {wanted} arguments, not {found}", claim.function));
        }
        Ok(Case { row, claim, judge, result })
    }

    /// The kernel against the true form at `count` points of each maker; how many points were judged.
    ///
    /// # Errors
    ///
    /// The first point where they differ by more than the kernel's bound, or where the true form has no value.
    pub fn check(&self, seed: u64, count: usize) -> Result<usize, String> {
        let mut judged = 0;
        for maker in MAKERS {
            let points = self.judge.space.inside(maker, seed, MODERATE * count).list;
            for mut point in points.into_iter().filter(|point| is_moderate(point)).take(count) {
                let fits = self.bind(&mut point, PRECISIONS.0)?.is_some() && self.judge.space.admits(&point);
                if fits && self.check_at(&mut point)? {
                    judged += 1;
                }
            }
        }
        Ok(judged)
    }

    /// Whether there is something to judge: not where the true form divides by zero and its limit is meant, or has no
    /// digits left.
    fn check_at(&self, point: &mut [f64]) -> Result<bool, String> {
        let Some(exact) = self.truth(point)? else { return Ok(false) };
        let actual = self.judge.actual(point)[self.result];
        let (ulp, bound) = (ulp::distance(actual, &exact, F64), self.judge.bound(self.result));
        if ulp <= bound {
            return Ok(true);
        }
        let info = self.judge.kernel.info;
        let (told, again) = (list(info, point), replay(info, point));
        Err(format!(
            "true form {exact:.20}, kernel {actual:?}: {ulp:.3} ulp, bound {bound}\n{told}  replay     {again}"
        ))
    }

    /// The value of the true form where the kernel has these inputs; none where it divides by zero or
    /// its digits do not settle.
    fn truth(&self, point: &mut [f64]) -> Result<Option<Float>, String> {
        let mut at = |precision| {
            let names = self.bind(point, precision)?.ok_or("the inputs no longer fit")?;
            match evaluate(&self.claim.truth, &names, precision) {
                Err(EvalError::DivisionByZero { .. }) => Ok(None),
                Err(EvalError::NotReal { .. }) => {
                    let value = real_value(&self.claim.truth, &names, precision / COMPLEX);
                    value.map(Some).ok_or_else(|| format!("not a real number at {names:.6?}"))
                }
                Err(error) => Err(format!("{error} at {names:.6?}")),
                Ok(value) => Ok(Some(value)),
            }
        };
        let (Some(rough), Some(fine)) = (at(PRECISIONS.0)?, at(PRECISIONS.1)?) else { return Ok(None) };
        if fine.get_exp().is_none_or(|exponent| exponent < -LOWEST) {
            return Ok(Some(Float::new(BITS)));
        }
        let lost = Float::with_val(BITS, &rough - &fine).abs();
        if lost > Float::with_val(BITS, &fine).abs() >> BITS {
            return Ok(None);
        }
        Ok(Some(fine))
    }

    /// Whether the printed form, its part taken, has another value than the kernel at the example of the row; of an
    /// equation both sides count where the left one is a number.
    ///
    /// # Errors
    ///
    /// When the formula of the kernel has no value there.
    pub fn differs(&self) -> Result<bool, String> {
        let names = self.example(PRECISIONS.0);
        let value = |form: &Expr, names: &Names| evaluate(form, names, PRECISIONS.0);
        let inputs = self.claim.arguments.iter().map(|argument| value(argument, &names));
        let inputs = inputs.collect::<Result<Vec<Float>, _>>().map_err(|error| error.to_string())?;
        let shipped = self.shipped(&inputs)?;
        let other = |printed: Float| (printed.to_f64() - shipped).abs() > 1e-9 * shipped.abs();
        let Some((left, right)) = part(&self.row.printed, &self.claim.part) else { return Ok(true) };
        let left = left.and_then(|left| value(left, &Names::new()).ok());
        Ok(value(right, &names).map_or(true, &other) || left.is_some_and(&other))
    }

    /// What the kernel computes; at an edge that rounding leaves outside its domain, what its reference is worth.
    fn shipped(&self, inputs: &[Float]) -> Result<f64, String> {
        let rounded: Vec<f64> = inputs.iter().map(Float::to_f64).collect();
        let actual = self.judge.actual(&rounded)[self.result];
        if actual.is_finite() {
            return Ok(actual);
        }
        let exact = self.judge.oracle.value_at(self.result, inputs, PRECISIONS.0);
        exact.map(|exact| exact.to_f64()).map_err(|error| format!("`{}` at the example: {error}", self.claim.function))
    }

    fn example(&self, precision: u32) -> Names {
        let number = |(name, value): &(String, Rational)| (name.clone(), Float::with_val(precision, value));
        self.row.example.iter().map(number).collect()
    }

    /// The variables of the row for which the arguments are a point of the kernel, as far as they leave a choice; the
    /// inputs that they do not leave are put into the point. `None` where these are no doubles.
    fn bind(&self, point: &mut [f64], precision: u32) -> Result<Option<Names>, String> {
        let arguments = &self.claim.arguments;
        let mut names = Names::new();
        let (symbols, others): (Vec<usize>, Vec<usize>) =
            (0..arguments.len()).partition(|position| arguments[*position].as_symbol().is_some());
        for position in symbols.into_iter().chain(others) {
            let argument = &arguments[position];
            if !free(argument, &names).is_empty() {
                self.invert(argument, point[position], &mut names, precision)?;
                continue;
            }
            let value = evaluate(argument, &names, precision).map_err(|error| error.to_string())?;
            point[position] = value.to_f64();
            if value != point[position] {
                return Ok(None);
            }
        }
        Ok(Some(names))
    }

    /// Gives values to the names that an argument leaves open, so that it is `input`: to one of them the value that
    /// makes it so, to any others 5/4.
    fn invert(&self, argument: &Expr, input: f64, names: &mut Names, precision: u32) -> Result<(), String> {
        let unknowns = free(argument, names);
        for unknown in &unknowns {
            let mut given = names.clone();
            let others = unknowns.iter().filter(|name| *name != unknown);
            given.extend(others.map(|name| (name.clone(), Float::with_val(precision, 1.25))));
            let start = self.example(precision).remove(unknown).unwrap_or_else(|| Float::with_val(precision, input));
            if let Some(value) = solve(argument, unknown, input, start, &mut given, precision) {
                given.insert(unknown.clone(), value);
                *names = given;
                return Ok(());
            }
        }
        Err(format!("no {unknowns:?} make `{argument}` {input:?}"))
    }
}

/// The names in an expression that have no value yet.
fn free(expression: &Expr, names: &Names) -> Vec<String> {
    let mut free = Vec::new();
    collect(expression, &mut free);
    free.retain(|name| !names.contains_key(name));
    free.sort();
    free.dedup();
    free
}

fn collect(expression: &Expr, names: &mut Vec<String>) {
    match &expression.kind {
        ExprKind::Symbol(name) => names.push(name.clone()),
        ExprKind::Unary { operand, .. } => collect(operand, names),
        ExprKind::Binary { left, right, .. } => [left, right].into_iter().for_each(|side| collect(side, names)),
        ExprKind::Call { arguments, .. } => arguments.iter().for_each(|argument| collect(argument, names)),
        _ => {}
    }
}

/// The value of `unknown`, on the side of its start, at which the argument is `input`; by secants.
fn solve(argument: &Expr, unknown: &str, input: f64, start: Float, names: &mut Names, precision: u32) -> Option<Float> {
    let float = |value| Float::with_val(precision, value);
    let mut miss = |at: &Float| {
        names.insert(unknown.to_owned(), at.clone());
        Some(evaluate(argument, names, precision).ok()? - input)
    };
    let far = if start.is_zero() { float(1) } else { Float::with_val(precision, &start * 2u32) };
    let (mut old, mut new) = (start, far);
    let mut missed = miss(&old)?;
    for _ in 0..STEPS {
        let misses = miss(&new)?;
        if misses.is_zero() {
            return Some(new);
        }
        let slope = Float::with_val(precision, &misses - &missed);
        let step = Float::with_val(precision, &new - &old) * &misses / slope;
        let next = Float::with_val(precision, &new - &step);
        if !next.is_finite() {
            return None;
        }
        if step.abs() <= Float::with_val(precision, next.abs_ref()) >> (precision - 32) {
            return Some(next);
        }
        (old, missed, new) = (new, misses, next);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::errata;

    /// What comes out for the claims of rows that have this formula.
    fn check(printed: &str, call: &str, example: &str) -> Result<usize, String> {
        let text = format!(
            "[[output]]\ncell = 'a'\nprinted = '{printed}'\nexample = '{example}'\n[[output.kernel]]\ncall = '{call}'\n"
        );
        let rows = errata::parse(&text)?;
        Case::new(&rows[0], &rows[0].claims[0])?.check(1, 20)
    }

    #[test]
    fn true_forms_are_told_from_wrong_ones() {
        assert_eq!(check("v = a*t/2", "v2In(a,t)", "[]"), Ok(20 * 4));
        assert!(check("v = a*t/3", "v2In(a,t)", "[]").is_err());
        assert!(check("v = a*t*u/2", "v2In(a,t)", "[]").unwrap_err().contains("`u` has no value"));
        assert!(check("v = a*t/2", "v2In(a)", "[]").unwrap_err().contains("takes 2 arguments"));
        assert!(check("v = a*t/2", "no_such(a,t)", "[]").unwrap_err().contains("no kernel"));
    }

    #[test]
    fn arguments_are_inverted_with_the_signs_of_the_example() {
        assert_eq!(check("v = -a*b/2", "v2In(-a,b)", "[]"), Ok(20 * 4));
        assert_eq!(check("v = a^2*t/2", "v2In(a^2,t)", "[]"), Ok(20 * 4));
        assert_eq!(check("v = -a^3*t/abs(2*a)", "v2In(a^2,t)", "[a = -1]"), Ok(20 * 4));
        assert!(check("v = -a^3*t/abs(2*a)", "v2In(a^2,t)", "[a = 1]").is_err());
        assert_eq!(check("v = d/2", "v2In(d/t,t)", "[]"), Ok(20 * 4));
    }
}
