//! `closedform generate`: references to kernels, proved and measured; or a worksheet of one's own to a crate of its own.

mod summary;
mod watch;

use super::words::counted;
use super::{derive, kernel_table};
use crate::own_crate::{self, Draft, Runtime};
use crate::worker::{self, Source};
use clap::Args as ClapArgs;
use closedform_build::stale;
use closedform_measure::ledger;
use closedform_measure::ledger::change::changes;
use closedform_project::Project;
use closedform_project::family::worksheets_in;
use closedform_project::folder;
use closedform_project::generated::Made;
use closedform_system::output;
use miette::{IntoDiagnostic, WrapErr, bail};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Make the kernels from the reference expressions
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// A worksheet of definitions `f(x,y) := ..` to make a crate of, instead of this project's kernels: a text of Maxima (.mac,
    /// .dem), what wxMaxima saves (.wxm, .wxmx), or FPCores (.fpcore); or a folder of such files, which become a module each
    #[arg(long, value_name = "FILE|DIR", requires = "out")]
    input: Option<PathBuf>,
    /// The folder of that crate: a new one, or one with a crate, where only src/generated/ is written
    #[arg(long, value_name = "DIR", requires = "input")]
    out: Option<PathBuf>,
    /// Where a new crate takes the runtime from: `version`, the URL of a git repository, or a folder [default: the folder
    /// that this command was built from, as a relative path]
    #[arg(long, value_name = "WHERE")]
    runtime: Option<Runtime>,
    /// Again at every change of a worksheet or contract, which Maxima derives first where it has to, until Ctrl-C
    #[arg(long)]
    watch: bool,
    /// Refuse a worksheet of which anything would be passed over, instead of naming it and going on
    #[arg(long, requires = "input")]
    strict: bool,
    /// A row for every kernel, not one a family
    #[arg(long)]
    all: bool,
    /// How many points of each kernel's domain to measure for the table; the ledger and the page of kernels are written with the default only
    #[arg(long, default_value_t = ledger::POINTS)]
    points: u32,
}

/// Generates.
///
/// # Errors
///
/// When a family is wrong, a kernel cannot be made or proved, or files cannot be written.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    match (&args.input, &args.out) {
        (Some(input), Some(out)) if args.watch => {
            let folder = input.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            match input.is_dir() {
                true => watch::run(input, || folder_crate(args, input, out, project)),
                false => watch::run(folder, || own_crate(args, input, out, project)),
            }
        }
        (Some(input), Some(out)) if input.is_dir() => folder_crate(args, input, out, project),
        (Some(input), Some(out)) => own_crate(args, input, out, project),
        _ if args.watch => watch::run(&project.worksheets, || {
            derive_changed(project)?;
            whole(args, project)
        }),
        _ => whole(args, project),
    }
}

/// Lets Maxima run the worksheets that were changed since it ran them.
fn derive_changed(project: &Project) -> miette::Result<()> {
    let stale = stale(&project.generated(), &project.worksheets).into_diagnostic()?;
    let derived = stale.iter().filter(|stale| stale.path.starts_with(&project.worksheets));
    let families = derived.filter_map(|stale| Some(stale.path.file_stem()?.to_string_lossy().into_owned()));
    let families: BTreeSet<String> = families.collect();
    if families.is_empty() { Ok(()) } else { derive::run(&derive::Args::of(families), project) }
}

/// The kernels of the whole project.
fn whole(args: &Args, project: &Project) -> miette::Result<()> {
    let generated = worker::run(&Source::Folder(project.worksheets.clone()), &project.limits)?;
    if generated.kernels.is_empty() {
        bail!(
            help = "write a worksheet NAME.mac of definitions `f(x,y) := ..` there; or one that derives them, with a contract \
                    NAME.toml, and run `closedform derive`. `closedform new NAME` makes a project with an example",
            "{} holds no worksheet: there is nothing to make kernels of",
            project.worksheets.display()
        );
    }
    let draft = Draft::new(&generated)?;
    let catalogue = draft.catalogue()?;
    let rows = ledger::rows(&project.records, &catalogue, args.points)?;
    hold(&rows)?;
    let files = draft.whole(project.judges)?;
    let (_, ledger) = ledger::expected(&project.records, &rows)?;
    let changes = changes(&ledger, &rows, args.points == ledger::POINTS);
    let notes = own_crate::found(&project.kernels, &args.runtime.clone().unwrap_or_default(), &project.root)?;
    let mut changed = write(&project.generated(), &files)?;
    if args.points == ledger::POINTS {
        changed += usize::from(kernel_table::update(project, &catalogue, &rows)?);
        changed += usize::from(ledger::update(&project.records, &rows)?);
    }
    let table = if args.all { summary::each_kernel } else { summary::each_family };
    output::tell(&table(&generated.kernels, &rows, &changes))?;
    notes.iter().for_each(|note| output::note(note));
    remark(&generated.kernels);
    output::note(&format!(
        "{}, proved equal to reference expressions, with proved bounds; {} changed",
        counted(generated.kernels.len(), "kernel"),
        counted(changed, "file")
    ));
    Ok(())
}

