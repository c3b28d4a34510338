//! Golden values against the kernel's own program run in MPFR: what differs here is algebra, not rounding.

use rug::Float;
use rug::ops::Pow;

use crate::check::Judge;
use crate::golden::{DIGITS, GoldenValue};

/// Bits in which programs run: digits enough to spare for cancellation.
const PRECISION: u32 = 400;

/// Demands that the kernel equals the golden values of its results to all their digits; how many there were.
///
/// # Errors
///
/// The first golden value that it does not equal, or that lies outside the domain.
pub fn check_golden(judge: &Judge, golden: &[GoldenValue]) -> Result<usize, String> {
    let info = judge.kernel.info;
    let mut judged = 0;
    for (position, result) in info.results.iter().enumerate() {
        for value in golden.iter().filter(|value| value.worksheet == result.worksheet) {
            judged += 1;
            let differs = difference(judge, position, value);
            differs.map_or(Ok(()), |what| Err(format!("{}: {what}: {value:?}", info.name)))?;
        }
    }
    Ok(judged)
}

/// What is wrong at one golden value, if something is.
fn difference(judge: &Judge, result: usize, golden: &GoldenValue) -> Option<String> {
    let names: Vec<&str> = golden.inputs.iter().map(|(name, _)| name.as_str()).collect();
    let inputs: Vec<f64> = golden.inputs.iter().map(|(_, value)| *value).collect();
    if names != judge.oracle.names() {
        return Some(format!("its inputs are {:?}", judge.oracle.names()));
    }
    if let Some(condition) = judge.space.domain().violated(&inputs) {
        return Some(format!("outside the domain, `{condition}`"));
    }
    let expected = Float::with_val(PRECISION, Float::parse(&golden.value).ok()?);
    let actual = judge.program(&inputs, PRECISION).swap_remove(result);
    // One unit of the last of so many digits, of a number that begins with a one.
    let unit = Float::with_val(PRECISION, 10).pow(1 - DIGITS.cast_signed());
    let equal = Float::with_val(PRECISION, &actual - &expected).abs() <= unit * expected.abs();
    (!equal).then(|| format!("the program gives {actual:.40}"))
}
