//! The command `closedform-motion`, which `closedform plan` and `closedform plot` hand on to.

mod error;
mod export;
mod five_segment;
mod gallery;
mod input;
mod limits;
mod milling;
mod output;
mod points;
mod raster_scan;
mod standard;
mod step;
mod summary;
mod waypoints;

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use error::Outcome;
use output::Output;

/// What a shell says of a command that was interrupted.
const INTERRUPTED: i32 = 130;

/// What the command is called by who has only this one.
const OWN_NAME: &str = "closedform-motion";

/// The environment variable with which `closedform` says that it hands on, so that help names the command that was typed.
const CALLED_BY_CLOSEDFORM: &str = "CLOSEDFORM_HANDS_ON";

/// Plans moves: times, tables for the controller, and pictures
#[derive(Parser)]
#[command(name = OWN_NAME, bin_name = OWN_NAME, version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Plan a move, and print its times and its peaks against the limits
    #[command(subcommand)]
    Plan(Kind),
    /// The same, with a picture in any case: KIND.svg, or what --picture says
    #[command(subcommand)]
    Plot(Kind),
    /// Draw the pictures of the README
    #[command(hide = true)]
    Gallery {
        /// Where to
        folder: PathBuf,
    },
}

#[derive(Subcommand)]
enum Kind {
    /// A raster scan that flies along one axis and steps the other between lines, with the fastest turn-around that the limits
    /// of both axes allow, or one of the derivation
    #[command(allow_negative_numbers = true, visible_alias = "scan-skip")]
    RasterScan(Request<raster_scan::Inputs>),
    /// A move from rest to rest: the fastest under limits of velocity, acceleration and jerk, or by a shape of the derivation
    #[command(allow_negative_numbers = true)]
    Step(Request<step::Inputs>),
    /// A step in five segments, symmetric in time
    #[command(allow_negative_numbers = true)]
    FiveSegment(Request<five_segment::Inputs>),
    /// Polynomials through points, at a speed, in given times, or as fast as limits allow
    #[command(allow_negative_numbers = true)]
    Waypoints(Request<waypoints::Inputs>),
    /// The time of a G-code file or of a polyline
    #[command(allow_negative_numbers = true)]
    Milling(Request<milling::Inputs>),
}

/// What is known, and what is wanted.
#[derive(Args)]
struct Request<T: Args> {
    #[command(flatten)]
    inputs: T,
    #[command(flatten, next_help_heading = "Files")]
    output: Output,
}

impl Kind {
    fn name(&self) -> &'static str {
        match self {
            Self::RasterScan(_) => "raster-scan",
            Self::Step(_) => "step",
            Self::FiveSegment(_) => "five-segment",
            Self::Waypoints(_) => "waypoints",
            Self::Milling(_) => "milling",
        }
    }

    fn output(&mut self) -> &mut Output {
        match self {
            Self::RasterScan(request) => &mut request.output,
            Self::Step(request) => &mut request.output,
            Self::FiveSegment(request) => &mut request.output,
            Self::Waypoints(request) => &mut request.output,
            Self::Milling(request) => &mut request.output,
        }
    }

    /// With a picture, where none is asked for.
    fn drawn(mut self) -> Self {
        let name = PathBuf::from(format!("{}.svg", self.name()));
        self.output().picture.get_or_insert(name);
        self
    }

    fn run(mut self) -> Outcome<()> {
        self.output().check()?;
        match &self {
            Self::RasterScan(request) => raster_scan::run(&request.inputs, &request.output),
            Self::Step(request) => step::run(&request.inputs, &request.output),
            Self::FiveSegment(request) => five_segment::run(&request.inputs, &request.output),
            Self::Waypoints(request) => waypoints::run(&request.inputs, &request.output),
            Self::Milling(request) => milling::run(&request.inputs, &request.output),
        }
    }
}

impl Cli {
    /// The arguments, read by the command under the name that was typed.
    fn try_read() -> Result<Self, clap::Error> {
        let name = if std::env::var_os(CALLED_BY_CLOSEDFORM).is_some() { "closedform" } else { OWN_NAME };
        let mut command = Self::command().name(name).bin_name(name);
        let matches = command.try_get_matches_from_mut(std::env::args_os())?;
        Self::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
    }
}

fn main() -> ExitCode {
    // without a handler an interrupt leaves the file that was begun; nothing else depends on it
    _ = ctrlc::set_handler(|| {
        closedform_motion::remove_begun();
        std::process::exit(INTERRUPTED);
    });
    let outcome = match Cli::try_read() {
        Ok(cli) => run(cli.command),
        Err(answer) if answer.use_stderr() => answer.exit(),
        // help and version
        Err(answer) => output::unless_closed(answer.print().and_then(|()| io::stdout().flush())),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            output::note(&format!("error: {}", failure.message()));
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> Outcome<()> {
    match command {
        Command::Plan(kind) => kind.run(),
        Command::Plot(kind) => kind.drawn().run(),
        Command::Gallery { folder } => gallery::run(&folder),
    }
}