/// A module for every worksheet of a folder; one of which nothing can be made is named and passed over.
fn folder_crate(args: &Args, input: &Path, out: &Path, project: &Project) -> miette::Result<()> {
    own_crate::check(out)?;
    let worksheets = worksheets_in(input)?;
    let mut refused = 0;
    for worksheet in &worksheets {
        output::note(&format!("{}:", worksheet.display()));
        if let Err(error) = own_crate(args, worksheet, out, project) {
            if args.strict {
                return Err(error);
            }
            output::warn(&format!("{error:?}"));
            refused += 1;
        }
    }
    match worksheets.len() - refused {
        0 => bail!(
            help = "write formulas such as f(x,y):=sqrt(x^2+y^2)$ into a worksheet there",
            "{} holds no worksheet of which kernels can be made",
            input.display()
        ),
        made => output::note(&format!("{made} of {} worksheets are modules of {}", worksheets.len(), out.display())),
    }
    Ok(())
}

fn own_crate(args: &Args, input: &Path, out: &Path, project: &Project) -> miette::Result<()> {
    own_crate::check(out)?;
    let module = own_crate::module(input, out);
    let generated = worker::run_sheet(input, &module.name, args.strict, &project.limits)?;
    let draft = Draft::new(&generated)?;
    let rows = ledger::rows(&out.join("records"), &draft.catalogue()?, args.points)?;
    output::tell(&summary::each_kernel(&generated.kernels, &rows, &[]))?;
    generated.refused.iter().for_each(|refused| output::note(&format!("passed over: {}", refused.because)));
    remark(&generated.kernels);
    hold(&rows)?;
    let runtime = args.runtime.clone().unwrap_or_default();
    let notes = own_crate::write(&draft, out, &runtime, &project.root)?;
    module.note().iter().chain(&notes).for_each(|note| output::note(note));
    let count = counted(generated.kernels.len(), "kernel");
    output::note(&format!("{count} in {}: `cargo test` there runs their judges", out.display()));
    Ok(())
}

fn write(target: &Path, files: &BTreeMap<String, String>) -> miette::Result<usize> {
    if let Some(path) = folder::foreign(files.keys().map(|name| target.join(name)), closedform_build::MARK)? {
        bail!(
            help =
                "a file without the mark of this command is never touched: rename it, or delete it if it is not needed",
            "{} was not generated",
            path.display()
        );
    }
    folder::replace(target, files).into_diagnostic().wrap_err_with(|| format!("cannot write {}", target.display()))
}

/// What the owner of a formula should know of its kernel.
fn remark(made: &[Made]) {
    for (kernel, because) in made.iter().filter_map(|made| Some((&made.kernel, made.certified_because.as_ref()?))) {
        output::note(&format!("`{kernel}` keeps its bound at run time, several hundred times slower: {because}"));
    }
    for kernel in made.iter().filter(|kernel| !kernel.added.is_empty()) {
        let added = kernel.added.join("`, `");
        let kernel = &kernel.kernel;
        output::note(&format!("`{kernel}` requires `{added}` too: its formula needs it, its contract does not say it"));
    }
}

/// Every measured error is within its bound.
pub fn hold(rows: &[ledger::Row]) -> miette::Result<()> {
    let wrong: Vec<&ledger::Row> = rows.iter().filter(|row| row.worst > row.bound).collect();
    let [first, ..] = wrong.as_slice() else { return Ok(()) };
    bail!(
        help =
            "a bound that does not hold is a mistake of the generator or of the domain; `closedform verify` shows more",
        "{} {} its bound: `{}` of `{}` is off by {} ulp at {}",
        wrong.len(),
        if wrong.len() == 1 { "result exceeds" } else { "results exceed" },
        first.result,
        first.kernel,
        first.worst_ulp,
        first.worst_inputs
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;
    use closedform_project::drawn::{drawn, has};

    #[test]
    fn an_error_beyond_its_bound_is_refused() {
        let (folder, catalogue) = fixture::catalogue();
        let rows = ledger::rows(folder.path(), &catalogue, 50).unwrap();
        let error = hold(&rows).unwrap_err();
        has(&drawn(error.as_ref()), &["1 result exceeds its bound", "`slope` of `line::slope`", "closedform verify"]);
        let right: Vec<ledger::Row> = rows.into_iter().filter(|row| row.kernel != "line::slope").collect();
        assert!(hold(&right).is_ok());
    }
}
