//! The flags of `milling`, and what they make of machine, model and reading.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use closedform_motion::plan::milling::gcode::{Dialect, DwellUnit, Reading, Unknown};
use closedform_motion::plan::milling::{Arcs, Corner, Machine, Milling, Model, Rules};
use closedform_motion::plot::Colouring;
use serde::{Deserialize, Serialize};

use crate::error::{Failure, Outcome};

/// What becomes of a line that is not understood.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum UnknownFlag {
    Refuse,
    Skip,
}

/// The unit of P in a dwell.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum DwellFlag {
    Seconds,
    Milliseconds,
}

/// How the time is counted.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ModelFlag {
    /// As controllers do, without a stop where the path allows it
    LookAhead,
    /// From rest to rest in every move
    ExactStop,
    /// The derivation's: from rest to rest in steps of constant speed, up to 29 % too short
    Steps,
}

/// What the colour of a picture says.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ColourFlag {
    /// The largest speed of each move
    Speed,
    /// The speed that was asked for
    Feed,
    /// The height of the tool
    Z,
}

/// Which controller a file is for.
#[derive(ValueEnum, Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[value(rename_all = "lower")]
enum DialectFlag {
    LinuxCnc,
    Grbl,
    Marlin,
    Klipper,
    Fanuc,
}

/// What is known of the job.
#[derive(Args, Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Inputs {
    /// The program
    #[arg(long, value_name = "FILE")]
    pub gcode: Option<PathBuf>,
    /// Instead of a program, the corners of a polyline: a CSV file with a point (X,Y,Z in mm) a line; with --feed
    #[arg(long, value_name = "FILE")]
    pub points_file: Option<PathBuf>,
    /// Feed of the polyline, or of a program before its first F, in mm/s
    #[arg(long, value_name = "MM/S")]
    pub feed: Option<f64>,
    /// Which controller the program is for [default: guessed from the program, and said]
    #[arg(long)]
    dialect: Option<DialectFlag>,
    /// How the time is counted [default: look-ahead]
    #[arg(long)]
    model: Option<ModelFlag>,
    /// Limit of the acceleration, in mm/s²: one for all axes, or X,Y,Z [default: 500; printers 3000,3000,100]
    #[arg(long, value_name = "A[,A,A]", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    acceleration: Vec<f64>,
    /// Limit of the speed, in mm/s: one for all axes, or X,Y,Z [default: none; printers 300,300,5]
    #[arg(long, value_name = "V[,V,V]", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    speed: Vec<f64>,
    /// Speed of rapid moves (G0) along the path, in mm/s [default: 100]
    #[arg(long, value_name = "MM/S")]
    rapid: Option<f64>,
    /// Largest feed along the path, in mm/s; a larger one is cut to it [default: none]
    #[arg(long, value_name = "MM/S")]
    max_feed: Option<f64>,
    /// Look-ahead: how far a corner may seem to be cut, in mm [default: 0.01, as grbl; marlin 0.013; klipper 5 mm/s in
    /// a right-angled corner]
    #[arg(long, value_name = "MM")]
    junction_deviation: Option<f64>,
    /// Look-ahead: instead of a junction deviation, the jump of speed that X, Y, Z may make, in mm/s (classic jerk)
    #[arg(long, value_name = "V[,V,V]", value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    classic_jerk: Vec<f64>,
    /// Look-ahead: arcs are driven as chords that are no farther from them, in mm; 0 drives them as arcs, the
    /// acceleration across them within its limit [default: 0.002, as grbl; printers: chords of 1 mm]
    #[arg(long, value_name = "MM")]
    arc_tolerance: Option<f64>,
    /// Look-ahead: how many moves (of an arc, chords) are known beyond the one that is driven [default: 16, as grbl]
    #[arg(long, value_name = "MOVES")]
    look_ahead: Option<usize>,
    /// Look-ahead: limit of the jerk along the path, in mm/s³ [default: none]
    #[arg(long, value_name = "MM/S3")]
    jerk: Option<f64>,
    /// Look-ahead: which part of the way of a short move between corners is driven at one speed at least, from 0 to below 1
    /// [default: 0; klipper 0.5]
    #[arg(long, value_name = "RATIO")]
    minimum_cruise_ratio: Option<f64>,
    /// Model steps: the largest length of a step, in mm [default: 1]
    #[arg(long, value_name = "MM")]
    step: Option<f64>,
    /// The same as --model exact-stop
    #[arg(long, num_args = 0..=1, default_missing_value = "true", value_name = "BOOL")]
    continuous: Option<bool>,
    /// Where G28 and G30 go, in mm of the machine [default: where the tool is at the begin, and said]
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    home: Vec<f64>,
    /// A parameter that is set before the program begins, as often as needed: 100=2.5 for #100, depth=3 for #<depth>
    #[arg(long, value_name = "NAME=VALUE")]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    define: Vec<String>,
    /// How long a tool change takes, in s [default: 0]
    #[arg(long, value_name = "S")]
    tool_change: Option<f64>,
    /// How long the spindle takes to come to its speed, in s [default: 0]
    #[arg(long, value_name = "S")]
    spindle_start: Option<f64>,
    /// What becomes of a line that is not understood [default: refuse]
    #[arg(long)]
    unknown: Option<UnknownFlag>,
    /// Unit of P in a dwell, G4 P [default: seconds; marlin, klipper and fanuc milliseconds]
    #[arg(long)]
    dwell: Option<DwellFlag>,
    /// Leave out lines that begin with `/`
    #[arg(long, num_args = 0..=1, default_missing_value = "true", value_name = "BOOL")]
    block_delete: Option<bool>,
    /// What the colour of the picture says [default: speed]
    #[arg(long)]
    colour: Option<ColourFlag>,
    /// The most lines that loops and sub-programs may repeat [default: 20000000]
    #[arg(long, value_name = "LINES")]
    most_repeated: Option<u64>,
}

