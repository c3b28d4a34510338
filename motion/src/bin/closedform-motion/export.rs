//! What a controller takes, as flags.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use closedform_motion::Motion;
use closedform_motion::controller::{
    Buffer, ExportError, Form, Language, Scaling, save, save_constants, save_scan_spec,
};
use closedform_motion::plan::raster_scan::RasterPlan;
use closedform_motion::table::Row;
use indicatif::ProgressBar;

use crate::error::{Failure, Outcome};

/// The form of what a controller takes.
#[derive(ValueEnum, Debug, Clone, Copy)]
enum FormFlag {
    /// A motion program in PVT mode for a Turbo PMAC or Power PMAC: times in ms, axes X, Y and so on
    Pmac,
    /// JSON with the arrays of a trajectory for ophyd-async's PMAC driver: times in microseconds
    OphydAsync,
    /// A program in ACSPL+ for SPiiPlus controllers: PVSPLINE with times in ms, axes 0, 1 and so on
    Acs,
    /// JSON with the process variables of an EPICS profile move: positions and times in s; use --longest-segment
    Epics,
    /// JSON of a scanspec of a raster: where its --pixels are, and how long each takes
    Scanspec,
    /// The segments as Rust statics for closedform-player
    Rust,
    /// The segments as a C header
    C,
}

/// So many segments are kept in memory for constants; no controller has room for more.
const MOST_CONSTANTS: u64 = 1 << 20;

/// What a form is made of.
enum Source {
    Rows(Form),
    Segments(Language),
    Pixels,
}

impl FormFlag {
    fn source(self) -> Source {
        match self {
            Self::Pmac => Source::Rows(Form::Pmac),
            Self::OphydAsync => Source::Rows(Form::Arrays),
            Self::Acs => Source::Rows(Form::Acs),
            Self::Epics => Source::Rows(Form::Epics),
            Self::Scanspec => Source::Pixels,
            Self::Rust => Source::Segments(Language::Rust),
            Self::C => Source::Segments(Language::C),
        }
    }
}

/// Whether, where and how a controller's form is written.
#[derive(Args, Debug, Clone)]
pub struct Export {
    /// Write what a controller takes there, in the form of --controller
    #[arg(long, value_name = "FILE", requires = "controller")]
    pub export: Option<PathBuf>,
    /// The controller of --export
    #[arg(long)]
    controller: Option<FormFlag>,
    /// Counts of the controller a metre: one for all axes, or one an axis; negative where an axis runs the other way
    #[arg(long, value_name = "N,..", value_delimiter = ',', allow_hyphen_values = true, default_value = "1")]
    counts: Vec<f64>,
    /// What the controller says at position 0, in counts: one for all axes, or one an axis
    #[arg(long, value_name = "N,..", value_delimiter = ',', allow_hyphen_values = true, default_value = "0")]
    offset: Vec<f64>,
    /// Shortest segment that the controller takes, in s
    #[arg(long, value_name = "S", default_value_t = 0.0)]
    shortest_segment: f64,
    /// Longest segment, in s: longer ones are divided [default: what the form can say]
    #[arg(long, value_name = "S")]
    longest_segment: Option<f64>,
    /// Number of points, or of segments, that the controller holds
    #[arg(long, value_name = "N")]
    most_points: Option<u64>,
}

impl Export {
    /// Whether the numbers of the buffer can be.
    pub fn check(&self) -> Outcome<()> {
        let longest = ("longest-segment", self.longest_segment.unwrap_or(1.0), "positive");
        let shortest = ("shortest-segment", self.shortest_segment, "0 or positive");
        for (name, value, range) in [longest, shortest] {
            let is_fit = value.is_finite() && (value > 0.0 || range != "positive" && value == 0.0);
            if !is_fit {
                return Err(Failure(format!("{name} is {value:?}: give a time in s that is {range}")));
            }
        }
        Ok(())
    }

    /// Writes a form that is made of rows, or of the segments of the whole motion, if a file is asked for; how many.
    pub fn rows<R: Into<Row>>(
        &self,
        axes: &[String],
        (count, rows): (u64, impl IntoIterator<Item = R>),
        motion: impl FnOnce() -> Outcome<Motion>,
        bar: &ProgressBar,
    ) -> Outcome<Option<(&Path, u64)>> {
        let (Some(path), Some(controller)) = (self.export.as_deref(), self.controller) else { return Ok(None) };
        let scalings = self.scalings(axes.len());
        let written = match controller.source() {
            Source::Rows(form) => {
                let shortest = self.shortest_segment;
                let buffer = Buffer { shortest, longest: self.longest_segment, most: self.most_points };
                save(path, form, axes, &scalings, &buffer, bar.wrap_iter(rows.into_iter()))
            }
            Source::Segments(_) if count > MOST_CONSTANTS => Err(ExportError::Many { most: MOST_CONSTANTS }),
            Source::Segments(language) => save_constants(path, language, &scalings, self.most_points, &motion()?),
            Source::Pixels => {
                let message =
                    "a scanspec has the pixels of a raster: plan a raster-scan with --pixels, of the fastest shape";
                return Err(Failure(message.to_owned()).at(path));
            }
        };
        bar.finish_and_clear();
        Ok(Some((path, written.map_err(|error| failed(error, path))?)))
    }

    /// Writes the pixels of a raster, if the form is made of them; how many.
    pub fn pixels(&self, plan: &RasterPlan, pixels: Option<u64>) -> Outcome<Option<(&Path, u64)>> {
        let (Some(path), Some(FormFlag::Scanspec), Some(pixels)) = (self.export.as_deref(), self.controller, pixels)
        else {
            return Ok(None);
        };
        let names = RasterPlan::AXES.map(str::to_owned);
        let count = save_scan_spec(path, &names, &self.scalings(2), plan, pixels);
        Ok(Some((path, count.map_err(|error| failed(error, path))?)))
    }

    /// One an axis, as far as there are so many numbers.
    fn scalings(&self, axes: usize) -> Vec<Scaling> {
        let count = self.counts.len().max(self.offset.len());
        let of = |list: &[f64], axis: usize| if list.len() == 1 { list.first() } else { list.get(axis) }.copied();
        // a number that is missing fits no axis, and is told
        let scaling = |axis| Scaling {
            counts: of(&self.counts, axis).unwrap_or(f64::NAN),
            offset: of(&self.offset, axis).unwrap_or(f64::NAN),
        };
        (0..if count == 1 { axes } else { count }).map(scaling).collect()
    }
}

fn failed(error: ExportError, path: &Path) -> Failure {
    Failure(error.to_string()).at(path)
}
