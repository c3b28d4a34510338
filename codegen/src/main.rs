//! The command `closedform`: reads its arguments and says what went wrong.

use clap::{Parser, Subcommand};
use closedform_codegen::command::{
    bound, check, derive, eval, generate, ledger, list, motion, mutants, output, show, verify,
};
use closedform_codegen::root::{self, project_root};
use closedform_codegen::worker::{self, Source};
use miette::MietteHandlerOpts;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

/// Maxima derivations to Rust kernels that keep their digits
#[derive(Parser)]
#[command(name = "closedform", version)]
struct Cli {
    /// The project, if not the one around the current folder
    #[arg(long, global = true, value_name = "DIR")]
    root: Option<PathBuf>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Generate(generate::Args),
    Check(check::Args),
    Derive(derive::Args),
    List(list::Args),
    Show(show::Args),
    Eval(eval::Args),
    Verify(verify::Args),
    Ledger(ledger::Args),
    Mutants(mutants::Args),
    Bound(bound::Args),
    /// Plan a move: times, peaks against limits, and the table that a controller takes
    Plan(motion::Args),
    /// The same, with a picture
    Plot(motion::Args),
    /// What `generate` and `check` run in a process of its own, because it needs Symbolica
    #[command(name = worker::SUBCOMMAND, hide = true)]
    Worker {
        /// The process that asks
        parent: u32,
        #[arg(long, required_unless_present = "worksheet")]
        folder: Option<PathBuf>,
        #[arg(long)]
        worksheet: Option<PathBuf>,
        #[arg(long, requires = "folder")]
        kernels: Option<PathBuf>,
    },
}

fn main() -> ExitCode {
    let done = match Cli::try_parse() {
        Ok(cli) => run(cli),
        Err(answer) if answer.use_stderr() => answer.exit(),
        // help and version
        Err(answer) => said(&answer),
    };
    match done {
        Ok(code) => code,
        Err(report) => {
            output::note(&format!("{report:?}"));
            ExitCode::FAILURE
        }
    }
}

fn said(answer: &clap::Error) -> miette::Result<ExitCode> {
    output::unless_closed(answer.print().and_then(|()| io::stdout().flush()))?;
    Ok(ExitCode::SUCCESS)
}

/// The worker's errors appear on the command's terminal, as wide as that says.
fn fit_errors() -> miette::Result<()> {
    let width = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
    let Some(width) = width else { return Ok(()) };
    miette::set_hook(Box::new(move |_| Box::new(MietteHandlerOpts::new().width(width).build())))?;
    Ok(())
}

fn run(cli: Cli) -> miette::Result<ExitCode> {
    let root = || project_root(cli.root.as_deref());
    match cli.command {
        Command::Plan(args) => return motion::run("plan", &args, &root()?),
        Command::Plot(args) => return motion::run("plot", &args, &root()?),
        Command::Generate(args) => generate::run(&args, &root()?)?,
        Command::Check(args) => check::run(&args, &root()?)?,
        Command::Derive(args) => derive::run(&args, &root()?)?,
        Command::List(args) => list::run(&args, &root()?)?,
        Command::Show(args) => show::run(&args, &root()?)?,
        Command::Eval(args) => eval::run(&args, &root()?)?,
        Command::Verify(args) => verify::run(&args, &root()?)?,
        Command::Ledger(args) => ledger::run(&args, &root()?)?,
        Command::Mutants(args) => mutants::run(&args, &root()?)?,
        Command::Bound(args) => bound::run(&args)?,
        Command::Worker { parent, folder, worksheet, kernels } => {
            let source = match (folder, worksheet, kernels) {
                (_, Some(worksheet), _) => Source::Worksheet(worksheet),
                (Some(folder), _, Some(kernels)) => Source::Rederived { folder, kernels, allow_system: false },
                (Some(folder), _, None) => Source::Folder(folder),
                (None, None, _) => return Err(root::nothing_named()),
            };
            fit_errors()?;
            worker::work(&source, parent)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
