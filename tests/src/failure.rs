//! A broken bound, told so that it can be replayed.

use std::fmt;

use closedform::Info;
use closedform_project::hexfloat;
use rug::Float;

use crate::check::Judge;
use crate::ulp::{self, F64};

/// A result that is farther from its exact value than promised.
#[derive(Clone, Debug)]
pub struct Failure {
    info: &'static Info,
    result: usize,
    inputs: Vec<f64>,
    actual: f64,
    exact: Float,
    origin: String,
}

impl Failure {
    /// The failure of one result at a point.
    pub fn new(judge: &Judge, result: usize, inputs: &[f64], actual: f64, exact: &Float, origin: &str) -> Self {
        let (inputs, exact, origin) = (inputs.to_vec(), exact.clone(), origin.to_owned());
        Failure { info: judge.kernel.info, result, inputs, actual, exact, origin }
    }

    /// The inputs where it happens.
    pub fn inputs(&self) -> &[f64] {
        &self.inputs
    }

    /// The error.
    pub fn ulp(&self) -> f64 {
        ulp::distance(self.actual, &self.exact, F64)
    }
}

/// The command that shows one point of a kernel, its MPFR value beside it.
pub fn replay(info: &Info, inputs: &[f64]) -> String {
    let inputs = info.inputs.iter().zip(inputs);
    let assignments: Vec<String> =
        inputs.map(|(input, value)| format!("{}={}", input.maxima, hexfloat::print(*value))).collect();
    format!("closedform eval {} {} --digits 40", info.name, assignments.join(" "))
}

/// Inputs in decimal and hexadecimal, one a line.
pub fn list(info: &Info, inputs: &[f64]) -> String {
    let inputs = info.inputs.iter().zip(inputs);
    inputs.map(|(input, value)| format!("  {:<10} {value:?} = {}\n", input.maxima, hexfloat::print(*value))).collect()
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failure { info, inputs, actual, exact, origin, .. } = self;
        let result = &info.results[self.result];
        let bound = result.bound_ulp.unwrap_or(f64::NAN);
        writeln!(f, "{} breaks the bound of `{}`", info.name, result.name)?;
        f.write_str(&list(info, inputs))?;
        writeln!(f, "  {:<10} {exact:.40} = {}", "expected", hexfloat::print(exact.to_f64()))?;
        writeln!(f, "  {:<10} {actual:?} = {}", "actual", hexfloat::print(*actual))?;
        writeln!(f, "  {:<10} {:.3} ulp, bound {bound} ulp", "error", self.ulp())?;
        writeln!(f, "  {:<10} {origin}", "from")?;
        write!(f, "  {:<10} {}", "replay", replay(info, inputs))
    }
}
