//! Equality without Symbolica: the generator's own, smaller ring proves what it can in little time, and says what it left.

use super::error::CheckError;
use closedform_generator::algebra::{Algebra, Sparse};
use closedform_generator::pipeline::{PipelineError, unproved};
use closedform_project::Project;
use closedform_project::family::Family;
use miette::{IntoDiagnostic, WrapErr};

/// The ring that is here without Symbolica.
const ALGEBRA: Algebra = Algebra::by::<Sparse>();

/// Proves kernels equal to their references, and says how many.
///
/// # Errors
///
/// When a kernel is not equal to its reference.
pub fn check(project: &Project, families: &[Family]) -> miette::Result<String> {
    let (mut kernels, mut left, mut wrong) = (0, Vec::new(), Vec::new());
    for family in families {
        kernels += family.contract.kernels.len();
        for cause in open(project, family)? {
            match cause.kernel_beyond_limit() {
                Some(kernel) => left.push(kernel.to_owned()),
                None => wrong.push(cause.to_string()),
            }
        }
    }
    if wrong.is_empty() { Ok(text(kernels, &left)) } else { Err(CheckError::Unproved(wrong).into()) }
}

fn open(project: &Project, family: &Family) -> miette::Result<Vec<PipelineError>> {
    let path = project.generated().join(format!("{}.rs", family.name));
    let text = std::fs::read_to_string(&path).into_diagnostic();
    let text = text.wrap_err_with(|| format!("cannot read {}", project.shown(&path)))?;
    Ok(unproved(ALGEBRA, family, &text, |_, _| ()))
}

fn text(kernels: usize, left: &[String]) -> String {
    match left {
        [] if kernels == 1 => "equal: the kernel is what its references say\n".to_owned(),
        [] => format!("equal: all {kernels} kernels are what their references say\n"),
        _ => format!(
            "equal: {} of {kernels} kernels are what their references say; `closedform check --prove` proves the others:\n  {}\n",
            kernels - left.len(),
            left.join("\n  ")
        ),
    }
}
