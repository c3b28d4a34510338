//! Why a plan does not become a program or arrays.

/// Why a plan does not become what a controller takes.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// Scalings that are not those of the axes.
    #[error("there are {found} numbers of counts for {axes} axes: give one for all, or one an axis, none of them 0")]
    Scalings {
        /// How many there are.
        found: usize,
        /// How many axes.
        axes: usize,
    },
    /// More axes than letters.
    #[error("a coordinate system of the controller has {most} axes, and the plan {axes}: divide it")]
    Axes {
        /// How many there are.
        axes: usize,
        /// How many there may be.
        most: usize,
    },
    /// A segment too short.
    #[error(
        "segment {segment} takes {time:?} s, and the controller needs {shortest:?} s: plan with a tick or a shortest time of that"
    )]
    Short {
        /// Counted from 1.
        segment: u64,
        /// In s.
        time: f64,
        /// In s.
        shortest: f64,
    },
    /// Segments that can be neither so short nor so long.
    #[error(
        "the longest segment is {longest:?} s, and must be {least:?} s at least, so that what is divided is not too short"
    )]
    Longest {
        /// In s.
        longest: f64,
        /// In s.
        least: f64,
    },
    /// Too many points.
    #[error(
        "the profile has more points than the {most} that the controller holds: plan fewer lines, or a larger tolerance"
    )]
    Many {
        /// How many it holds.
        most: u64,
    },
    /// Two axes of one name.
    #[error("two axes are called {name} in a program: give them other names")]
    Names {
        /// What both become.
        name: String,
    },
    /// A number that is none.
    #[error("row {row} has a number that is not finite")]
    NotFinite {
        /// Counted from 1.
        row: u64,
    },
    /// The file system, which did not take it.
    #[error("{0}: make room, and get the right to write there")]
    Io(#[from] std::io::Error),
}
