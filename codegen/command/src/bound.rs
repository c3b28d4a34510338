//! `closedform bound`: the bounds of hand-written kernels, proved from their Rust text, and entered on request.

use clap::Args as ClapArgs;
use closedform_bounds::{Derived, Keys, Place, Refusal, check, derive, place, with_room};
use closedform_bounds::{Edit, edited, enter, take_out};
use closedform_project::{ReadError, write_all};
use closedform_syntax::{Kernel, certified, sources};
use closedform_system::output;
use miette::{Diagnostic, NamedSource, SourceSpan};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use syn::Attribute;
use thiserror::Error;

/// Prove the error bounds of the `#[kernel]` functions in Rust files
///
/// Every result gets a line: its bound, or that there is none. What keeps a bound from being proved is shown with its
/// place and a remedy; so is a stated bound that is not the proved one, or that carries no valid certificate.
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// The source files
    #[arg(required = true, value_name = "FILE.rs")]
    files: Vec<PathBuf>,
    /// Enter proved bounds with their certificates into the attributes, and take out what is stated and not proved
    #[arg(long)]
    write: bool,
}

/// Not every bound is proved.
#[derive(Debug, Error, Diagnostic)]
#[error("not every bound is proved")]
struct Unproved(#[related] Vec<Refused>);

/// Why a file has bounds that are not proved.
#[derive(Debug, Error, Diagnostic)]
#[error("{message}")]
struct Refused {
    message: String,
    #[source_code]
    text: NamedSource<String>,
    #[label("here")]
    place: SourceSpan,
}

/// Files in which no bound can be stated.
#[derive(Debug, Error, Diagnostic)]
enum FileError {
    /// No kernel is in it.
    #[error("there is no `#[kernel]` function in {}", .0.display())]
    #[diagnostic(help("name the source file that has them; those in other files are not looked for"))]
    NoKernel(PathBuf),
    /// The edited attributes do not read back.
    #[error("cannot edit the attributes of {}: {}", .0.display(), .1)]
    #[diagnostic(help("write the attributes as `#[kernel]` or `#[kernel(key = .., ..)]`; the file is as it was"))]
    Uneditable(PathBuf, String),
}

/// Proves the bounds of files, and enters them on request.
///
/// # Errors
///
/// When a bound is not proved, or a file cannot be read or written.
pub fn run(args: &Args) -> miette::Result<()> {
    let mut refused = Vec::new();
    for path in &args.files {
        refused.extend(file(path, args.write)?);
    }
    if refused.is_empty() { Ok(()) } else { Err(Unproved(refused).into()) }
}

/// Proves the bounds of one file; what is refused in it.
fn file(path: &Path, write: bool) -> miette::Result<Vec<Refused>> {
    let remedy = "name a Rust source file that can be read".to_owned();
    let text = fs::read_to_string(path).map_err(|cause| ReadError { path: path.to_owned(), cause, remedy })?;
    let name = path.display().to_string();
    let report = with_room(|| Report::of(&name, &text, write));
    if report.is_empty {
        return Err(FileError::NoKernel(path.to_owned()).into());
    }
    if !report.edits.is_empty() {
        let edited = edited(&text, report.edits);
        reads_back(path, &edited)?;
        // a link stays one: what it leads to is replaced
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        write_all(&[(&target, &edited)])?;
    }
    output::print(&report.lines)?;
    Ok(report.complaints.into_iter().map(|complaint| complaint.of(&name, &text)).collect())
}

/// That what was entered is what a macro accepts.
fn reads_back(path: &Path, edited: &str) -> Result<(), FileError> {
    let kernels = sources(edited).map_err(|error| FileError::Uneditable(path.to_owned(), error.to_string()))?;
    let kernels = kernels.into_iter().flatten().filter_map(|source| source.parse().ok());
    let wrong = kernels.filter_map(|kernel: Kernel| certified(&kernel).err()).next();
    wrong.map_or(Ok(()), |error| Err(FileError::Uneditable(path.to_owned(), error.to_string())))
}

/// What is wrong at a place of a file.
struct Complaint {
    message: String,
    place: Place,
}

impl Complaint {
    fn of(self, name: &str, text: &str) -> Refused {
        let Self { message, place } = self;
        Refused { message, text: NamedSource::new(name, text.to_owned()), place: place.bytes.into() }
    }
}

/// What is said and done about a file.
#[derive(Default)]
struct Report {
    is_empty: bool,
    lines: String,
    complaints: Vec<Complaint>,
    edits: Vec<Edit>,
}

impl Report {
    fn of(name: &str, text: &str, write: bool) -> Self {
        let mut report = Self::default();
        match sources(text) {
            Err(error) => report.unreadable(error),
            Ok(sources) => {
                report.is_empty = sources.is_empty();
                for source in sources {
                    let read = source.and_then(|source| Ok((source.attribute.clone(), source.parse()?)));
                    match read {
                        Err(error) => report.unreadable(error),
                        Ok((attribute, kernel)) => report.kernel(File { name, text, write }, &attribute, &kernel),
                    }
                }
            }
        }
        report
    }

    fn unreadable(&mut self, errors: syn::Error) {
        self.complaints.extend(
            errors.into_iter().map(|error| Complaint {
                message: error.to_string(),
                place: Place::between(error.span(), error.span()),
            }),
        );
    }

    fn kernel(&mut self, file: File, attribute: &Attribute, kernel: &Kernel) {
        match derive(kernel) {
            Ok(bounds) => self.proved(file, attribute, kernel, &bounds),
            Err(refusals) => self.refused(file, attribute, kernel, &refusals),
        }
    }

    fn proved(&mut self, file: File, attribute: &Attribute, kernel: &Kernel, bounds: &[Derived]) {
        let complaints = complaints(kernel);
        let is_stated = is_stated(kernel);
        let remark = match (is_stated && complaints.is_empty(), file.write) {
            (true, _) => "as stated",
            (false, true) => "entered",
            (false, false) if is_stated => "not what is stated",
            (false, false) => "not stated; --write enters it",
        };
        for bound in bounds {
            self.line(file, kernel, &bound.result, &format!("at most {} ulp, {remark}", bound.ulp));
        }
        if remark == "entered" {
            let bounds: Vec<f64> = bounds.iter().map(|bound| bound.ulp).collect();
            self.edits.extend(enter(file.text, attribute, &Keys::of(kernel, &bounds)));
        } else {
            self.complaints.extend(complaints);
        }
    }

    fn refused(&mut self, file: File, attribute: &Attribute, kernel: &Kernel, refusals: &[Refusal]) {
        let taken_out = file.write && is_stated(kernel);
        let remark = if taken_out { "no bound is proved; what was stated is taken out" } else { "no bound is proved" };
        for result in &kernel.meta.results {
            self.line(file, kernel, &result.name.to_string(), remark);
        }
        self.complaints.extend(refusals.iter().map(|refusal| complaint(kernel, refusal)));
        if taken_out {
            self.edits.extend(take_out(file.text, attribute));
        }
    }

    fn line(&mut self, file: File, kernel: &Kernel, result: &str, what: &str) {
        let line = kernel.name.span().start().line;
        let kernel = kernel.name.to_string();
        let result = if result == kernel { kernel } else { format!("{kernel}, {result}") };
        let _ = writeln!(self.lines, "{}:{line}: {result}: {what}", file.name);
    }
}

/// The file that is looked at.
#[derive(Clone, Copy)]
struct File<'a> {
    name: &'a str,
    text: &'a str,
    write: bool,
}

fn is_stated(kernel: &Kernel) -> bool {
    kernel.meta.bound_place.is_some() || kernel.meta.certificate.is_some()
}

/// What is wrong with what a kernel states of bounds that can be proved.
fn complaints(kernel: &Kernel) -> Vec<Complaint> {
    if !is_stated(kernel) {
        return Vec::new();
    }
    match (check(kernel), certified(kernel)) {
        (Err(refusals), _) => refusals.iter().map(|refusal| complaint(kernel, refusal)).collect(),
        (Ok(_), Err(error)) => {
            let place = Place::between(error.span(), error.span());
            vec![Complaint { message: error.to_string(), place }]
        }
        (Ok(_), Ok(())) => Vec::new(),
    }
}

fn complaint(kernel: &Kernel, refusal: &Refusal) -> Complaint {
    Complaint { message: refusal.to_string(), place: place(kernel, refusal) }
}
