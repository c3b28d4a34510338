//! `closedform derive`: Maxima runs the worksheets; references, golden values and verdicts are written anew.

use super::errata::Page;
use super::words::counted;
use clap::Args as ClapArgs;
use closedform_project::Project;
use closedform_project::derive::{Derived, Options, derive, derive_sheet};
use closedform_project::family::{Family, family_names};
use closedform_project::layout::Limits;
use closedform_system::output;
use miette::bail;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Run worksheets in Maxima and write their reference expressions and golden values, and the errata of the printed
/// derivations
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// The families; all of the folder if none is named. A file, such as calc.mac, is a worksheet anywhere, which needs no
    /// contract: what it leaves under names becomes reference expressions beside it
    families: Vec<String>,
    /// The folder of worksheets and contracts, if not this project's
    #[arg(long, value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Let worksheets start programs, touch files and run Lisp, with your rights
    #[arg(long)]
    allow_system: bool,
    /// How many seconds of processor time each worksheet may use, instead of what CLOSEDFORM_MAXIMA_LIMIT or `maxima` in
    /// [limits] of closedform.toml say, or 120
    #[arg(long, value_name = "SECONDS")]
    limit: Option<u64>,
}

impl Args {
    /// Those of these families, with what is usual otherwise.
    pub fn of(families: impl IntoIterator<Item = String>) -> Self {
        Self { families: families.into_iter().collect(), folder: None, allow_system: false, limit: None }
    }
}

/// Derives all families first, and writes their files then.
///
/// # Errors
///
/// When a worksheet asks, fails, loops or does not fulfil its contract, or a verdict is wrong; nothing is written then.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let (sheets, families): (Vec<String>, Vec<String>) =
        args.families.iter().cloned().partition(|name| is_worksheet(Path::new(name)));
    for sheet in &sheets {
        one_worksheet(Path::new(sheet), &options(args, &project.limits)?)?;
    }
    if !sheets.is_empty() && families.is_empty() {
        return Ok(());
    }
    let folder = args.folder.clone().unwrap_or_else(|| project.worksheets.clone());
    let names = if families.is_empty() { family_names(&folder)? } else { families };
    if names.is_empty() {
        bail!(
            help = "write a worksheet NAME.mac and its contract NAME.toml there; `closedform schema contract` says what one may hold",
            "{} holds no contract NAME.toml: there is nothing to derive",
            folder.display()
        );
    }
    let options = options(args, &project.limits)?;
    let mut derived = Vec::new();
    for name in &names {
        derived.push((name.as_str(), derive(&folder, name, &options)?));
    }
    let page = Page::of(&folder, &names, &options.maxima)?;
    write(derived, page)
}

fn options(args: &Args, limits: &Limits) -> miette::Result<Options> {
    let mut options = Options::within(limits)?;
    options.maxima.allow_system |= args.allow_system;
    if let Some(seconds) = args.limit {
        options.maxima.limit = Duration::from_secs(seconds);
    }
    Ok(options)
}

/// Whether what is to be derived is a file, not the name of a family.
fn is_worksheet(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    ending.is_some_and(|ending| DERIVABLE.contains(&ending.as_str()))
}

/// How the names of worksheets end that Maxima may run.
const DERIVABLE: [&str; 4] = ["mac", "dem", "wxm", "wxmx"];

/// A worksheet anywhere: by its contract if it has one, else what it leaves.
fn one_worksheet(path: &Path, options: &Options) -> miette::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    if folder.join(format!("{stem}.toml")).exists() {
        return write(vec![(&stem, derive(folder, &stem, options)?)], None);
    }
    let sheet = derive_sheet(path, options)?;
    sheet.write()?;
    sheet.passed.iter().for_each(|line| output::note(line));
    let summary = Family::sheet(path)?.summary;
    summary.passed.iter().for_each(|passed| output::note(&format!("passed over: {}", passed.what)));
    let (count, reference) = (sheet.formulas, sheet.reference.display());
    output::tell(&format!("{}: {count} names with a value, written to {reference}\n", path.display()))?;
    output::note(&format!("`closedform generate --input {} --out DIR` makes kernels of them", path.display()));
    Ok(())
}

/// Writes what was derived, all or nothing, and says what it is.
fn write(derived: Vec<(&str, Derived)>, page: Option<Page>) -> miette::Result<()> {
    let mut said = String::new(); // when all is written
    let mut notes = Vec::new();
    for (name, family) in derived {
        family.write()?;
        let (expressions, values) = (family.definitions.len(), family.values.len());
        let (expressions, values) = (counted(expressions, "reference expression"), counted(values, "golden value"));
        said += &format!("{name}: {expressions}, {values}\n");
        for (kernel, conditions) in &family.added {
            let conditions = conditions.join("`, `");
            notes.push(format!(
                "`{kernel}` of {name} needs `{conditions}` too, which its contract does not say: its golden values are where \
                 that holds, and `closedform generate` adds it to the domain"
            ));
        }
    }
    if let Some(page) = page {
        page.write()?;
        said += &page.summary();
    }
    output::tell(&said)?;
    notes.iter().for_each(|note| output::note(note));
    Ok(())
}
