//! `closedform ledger`: what every result promises, what was measured and what it costs, written to `LEDGER.csv` among the records.

use super::kernel_table;
use super::words::counted;
use closedform_measure::catalogue::Catalogue;
use closedform_measure::ledger::{self, Row};
use closedform_project::Project;
use closedform_system::output;

/// Write the ledger of all kernels and the table of the project's page, if it has one, measured at the kept worst inputs and a sample
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Write JSON to standard output instead of a table
    #[arg(long)]
    json: bool,
}

/// Writes the ledger.
///
/// # Errors
///
/// When kernels cannot be read or measured, or files cannot be written.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let catalogue = Catalogue::open(project)?;
    let rows = ledger::rows(&project.records, &catalogue, ledger::POINTS)?;
    let changed = usize::from(kernel_table::update(project, &catalogue, &rows)?)
        + usize::from(ledger::update(&project.records, &rows)?);
    if args.json {
        output::print_json(&rows)?
    } else {
        output::print(&text(&rows))?
    }
    output::note(&format!("{}; {} changed", counted(rows.len(), "result"), counted(changed, "file")));
    Ok(())
}

fn text(rows: &[Row]) -> String {
    let header = ["kernel", "result", "bound", "worst", "as Maxima writes it", "cost", "faithful", "as written"];
    let cells = |row: &Row| {
        [
            row.kernel.clone(),
            row.result.clone(),
            row.bound_ulp.clone(),
            row.worst_ulp.clone(),
            row.as_written_ulp.clone(),
            row.default_cost.to_string(),
            row.faithful_cost.to_string(),
            row.as_written_cost.map_or_else(String::new, |cost| cost.to_string()),
        ]
    };
    let table = crate::columns::table(header, rows.iter().map(cells));
    format!("{table}\nerrors in ulp, costs in additions\n")
}
