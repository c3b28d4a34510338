//! `closedform derive`: Maxima runs the worksheets; references, golden values and verdicts are written anew.

use super::errata::Page;
use super::words::counted;
use clap::Args as ClapArgs;
use closedform_project::Project;
use closedform_project::derive::{Options, derive};
use closedform_project::family::family_names;
use closedform_system::output;
use miette::bail;
use std::path::PathBuf;
use std::time::Duration;

/// Run worksheets in Maxima and write their reference expressions and golden values, and the errata of the printed
/// derivations
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// The families; all of the folder if none is named
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
    let folder = args.folder.clone().unwrap_or_else(|| project.worksheets.clone());
    let names = if args.families.is_empty() { family_names(&folder)? } else { args.families.clone() };
    if names.is_empty() {
        bail!(
            help = "write a worksheet NAME.mac and its contract NAME.toml there; `closedform schema contract` says what one may hold",
            "{} holds no contract NAME.toml: there is nothing to derive",
            folder.display()
        );
    }
    let mut options = Options::within(&project.limits)?;
    options.maxima.allow_system |= args.allow_system;
    if let Some(seconds) = args.limit {
        options.maxima.limit = Duration::from_secs(seconds);
    }
    let mut derived = Vec::new();
    for name in &names {
        derived.push((name, derive(&folder, name, &options)?));
    }
    let page = Page::of(&folder, &names, &options.maxima)?;
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
