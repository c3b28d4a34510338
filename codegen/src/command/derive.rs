//! `closedform derive`: Maxima runs the worksheets; references, golden values and verdicts are written anew.

use super::generate::worksheets;
use super::verdicts::Page;
use crate::worksheet::derive::{Options, derive};
use crate::worksheet::family::family_names;
use clap::Args as ClapArgs;
use miette::bail;
use std::path::{Path, PathBuf};

/// Run worksheets in Maxima and write their reference expressions and golden values, and the verdicts on the scans
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
}

/// Derives all families first, and writes their files then.
///
/// # Errors
///
/// When a worksheet asks, fails, loops or does not fulfil its contract, or a verdict is wrong; nothing is written then.
pub fn run(args: &Args, root: &Path) -> miette::Result<()> {
    let folder = args.folder.clone().unwrap_or_else(|| worksheets(root));
    let names = if args.families.is_empty() { family_names(&folder)? } else { args.families.clone() };
    if names.is_empty() {
        bail!(
            help = "write a worksheet NAME.mac and its contract NAME.toml there; ARCHITECTURE.md shows a contract",
            "{} holds no contract NAME.toml: there is nothing to derive",
            folder.display()
        );
    }
    let mut options = Options::default();
    options.maxima.allow_system |= args.allow_system;
    let mut derived = Vec::new();
    for name in &names {
        derived.push((name, derive(&folder, name, &options)?));
    }
    let page = Page::of(&folder, &names, &options.maxima)?;
    for (name, family) in derived {
        family.write()?;
        println!("{name}: {} reference expressions, {} golden values", family.definitions.len(), family.values.len());
    }
    page.map_or(Ok(()), |page| Ok(page.write()?))
}
