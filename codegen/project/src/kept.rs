//! Kept worst inputs, `worst/FAMILY.tsv` among the records: what searches found, to be judged before anything else.

use std::path::{Path, PathBuf};
use std::{fs, io};

use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error;

use super::hexfloat;

/// Where the files are, among the records of a project.
pub const FOLDER: &str = "worst";

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

/// Why there are no kept inputs.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum KeptError {
    /// A file or the folder cannot be read or written.
    #[error("cannot read or write {}: {cause}", path.display())]
    #[diagnostic(help("get the right to read and write there"))]
    File {
        /// Which.
        path: PathBuf,
        /// Why not.
        cause: io::Error,
    },
    /// A line is none.
    #[error("this is no line of kept inputs: kernel, result, ulp and name=0x1.8p-3 .., separated by tabs")]
    #[diagnostic(help("delete it and run `closedform verify --search 60s --keep`, which writes this file"))]
    Line {
        /// The file.
        #[source_code]
        text: NamedSource<String>,
        /// The line.
        #[label("here")]
        place: SourceSpan,
    },
}

/// Everything that is kept among these records; nothing where they have no such folder.
///
/// # Errors
///
/// When a file cannot be read.
pub fn load(records: &Path) -> Result<Vec<Kept>, KeptError> {
    let folder = records.join(FOLDER);
    let mut kept = Vec::new();
    if folder.is_dir() {
        for path in files(&folder).map_err(failed(&folder))? {
            let text = fs::read_to_string(&path).map_err(failed(&path))?;
            kept.extend(parse(&path, &text)?);
        }
    }
    Ok(kept)
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

/// Reads kept inputs from text; `path` names it in errors.
///
/// # Errors
///
/// The first line that is none.
pub fn parse(path: &Path, text: &str) -> Result<Vec<Kept>, KeptError> {
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

    #[test]
    fn lines_are_read_exactly() {
        let kept = parse(Path::new("t.tsv"), "# comment\na::b\tc\t1.500\tx=0x1.8p-3 y=-0x1p+0\n").unwrap();
        let inputs = vec![("x".to_owned(), 0.1875), ("y".to_owned(), -1.0)];
        assert_eq!(kept, [Kept { kernel: "a::b".to_owned(), result: "c".to_owned(), ulp: 1.5, inputs }]);
    }

    #[test]
    fn bad_lines_are_pointed_at() {
        for line in ["a\tb\tc\tx=0x1p+0", "a\tb\t1.0", "a\tb\t1.0\tx=1.5", "a\tb\t1.5\tx"] {
            let Err(KeptError::Line { place, .. }) = parse(Path::new("t.tsv"), &format!("# é\n{line}\n")) else {
                panic!("{line}")
            };
            assert_eq!((place.offset(), place.len()), (5, line.len()));
        }
    }
}
