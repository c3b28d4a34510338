//! The program `closedform-symbolica`, which the command `closedform` runs for everything that needs Symbolica.

use clap::{ArgGroup, Parser};
use closedform_symbolica::worker::{self, Task};
use closedform_system::output;
use miette::MietteHandlerOpts;
use std::path::PathBuf;
use std::process::ExitCode;

/// Makes and proves kernels for the command `closedform`, which takes turns with others and reads what this says
#[derive(Parser)]
#[command(name = "closedform-symbolica", version)]
#[command(group(ArgGroup::new("source").required(true).args(["folder", "worksheet"])))]
struct Cli {
    /// The process that asks: this one ends with it
    #[arg(long)]
    parent: u32,
    /// Generate all families of this folder
    #[arg(long)]
    folder: Option<PathBuf>,
    /// Generate the kernels of this worksheet
    #[arg(long, requires = "module")]
    worksheet: Option<PathBuf>,
    /// The module that they stand in
    #[arg(long)]
    module: Option<String>,
    /// Refuse the worksheet if one of them cannot be made
    #[arg(long, requires = "worksheet")]
    strict: bool,
    /// Leave out this kernel of the worksheet
    #[arg(long, value_name = "KERNEL", requires = "worksheet")]
    except: Vec<String>,
    /// Generate nothing: prove these kernels equal to what Maxima derives from the worksheets of the folder
    #[arg(long, requires = "folder")]
    kernels: Option<PathBuf>,
}

impl Cli {
    fn task(self) -> Option<Task> {
        match (self.folder, self.worksheet, self.kernels) {
            (_, Some(worksheet), _) => {
                let (strict, except) = (self.strict, self.except.into_iter().collect());
                self.module.map(|module| Task::Worksheet { worksheet, module, strict, except })
            }
            (Some(folder), _, Some(kernels)) => Some(Task::Rederived { folder, kernels }),
            (folder, ..) => folder.map(Task::Folder),
        }
    }
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let parent = cli.parent;
    let done = fit_errors().and_then(|()| match cli.task() {
        Some(task) => Ok(worker::work(&task, parent)?),
        None => Ok(()), // the arguments' group asks for one
    });
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(report) => {
            output::note(&format!("{report:?}"));
            ExitCode::FAILURE
        }
    }
}

/// Errors appear on the command's terminal, as wide as that says.
fn fit_errors() -> miette::Result<()> {
    let width = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
    let Some(width) = width else { return Ok(()) };
    miette::set_hook(Box::new(move |_| Box::new(MietteHandlerOpts::new().width(width).build())))?;
    Ok(())
}
