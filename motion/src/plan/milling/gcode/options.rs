//! What may be chosen when a G-code file is read.

use std::path::PathBuf;

use super::dialect::Dialect;

/// What becomes of a line that is not understood.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unknown {
    /// The file is refused.
    #[default]
    Refuse,
    /// The line is passed over and reported.
    Skip,
}

/// The unit of P in a dwell (G4 P).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DwellUnit {
    /// LinuxCNC, grbl, Mach.
    Seconds,
    /// Fanuc, Marlin, Klipper. Their S and X are seconds, and are read so.
    Milliseconds,
}

/// How a G-code file is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// Which controller it is for; guessed from its begin where none is given.
    pub dialect: Option<Dialect>,
    /// What becomes of a line that is not understood.
    pub unknown: Unknown,
    /// The feed before the first F, in mm/s; without it, a cut before the first F is an error.
    pub default_feed: Option<f64>,
    /// Unit of P in a dwell; that of the dialect where none is given.
    pub dwell: Option<DwellUnit>,
    /// Whether lines that begin with `/` are left out, as with the switch "block delete" of a controller.
    pub block_delete: bool,
    /// Where the tool is at the begin, in mm.
    pub start: [f64; 3],
    /// Where G28 and G30 go, in mm of the machine; the start where none is given, which is told.
    pub home: Option<[f64; 3]>,
    /// Parameters that are set before the program begins: `100` is `#100`, a name is `#<name>`.
    pub parameters: Vec<(String, f64)>,
    /// Where sub-programs in files of their own are looked for.
    pub folders: Vec<PathBuf>,
    /// The most lines that loops, sub-programs and jumps may repeat: more is a loop without end.
    pub most_repeated: u64,
}

/// Lines that loops, sub-programs and jumps may repeat, where nothing else is asked for.
pub(super) const MOST_REPEATED: u64 = 20_000_000;

impl Default for Reading {
    fn default() -> Self {
        Self {
            dialect: None,
            unknown: Unknown::Refuse,
            default_feed: None,
            dwell: None,
            block_delete: false,
            start: [0.0; 3],
            home: None,
            parameters: Vec::new(),
            folders: Vec::new(),
            most_repeated: MOST_REPEATED,
        }
    }
}
