//! What the generator hands back, and the words in which it does: a line each on its standard output, between the lines
//! that Symbolica prints there.

use closedform_build::{VERSION, hash, stamped};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Everything that was generated, in memory.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Generated {
    /// File names below the generated folder, and their texts.
    pub files: BTreeMap<String, String>,
    /// What was made, in order.
    pub kernels: Vec<Made>,
    /// What could not be made, where that must not stop the others.
    pub refused: Vec<Refused>,
}

/// A kernel that could not be made, or was not proved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refused {
    /// `family::name`
    pub kernel: String,
    /// Where its formula stands and why there is no kernel of it, in words.
    pub because: String,
}

impl Generated {
    /// Stamps every file with the version and what it was made from: a worksheet, its contract, its reference
    /// expressions.
    ///
    /// # Errors
    /// When one of those cannot be read.
    pub fn stamp(&mut self, worksheets: &Path) -> io::Result<()> {
        for text in self.files.values_mut() {
            let origin = text.lines().next().and_then(closedform_build::worksheet_of);
            let inputs = origin.map(|origin| closedform_build::inputs(worksheets, &origin)).unwrap_or_default();
            let inputs = inputs.iter().map(fs::read).collect::<io::Result<Vec<_>>>()?;
            *text = stamped(text, VERSION, hash(inputs.iter().map(Vec::as_slice)));
        }
        Ok(())
    }
}

/// One kernel as made.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Made {
    /// `family::name`
    pub kernel: String,
    /// The rules of its program.
    pub rules: Vec<String>,
    /// Additions, multiplications, divisions, roots, operations on pairs.
    pub operations: [usize; 5],
    /// The largest bound of its results, in ulp.
    pub bound: f64,
    /// Why the formula stands as it is written and certifies every call, if it does.
    pub certified_because: Option<String>,
    /// The conditions that its formulas need and its contract does not promise, if it has one.
    pub added: Vec<String>,
}

/// How many formulas are left when others are refused, in words.
#[must_use]
pub fn would_be_fine(kernels: usize) -> String {
    match kernels {
        0 => "no other kernel can be made".to_owned(),
        1 => "1 other kernel would be fine".to_owned(),
        _ => format!("{kernels} other kernels would be fine"),
    }
}

/// What the generator works at.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Begun {
    /// A kernel, or a family.
    pub what: String,
    /// Where its formula stands, `path:line:column`, or the path of its worksheet.
    pub place: String,
}

/// Begins a line of ours.
const MARK: &str = "\u{1}closedform ";

/// One line.
#[derive(Debug, Serialize, Deserialize)]
pub enum Word {
    /// So many kernels will be made.
    Kernels(usize),
    /// This is made or proved from now on.
    Begun(Begun),
    /// All is done.
    Made(Generated),
}

impl Word {
    /// That this is begun.
    #[must_use]
    pub fn begun(what: &str, place: &str) -> Self {
        Self::Begun(Begun { what: what.to_owned(), place: place.to_owned() })
    }

    /// Says it on standard output.
    ///
    /// # Errors
    /// When nobody listens.
    pub fn send(&self) -> io::Result<()> {
        let text = serde_json::to_string(self).map_err(io::Error::from)?;
        let mut output = io::stdout().lock();
        // whatever stands before it may lack its end
        writeln!(output, "\n{MARK}{text}")?;
        output.flush()
    }

    /// The word in a line, if it is one of ours.
    #[must_use]
    pub fn read(line: &str) -> Option<Self> {
        serde_json::from_str(line.strip_prefix(MARK)?).ok()
    }
}
