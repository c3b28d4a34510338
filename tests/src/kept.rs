//! What searches found and the project keeps, judged before anything else.

pub use closedform_project::kept::{Kept, parse};

use crate::check::Judge;
use crate::inputs::Points;
use crate::workspace;

/// What to do about a file that is not as it should be.
const REMEDY: &str = "run `closedform verify --search 60s --keep` and commit tests/worst";

/// All that is kept.
pub fn load() -> Vec<Kept> {
    let kept = closedform_project::kept::load(&workspace::root().join("tests"))
        .unwrap_or_else(|error| panic!("{error}; {REMEDY}"));
    assert!(!kept.is_empty(), "nothing is kept: {REMEDY}");
    kept
}

/// The points kept of a kernel, of all its results.
pub fn points(judge: &Judge, kept: &[Kept]) -> Points {
    let of_kernel = kept.iter().filter(|kept| kept.kernel == judge.kernel.info.name);
    let list = of_kernel.map(|kept| kept.inputs.iter().map(|(_, value)| *value).collect()).collect();
    Points { origin: "tests/worst".to_owned(), list }
}

/// What is kept of no kernel of these, one line each.
pub fn strangers(kernels: &[&str], kept: &[Kept]) -> Vec<String> {
    let strange = kept.iter().filter(|kept| !kernels.contains(&kept.kernel.as_str()));
    strange.map(|kept| stale(kept, "there is no such kernel")).collect()
}

/// What is wrong with what is kept of a kernel, one line each: inputs that do not fit, errors that have grown, results
/// without any.
pub fn complaints(judge: &Judge, kept: &[Kept]) -> Vec<String> {
    let info = judge.kernel.info;
    let own: Vec<&Kept> = kept.iter().filter(|kept| kept.kernel == info.name).collect();
    let mut complaints: Vec<String> = own.iter().filter_map(|kept| complaint(judge, kept)).collect();
    let unknown = info.results.iter().filter(|result| !own.iter().any(|kept| kept.result == result.name));
    complaints.extend(unknown.map(|result| format!("{}: no worst input of `{}`: {REMEDY}", info.name, result.name)));
    complaints
}

fn stale(kept: &Kept, what: &str) -> String {
    format!("{}, `{}`: {what}: {REMEDY}", kept.kernel, kept.result)
}

fn complaint(judge: &Judge, kept: &Kept) -> Option<String> {
    let stale = |what: &str| Some(stale(kept, what));
    let info = judge.kernel.info;
    let Some(result) = info.results.iter().position(|result| result.name == kept.result) else {
        return stale("there is no such result");
    };
    let point: Vec<f64> = kept.inputs.iter().map(|(_, value)| *value).collect();
    let names = kept.inputs.iter().map(|(name, _)| name.as_str());
    if !names.eq(info.inputs.iter().map(|input| input.maxima)) || !judge.space.domain().contains(&point) {
        return stale("the inputs are others, or outside the domain");
    }
    match judge.errors(&point, "tests/worst") {
        Err(failure) => Some(failure.to_string()),
        Ok(errors) if errors[result] > kept.ulp => {
            stale(&format!("{:.4} ulp off where {} ulp were kept", errors[result], kept.ulp))
        }
        Ok(_) => None,
    }
}
