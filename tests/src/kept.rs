//! Kept worst inputs, `tests/worst/FAMILY.tsv`: what hunts found, judged before anything else.

use std::fs;
use std::path::Path;

use crate::check::Judge;
use crate::hex;
use crate::inputs::Points;

/// What to do about a file that is not as it should be.
const REMEDY: &str = "run `closedform verify --hunt 60s --keep` and commit tests/worst";

/// The inputs at which a result was found to be worst.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// `family::name`
    pub kernel: String,
    /// The result.
    pub result: String,
    /// The error in ulp, rounded up.
    pub ulp: f64,
    /// Worksheet names and values of the inputs, in order.
    pub inputs: Vec<(String, f64)>,
}

/// All that is kept.
pub fn load() -> Vec<Kept> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("worst");
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("tests/worst: {error}; {REMEDY}"));
    let mut paths: Vec<_> = files.map(|file| file.expect("tests/worst can be listed").path()).collect();
    paths.sort();
    let read = |path: &Path| {
        let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        parse(&text).unwrap_or_else(|line| panic!("{}: no kept input: {line}", path.display()))
    };
    paths.iter().flat_map(|path| read(path)).collect()
}

/// The kept inputs of a text, or the first line that is none.
pub fn parse(text: &str) -> Result<Vec<Kept>, String> {
    let lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(|line| parse_line(line).ok_or_else(|| line.to_owned())).collect()
}

fn parse_line(line: &str) -> Option<Kept> {
    let [kernel, result, ulp, inputs] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
    let input = |text: &str| {
        let (name, value) = text.split_once('=')?;
        Some((name.to_owned(), hex::parse(value)?))
    };
    let inputs = inputs.split(' ').map(input).collect::<Option<_>>()?;
    Some(Kept { kernel: kernel.to_owned(), result: result.to_owned(), ulp: ulp.parse().ok()?, inputs })
}

/// The points kept of a kernel, of all its results.
pub fn points(judge: &Judge, kept: &[Kept]) -> Points {
    let of_kernel = kept.iter().filter(|kept| kept.kernel == judge.kernel.info.name);
    let list = of_kernel.map(|kept| kept.inputs.iter().map(|(_, value)| *value).collect()).collect();
    Points { origin: "tests/worst".to_owned(), list }
}

/// What is wrong with what is kept, one line each: inputs that do not fit, errors that have grown, results without any.
pub fn complaints(judges: &[Judge], kept: &[Kept]) -> Vec<String> {
    let mut complaints: Vec<String> = kept.iter().filter_map(|kept| complaint(judges, kept)).collect();
    for judge in judges {
        for result in judge.kernel.info.results {
            let known = kept.iter().any(|kept| kept.kernel == judge.kernel.info.name && kept.result == result.name);
            if !known {
                complaints.push(format!("{}: no worst input of `{}`: {REMEDY}", judge.kernel.info.name, result.name));
            }
        }
    }
    complaints
}

fn complaint(judges: &[Judge], kept: &Kept) -> Option<String> {
    let stale = |what: String| Some(format!("{}, `{}`: {what}: {REMEDY}", kept.kernel, kept.result));
    let Some(judge) = judges.iter().find(|judge| judge.kernel.info.name == kept.kernel) else {
        return stale("there is no such kernel".to_owned());
    };
    let info = judge.kernel.info;
    let Some(result) = info.results.iter().position(|result| result.name == kept.result) else {
        return stale("there is no such result".to_owned());
    };
    let point: Vec<f64> = kept.inputs.iter().map(|(_, value)| *value).collect();
    let names = kept.inputs.iter().map(|(name, _)| name.as_str());
    if !names.eq(info.inputs.iter().map(|input| input.maxima)) || !judge.space.domain().contains(&point) {
        return stale("the inputs are others, or outside the domain".to_owned());
    }
    match judge.errors(&point, "tests/worst") {
        Err(failure) => Some(failure.to_string()),
        Ok(errors) if errors[result] > kept.ulp => {
            stale(format!("{:.4} ulp off where {} ulp were kept", errors[result], kept.ulp))
        }
        Ok(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_exactly() {
        let kept = parse("# comment\na::b\tc\t1.500\tx=0x1.8p-3 y=-0x1p+0\n").unwrap();
        let inputs = vec![("x".to_owned(), 0.1875), ("y".to_owned(), -1.0)];
        assert_eq!(kept, [Kept { kernel: "a::b".to_owned(), result: "c".to_owned(), ulp: 1.5, inputs }]);
        for line in ["a\tb\t1.5", "a\tb\tc\tx=0x1p+0", "a\tb\t1.5\tx=1.5", "a\tb\t1.5\tx"] {
            assert_eq!(parse(line), Err(line.to_owned()));
        }
    }
}
