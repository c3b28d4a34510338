//! The command `closedform`: reads its arguments and says what went wrong.

use clap::{Parser, Subcommand};
use closedform_codegen::command::{bound, check, derive, eval, generate, ledger, list, motion, mutants, show, verify};
use closedform_codegen::root::{self, project_root};
use closedform_codegen::worker::{self, Source};
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
        output: PathBuf,
        #[arg(long, required_unless_present = "worksheet")]
        folder: Option<PathBuf>,
        #[arg(long)]
        worksheet: Option<PathBuf>,
        #[arg(long, requires = "folder")]
        kernels: Option<PathBuf>,
    },
}

fn main() -> ExitCode {
    match run(Cli::parse()) {
        Ok(code) => code,
        Err(report) => {
            eprintln!("{report:?}");
            ExitCode::FAILURE
        }
    }
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
        Command::Worker { output, folder, worksheet, kernels } => {
            let source = match (folder, worksheet, kernels) {
                (_, Some(worksheet), _) => Source::Worksheet(worksheet),
                (Some(folder), _, Some(kernels)) => Source::Rederived { folder, kernels, allow_system: false },
                (Some(folder), _, None) => Source::Folder(folder),
                (None, None, _) => return Err(root::nothing_named()),
            };
            worker::work(&source, &output)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
