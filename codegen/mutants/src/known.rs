//! Points that a search or a proof found where no maker of points goes, kept so that every judge looks there.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use serde::Deserialize;

use super::error::MutateError;
use closedform_project::ReadError;

/// The file of the points, among the records of a project.
const FILE: &str = "POINTS.toml";

/// The points of all kernels.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Known {
    #[serde(default)]
    point: Vec<Point>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Point {
    kernel: String,
    inputs: Vec<f64>,
    /// For people.
    #[serde(rename = "why")]
    _why: String,
}

impl Known {
    /// The points among the records of a project; none where they have no such file.
    ///
    /// # Errors
    ///
    /// When the file cannot be read.
    pub fn load(records: &Path) -> Result<Self, MutateError> {
        let path = records.join(FILE);
        match fs::read_to_string(&path) {
            Ok(text) => toml::from_str(&text).map_err(|cause| MutateError::Known { path, cause: Box::new(cause) }),
            Err(cause) if cause.kind() == ErrorKind::NotFound => Ok(Self::default()),
            Err(cause) => {
                let remedy = "make it readable, or name another folder with --root".to_owned();
                Err(ReadError { path, cause, remedy }.into())
            }
        }
    }

    /// The points of a kernel of so many inputs.
    pub fn of(&self, kernel: &str, inputs: usize) -> impl Iterator<Item = &Vec<f64>> {
        let own = self.point.iter().filter(move |point| point.kernel == kernel && point.inputs.len() == inputs);
        own.map(|point| &point.inputs)
    }
}
