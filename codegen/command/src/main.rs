//! The command `closedform`: reads its arguments and says what went wrong.

mod bound;
mod check;
mod columns;
mod derive;
mod description;
mod errata;
mod eval;
mod generate;
mod kernel_table;
mod ledger;
mod list;
mod motion;
mod mutants;
mod new;
mod own_crate;
mod program;
mod show;
mod verify;
mod worker;

use clap::{Parser, Subcommand};
use closedform_project::Project;
use closedform_system::output::{self, OutputError};
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
    New(new::Args),
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
            match report.downcast_ref::<OutputError>() {
                Some(full) => output::note(&format!("closedform: {full}")),
                None => output::note(&format!("{report:?}")),
            }
            ExitCode::FAILURE
        }
    }
}

fn said(answer: &clap::Error) -> miette::Result<ExitCode> {
    output::unless_closed(answer.print().and_then(|()| io::stdout().flush()))?;
    Ok(ExitCode::SUCCESS)
}

fn run(cli: Cli) -> miette::Result<ExitCode> {
    let project = || Project::find(cli.root.as_deref());
    match cli.command {
        Command::Plan(args) => return motion::run("plan", &args),
        Command::Plot(args) => return motion::run("plot", &args),
        Command::New(args) => new::run(&args)?,
        Command::Generate(args) => generate::run(&args, &project()?)?,
        Command::Check(args) => check::run(&args, &project()?)?,
        Command::Derive(args) => derive::run(&args, &project()?)?,
        Command::List(args) => list::run(&args, &project()?)?,
        Command::Show(args) => show::run(&args, &project()?)?,
        Command::Eval(args) => eval::run(&args, &project()?)?,
        Command::Verify(args) => verify::run(&args, &project()?)?,
        Command::Ledger(args) => ledger::run(&args, &project()?)?,
        Command::Mutants(args) => mutants::run(&args, &project()?)?,
        Command::Bound(args) => bound::run(&args)?,
    }
    Ok(ExitCode::SUCCESS)
}
