//! What searches keep of the worst inputs: which ones, and of which kernels.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use crate::accuracy::{Worst, ulp_text};
use crate::catalogue::{Catalogue, Entry};
use closedform_project::kept::{self, FOLDER, Kept, KeptError};
use closedform_project::{folder, hexfloat};

/// How many inputs are kept of a result.
const COUNT: usize = 3;

/// All kept inputs of a project.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KeptInputs(Vec<Kept>);

impl KeptInputs {
    /// Those among the records of a project; none where they have no such folder.
    ///
    /// # Errors
    ///
    /// When a file cannot be read.
    pub fn load(records: &Path) -> Result<Self, KeptError> {
        Ok(KeptInputs(kept::load(records)?))
    }

    /// The points kept of each result of a kernel, in order. A line of inputs that the kernel does not have is void.
    pub fn points(&self, entry: &Entry) -> Vec<Vec<Vec<f64>>> {
        let (kernel, names) = (entry.full_name(), entry.maxima_names());
        let of_result = |result: String| {
            let kept = self.0.iter().filter(move |kept| kept.kernel == kernel && kept.result == result);
            let fitting = kept.filter(|kept| kept.inputs.iter().map(|(name, _)| name).eq(&names));
            fitting.map(|kept| kept.inputs.iter().map(|(_, value)| *value).collect()).collect()
        };
        entry.kernel.meta.results.iter().map(|result| of_result.clone()(result.name.to_string())).collect()
    }

    /// Keeps the worst of these points of a kernel, for each result, instead of what was kept of it.
    pub fn replace(&mut self, entry: &Entry, worst: &[Vec<Worst>]) {
        let kernel = entry.full_name();
        self.0.retain(|kept| kept.kernel != kernel);
        for (result, worst) in entry.kernel.meta.results.iter().zip(worst) {
            self.0.extend(worst.iter().take(COUNT).map(|worst| Kept {
                kernel: kernel.clone(),
                result: result.name.to_string(),
                ulp: rounded(worst.ulp),
                inputs: entry.maxima_names().into_iter().zip(worst.inputs.iter().copied()).collect(),
            }));
        }
    }

    /// Writes what is kept of the kernels of the catalogue, in its order.
    ///
    /// # Errors
    ///
    /// When a file cannot be written.
    pub fn write(&self, records: &Path, catalogue: &Catalogue) -> Result<usize, KeptError> {
        let mut files: BTreeMap<String, String> = BTreeMap::new();
        for entry in catalogue.entries() {
            let kernel = entry.full_name();
            let text = files.entry(format!("{}.tsv", entry.family)).or_insert_with(|| header(&entry.family));
            self.0.iter().filter(|kept| kept.kernel == kernel).for_each(|kept| text.push_str(&line(kept)));
        }
        let folder = records.join(FOLDER);
        folder::replace(&folder, &files).map_err(|cause| KeptError::File { path: folder, cause })
    }
}

fn header(family: &str) -> String {
    format!(
        "# worst inputs of `{family}`, written by `closedform verify --search 60s --keep`; do not edit\n\
         # kernel, result, error in ulp, inputs\n"
    )
}

fn line(kept: &Kept) -> String {
    let inputs = kept.inputs.iter().map(|(name, value)| format!("{name}={}", hexfloat::print(*value)));
    let inputs = inputs.collect::<Vec<_>>().join(" ");
    let mut line = String::new();
    let _ = writeln!(line, "{}\t{}\t{}\t{inputs}", kept.kernel, kept.result, ulp_text(kept.ulp));
    line
}

/// The error as the file says it.
fn rounded(ulp: f64) -> f64 {
    ulp_text(ulp).parse().unwrap_or(ulp)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;
    use rug::Float;

    fn worst(ulp: f64, inputs: &[f64]) -> Worst {
        Worst { ulp, inputs: inputs.to_vec(), got: 0.0, expected: Float::new(53) }
    }

    #[test]
    fn what_is_kept_comes_back() {
        let (_folder, catalogue) = fixture::catalogue();
        let project = tempfile::tempdir().unwrap();
        let entry = catalogue.find("line::root").unwrap();
        let mut kept = KeptInputs::load(project.path()).unwrap();
        assert_eq!(kept, KeptInputs::default());
        let points = [[1.5, 0.1], [2.0, 3.0], [4.0, 5.0], [6.0, 7.0]];
        kept.replace(entry, &[points.iter().map(|point| worst(2.0001, point)).collect()]);
        assert_eq!(kept.write(project.path(), &catalogue).unwrap(), 2);
        let text = std::fs::read_to_string(project.path().join("worst/line.tsv")).unwrap();
        assert!(text.contains("line::root\troot\t2.001\taMax=0x1.8p+0 b=0x1.999999999999ap-4\n"), "{text}");
        let again = KeptInputs::load(project.path()).unwrap();
        assert_eq!(again, kept);
        assert_eq!(again.points(entry), [points[..COUNT].to_vec()]);
        assert_eq!(again.points(catalogue.find("plane::slope").unwrap()), [[[0.0; 0]; 0]; 2]);
    }

    #[test]
    fn lines_of_other_inputs_are_void() {
        let (_folder, catalogue) = fixture::catalogue();
        let entry = catalogue.find("line::root").unwrap();
        let kept =
            KeptInputs(kept::parse(Path::new("t.tsv"), "line::root\troot\t1.000\tb=0x1p+0 aMax=0x1p+0\n").unwrap());
        assert_eq!(kept.points(entry), [[[0.0; 0]; 0]; 1]);
    }
}
