//! What a controller takes, as flags.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use closedform_motion::controller::{Buffer, ExportError, Form, Scaling, save};
use closedform_motion::table::Row;

use crate::error::{Failure, Outcome};

/// The form of what a controller takes.
#[derive(ValueEnum, Debug, Clone, Copy)]
enum FormFlag {
    /// A motion program in PVT mode for a Turbo PMAC or Power PMAC: times in ms, axes X, Y and so on
    Pmac,
    /// JSON with the arrays of a trajectory for ophyd-async's PMAC driver: times in microseconds
    OphydAsync,
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
    /// Number of points that the controller holds
    #[arg(long, value_name = "N")]
    most_points: Option<u64>,
}

impl Export {
    /// Writes the rows, if a file is asked for; how many points.
    pub fn rows<R: Into<Row>>(
        &self,
        axes: &[String],
        rows: impl IntoIterator<Item = R>,
    ) -> Outcome<Option<(&Path, u64)>> {
        let (Some(path), Some(controller)) = (self.export.as_deref(), self.controller) else { return Ok(None) };
        let form = match controller {
            FormFlag::Pmac => Form::Pmac,
            FormFlag::OphydAsync => Form::Arrays,
        };
        let buffer = Buffer { shortest: self.shortest_segment, most: self.most_points };
        let count = save(path, form, axes, &self.scalings(axes.len()), &buffer, rows);
        let failure = |error: ExportError| Failure(error.to_string()).at(path);
        Ok(Some((path, count.map_err(failure)?)))
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