impl Inputs {
    /// What the colour of a picture says.
    pub fn colouring(&self) -> Colouring {
        match self.colour {
            Some(ColourFlag::Feed) => Colouring::Feed,
            Some(ColourFlag::Z) => Colouring::Height,
            Some(ColourFlag::Speed) | None => Colouring::Speed,
        }
    }

    /// The dialect that is asked for.
    pub fn dialect(&self) -> Option<Dialect> {
        self.dialect.map(|dialect| match dialect {
            DialectFlag::LinuxCnc => Dialect::LinuxCnc,
            DialectFlag::Grbl => Dialect::Grbl,
            DialectFlag::Marlin => Dialect::Marlin,
            DialectFlag::Klipper => Dialect::Klipper,
            DialectFlag::Fanuc => Dialect::Fanuc,
        })
    }

    /// Machine and model, where those of a dialect stand for what is not said.
    pub fn milling(&self, dialect: Option<Dialect>) -> Outcome<Milling> {
        let usual = dialect.map_or_else(Machine::default, Dialect::machine);
        let mut machine = Machine {
            acceleration: of_axes("acceleration", &self.acceleration, usual.acceleration)?,
            speed: of_axes("speed", &self.speed, usual.speed)?,
            rapid: self.rapid.unwrap_or(usual.rapid),
            feed: self.max_feed.unwrap_or(usual.feed),
            tool_change: self.tool_change.unwrap_or(usual.tool_change),
            spindle_start: self.spindle_start.unwrap_or(usual.spindle_start),
            ..usual
        };
        if !self.acceleration.is_empty() {
            // What is asked for is not to be cut by what the controller has as its default.
            machine.path_acceleration = Machine::default().path_acceleration;
        }
        Ok(Milling::new(machine, self.model(dialect)?)?)
    }

    fn model(&self, dialect: Option<Dialect>) -> Outcome<Model> {
        let exact_stop = self.continuous == Some(true);
        let asked = match (self.model, exact_stop, self.step) {
            (Some(model), _, _) => model,
            (None, true, _) => ModelFlag::ExactStop,
            (None, false, Some(_)) => ModelFlag::Steps,
            (None, false, None) => ModelFlag::LookAhead,
        };
        let others = [
            (self.step.is_some() && asked != ModelFlag::Steps, "step belongs to the model steps"),
            (exact_stop && asked != ModelFlag::ExactStop, "continuous is the model exact-stop"),
            (
                self.has_rules() && asked != ModelFlag::LookAhead,
                "a limit of corners, arcs or jerk belongs to look-ahead",
            ),
        ];
        if let Some((_, message)) = others.iter().find(|(wrong, _)| *wrong) {
            return Err(Failure(format!("{message}: leave one of them out")));
        }
        Ok(match asked {
            ModelFlag::LookAhead => Model::LookAhead(self.rules(dialect)?),
            ModelFlag::ExactStop => Model::ExactStop,
            ModelFlag::Steps => Model::Steps { length: self.step.unwrap_or(1.0) },
        })
    }

