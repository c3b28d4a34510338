//! `closedform check`: what is checked in is fresh and proved, as far as asked for.
//!
//! Without flags it needs neither Symbolica nor Maxima, so that every machine can run it. `--prove` generates everything
//! again; `--maxima` runs the worksheets.

mod equal;
mod error;
mod fresh;
mod live;

use super::{errata, kernel_table};
use clap::Args as ClapArgs;
use closedform_bounds::certified_bound_proof;
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_measure::ledger;
use closedform_project::Project;
use closedform_project::derive::Options;
use closedform_system::output;
use error::CheckError;

/// Check that everything generated is fresh and proved
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// Generate all kernels again, prove each, and compare every byte; needs Symbolica
    #[arg(long)]
    prove: bool,
    /// Run the worksheets in Maxima, and hold references, golden values and verdicts against what it derives
    #[arg(long)]
    maxima: bool,
    /// Let worksheets start programs, touch files and run Lisp, with your rights
    #[arg(long, requires = "maxima")]
    allow_system: bool,
}

/// Checks.
///
/// # Errors
///
/// When something is stale, unproved, or not what Maxima derives, or a verdict is wrong.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let options = options(args, project)?;
    if args.maxima {
        errata::check_live(&project.worksheets, &options.maxima)?;
        output::tell(&live::check(project, &options)?)?;
    } else {
        errata::check_list(&project.worksheets)?;
    }
    let families = fresh::check(project)?;
    let catalogue = Catalogue::load(&project.generated())?;
    bounded(&catalogue)?;
    recorded(project, &catalogue)?;
    let generated = project.shown(&project.generated());
    if args.prove {
        fresh::regenerate(project)?;
        output::tell(&format!("proved: {generated} is what the references generate, each kernel equal to its own\n"))?;
    } else {
        output::tell(&format!(
            "fresh: {generated} is as it was generated, of references as they are; bounds proved\n"
        ))?;
        output::tell(&equal::check(project, &families)?)?;
    }
    if args.prove && args.maxima {
        live::prove(project, &options)?;
        output::tell("live: every kernel is proved equal to what Maxima derives\n")?;
    }
    Ok(())
}

/// How worksheets are run again.
fn options(args: &Args, project: &Project) -> miette::Result<Options> {
    let mut options = Options::within(&project.limits)?;
    options.maxima.allow_system |= args.allow_system;
    Ok(options)
}

/// Every text of a kernel as checked in proves the bounds that it states.
fn bounded(catalogue: &Catalogue) -> miette::Result<()> {
    let proof = |entry: &Entry| Some((entry.full_name(), certified_bound_proof(&entry.kernel).err()?));
    let refused = catalogue.entries().iter().filter_map(proof);
    let refused = refused.map(|(name, cause)| format!("bound of `{name}`, re-derived from its Rust text: {cause}"));
    let refused: Vec<String> = refused.collect();
    if refused.is_empty() { Ok(()) } else { Err(CheckError::Unproved(refused).into()) }
}

/// Every measured error is within its bound, and ledger and table are what was measured.
fn recorded(project: &Project, catalogue: &Catalogue) -> miette::Result<()> {
    let rows = ledger::rows(&project.records, catalogue, ledger::POINTS)?;
    super::generate::hold(&rows)?;
    let table = kernel_table::expected(project, catalogue, &rows).filter(|(expected, present)| expected != present);
    let page = table.and(project.table.as_deref());
    let (expected, present) = ledger::expected(&project.records, &rows)?;
    // a project may do without a ledger
    let ledger = (expected != present && !present.is_empty()).then(|| ledger::path(&project.records));
    let stale = page.map(|page| format!("stale: the table of kernels in {}", project.shown(page)));
    let stale: Vec<String> =
        stale.into_iter().chain(ledger.map(|path| format!("stale: {}", project.shown(&path)))).collect();
    if stale.is_empty() { Ok(()) } else { Err(CheckError::Stale(stale).into()) }
}
