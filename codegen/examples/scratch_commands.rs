//! Scratch.
use clap::Parser;
use closedform_codegen::command::{eval, list, show, verify};
use std::path::PathBuf;
#[derive(Parser)]
struct Cli { #[arg(long, default_value = ".")] root: PathBuf, #[command(subcommand)] command: Command }
#[derive(clap::Subcommand)]
enum Command { List(list::Args), Show(show::Args), Eval(eval::Args), Verify(verify::Args) }
fn main() -> miette::Result<()> {
    let cli = Cli::parse();
    match &cli.command {
        Command::List(a) => list::run(a, &cli.root),
        Command::Show(a) => show::run(a, &cli.root),
        Command::Eval(a) => eval::run(a, &cli.root),
        Command::Verify(a) => verify::run(a, &cli.root),
    }
}