    fn has_rules(&self) -> bool {
        self.junction_deviation.is_some()
            || !self.classic_jerk.is_empty()
            || self.arc_tolerance.is_some()
            || self.look_ahead.is_some()
            || self.jerk.is_some()
            || self.minimum_cruise_ratio.is_some()
    }

    fn rules(&self, dialect: Option<Dialect>) -> Outcome<Rules> {
        let usual = dialect.map_or_else(Rules::default, Dialect::rules);
        let corner = match (self.junction_deviation, self.classic_jerk.as_slice()) {
            (Some(_), [_, ..]) => {
                let message = "junction-deviation and classic-jerk are both given: leave one of them out";
                return Err(Failure(message.to_owned()));
            }
            (Some(deviation), []) => Corner::Deviation(deviation),
            (None, []) => usual.corner,
            (None, jumps) => Corner::Jump(of_axes("classic-jerk", jumps, [0.0; 3])?),
        };
        let arcs = match self.arc_tolerance {
            None => usual.arcs,
            Some(0.0) => Arcs::Whole,
            Some(tolerance) => Arcs::Tolerance(tolerance),
        };
        let (ahead, jerk) = (self.look_ahead.unwrap_or(usual.ahead), self.jerk.unwrap_or(usual.jerk));
        // a limit of the jerk takes the place of a dialect's ratio
        let usual_ratio = if jerk.is_finite() { 0.0 } else { usual.cruise_ratio };
        let cruise_ratio = self.minimum_cruise_ratio.unwrap_or(usual_ratio);
        Ok(Rules { corner, arcs, ahead, jerk, cruise_ratio, ..usual })
    }

    /// How a program of this place is read.
    pub fn reading(&self, path: &Path, dialect: Dialect) -> Outcome<Reading> {
        let usual = Reading::default();
        let home = match *self.home {
            [] => None,
            [x, y, z] => Some([x, y, z]),
            _ => return Err(Failure(format!("home has {} numbers: give X,Y,Z", self.home.len()))),
        };
        Ok(Reading {
            dialect: Some(dialect),
            unknown: match self.unknown {
                Some(UnknownFlag::Skip) => Unknown::Skip,
                _ => Unknown::Refuse,
            },
            default_feed: self.feed,
            dwell: self.dwell.map(|unit| match unit {
                DwellFlag::Milliseconds => DwellUnit::Milliseconds,
                DwellFlag::Seconds => DwellUnit::Seconds,
            }),
            block_delete: self.block_delete.unwrap_or(false),
            home,
            parameters: self.define.iter().map(|text| parameter(text)).collect::<Outcome<_>>()?,
            folders: path.parent().map(Path::to_path_buf).into_iter().collect(),
            most_repeated: self.most_repeated.unwrap_or(usual.most_repeated),
            ..usual
        })
    }
}

fn parameter(text: &str) -> Outcome<(String, f64)> {
    let wrong = || Failure(format!("`{text}` defines nothing: write NAME=VALUE, as depth=2.5 or 100=3"));
    let (name, value) = text.split_once('=').ok_or_else(wrong)?;
    let name = name.trim().trim_start_matches('#').trim_matches(['<', '>']);
    let value = value.trim().parse().map_err(|_| wrong())?;
    if name.is_empty() { Err(wrong()) } else { Ok((name.to_owned(), value)) }
}

/// One number for all axes, or one an axis.
fn of_axes(name: &str, given: &[f64], usual: [f64; 3]) -> Outcome<[f64; 3]> {
    match *given {
        [] => Ok(usual),
        [all] => Ok([all; 3]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(Failure(format!("{name} has {} numbers: give one for all axes, or three", given.len()))),
    }
}
