//! The command `closedform`: reads its arguments and says what went wrong.

mod bar;
mod bind;
mod bound;
mod check;
mod columns;
mod completions;
mod derive;
mod description;
mod errata;
mod eval;
mod examples;
mod generate;
mod kernel_table;
mod ledger;
mod list;
mod motion;
mod mutants;
mod new;
mod own_crate;
mod program;
mod schema;
mod show;
mod verify;
mod words;
mod worker;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
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
    /// Say nothing but errors and what was asked for
    #[arg(long, short, global = true)]
    quiet: bool,
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
    Bind(bind::Args),
    Bound(bound::Args),
    Schema(schema::Args),
    Completions(completions::Completions),
    Man(completions::Man),
    /// Plan a move: times, peaks against limits, and the table that a controller takes
    Plan(motion::Args),
    /// The same, with a picture
    Plot(motion::Args),
}

fn main() -> ExitCode {
    let done = match read() {
        Ok(cli) => run(cli),
        Err(answer) if answer.use_stderr() => answer.exit(),
        // help and version
        Err(answer) => said(&answer),
    };
    match done {
        Ok(code) => code,
        Err(report) => {
            match report.downcast_ref::<OutputError>() {
                Some(full) => output::warn(&format!("closedform: {full}")),
                None => output::warn(&format!("{report:?}")),
            }
            ExitCode::FAILURE
        }
    }
}

/// The command with all that its help says.
fn command() -> clap::Command {
    examples::with_examples(Cli::command()).after_help(
        "Exit codes: 0 when all is done and right, 1 when something is wrong or cannot be done, 2 when the command line is not \
         understood.",
    )
}

fn read() -> Result<Cli, clap::Error> {
    let mut command = command();
    let matches = command.try_get_matches_from_mut(std::env::args_os())?;
    Cli::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
}

fn said(answer: &clap::Error) -> miette::Result<ExitCode> {
    output::unless_closed(answer.print().and_then(|()| io::stdout().flush()))?;
    Ok(ExitCode::SUCCESS)
}

fn run(cli: Cli) -> miette::Result<ExitCode> {
    if cli.quiet {
        output::be_quiet();
    }
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
        Command::Bind(args) => bind::run(&args, &project()?)?,
        Command::Bound(args) => bound::run(&args)?,
        Command::Schema(args) => schema::run(&args)?,
        Command::Completions(args) => completions::print(&args, command())?,
        Command::Man(args) => completions::write_manual(&args, command())?,
    }
    Ok(ExitCode::SUCCESS)
}
