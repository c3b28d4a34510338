//! Kept worst inputs, `tests/worst/FAMILY.tsv`: what hunts found, to be judged before anything else.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{fs, io};

use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error;

use crate::accuracy::{Worst, ulp_text};
use crate::catalogue::{Catalogue, Entry};
use closedform_project::folder;
use closedform_project::hexfloat;

/// Where the files are, below the root.
const FOLDER: &str = "tests/worst";

/// How many inputs are kept of a result.
const COUNT: usize = 3;

/// The inputs at which a result was found to be worst.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// `family::name`
    pub kernel: String,
    /// The result.
    pub result: String,
    /// The error in ulp, rounded up to three decimals.
    pub ulp: f64,
    /// Worksheet names and values of the inputs, in order.
    pub inputs: Vec<(String, f64)>,
}

/// All kept inputs of a project.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KeptInputs(Vec<Kept>);

/// Why there are no kept inputs.
#[derive(Debug, Error, Diagnostic)]
pub enum KeptError {
    /// A file or the folder cannot be read or written.
    #[error("cannot read or write {}: {cause}", path.display())]
    #[diagnostic(help("get the right to read and write there"))]
    File {
        /// Which.
        path: PathBuf,
        /// Why not.
        #[source]
        cause: io::Error,
    },
    /// A line is none.
    #[error("this is no line of kept inputs: kernel, result, ulp and name=0x1.8p-3 .., separated by tabs")]
    #[diagnostic(help("delete it and run `closedform verify --hunt 60s --keep`, which writes this file"))]
    Line {
        /// The file.
        #[source_code]
        text: NamedSource<String>,
        /// The line.
        #[label("here")]
        place: SourceSpan,
    },
}

impl KeptInputs {
    /// Those of the project at `root`; none where it has no such folder.
    ///
    /// # Errors
    ///
    /// When a file cannot be read.
    pub fn load(root: &Path) -> Result<Self, KeptError> {
        let folder = root.join(FOLDER);
        let mut kept = Vec::new();
        if folder.is_dir() {
            for path in files(&folder).map_err(failed(&folder))? {
                let text = fs::read_to_string(&path).map_err(failed(&path))?;
                kept.extend(parse(&path, &text)?);
            }
        }
        Ok(KeptInputs(kept))
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
    pub fn write(&self, root: &Path, catalogue: &Catalogue) -> Result<usize, KeptError> {
        let mut files: BTreeMap<String, String> = BTreeMap::new();
        for entry in catalogue.entries() {
            let kernel = entry.full_name();
            let text = files.entry(format!("{}.tsv", entry.family)).or_insert_with(|| header(&entry.family));
            self.0.iter().filter(|kept| kept.kernel == kernel).for_each(|kept| text.push_str(&line(kept)));
        }
        let folder = root.join(FOLDER);
        folder::replace(&folder, &files).map_err(failed(&folder))
    }
}

fn failed(path: &Path) -> impl FnOnce(io::Error) -> KeptError {
    let path = path.to_owned();
    |cause| KeptError::File { path, cause }
}

/// The files of kept inputs, sorted.
fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    let mut files: Vec<PathBuf> =
        paths.into_iter().filter(|path| path.extension().is_some_and(|e| e == "tsv")).collect();
    files.sort();
    Ok(files)
}

fn header(family: &str) -> String {
    format!(
        "# worst inputs of `{family}`, written by `closedform verify --hunt 60s --keep`; do not edit\n\
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

fn parse(path: &Path, text: &str) -> Result<Vec<Kept>, KeptError> {
    let mut kept = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r']);
        if !content.is_empty() && !content.starts_with('#') {
            let text = || NamedSource::new(path.display().to_string(), text.to_owned());
            let place = (start, content.len()).into();
            kept.push(parse_line(content).ok_or_else(|| KeptError::Line { text: text(), place })?);
        }
        start += line.len();
    }
    Ok(kept)
}

fn parse_line(line: &str) -> Option<Kept> {
    let [kernel, result, ulp, inputs] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
    let input = |text: &str| {
        let (name, value) = text.split_once('=')?;
        Some((name.to_owned(), hexfloat::parse(value).ok()?))
    };
    Some(Kept {
        kernel: kernel.to_owned(),
        result: result.to_owned(),
        ulp: ulp.parse().ok()?,
        inputs: inputs.split(' ').map(input).collect::<Option<_>>()?,
    })
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
        let text = fs::read_to_string(project.path().join("tests/worst/line.tsv")).unwrap();
        assert!(text.contains("line::root\troot\t2.001\taMax=0x1.8p+0 b=0x1.999999999999ap-4\n"), "{text}");
        let again = KeptInputs::load(project.path()).unwrap();
        assert_eq!(again, kept);
        assert_eq!(again.points(entry), [points[..COUNT].to_vec()]);
        assert_eq!(again.points(catalogue.find("plane::slope").unwrap()), [[[0.0; 0]; 0]; 2]);
    }

    #[test]
    fn lines_of_other_inputs_are_void_and_bad_ones_are_pointed_at() {
        let (_folder, catalogue) = fixture::catalogue();
        let entry = catalogue.find("line::root").unwrap();
        let kept = KeptInputs(parse(Path::new("t.tsv"), "line::root\troot\t1.000\tb=0x1p+0 aMax=0x1p+0\n").unwrap());
        assert_eq!(kept.points(entry), [[[0.0; 0]; 0]; 1]);
        for line in ["a\tb\tc\tx=0x1p+0", "a\tb\t1.0", "a\tb\t1.0\tx=1.5"] {
            let Err(KeptError::Line { place, .. }) = parse(Path::new("t.tsv"), &format!("# é\n{line}\n")) else {
                panic!("{line}")
            };
            assert_eq!((place.offset(), place.len()), (5, line.len()));
        }
    }
}
