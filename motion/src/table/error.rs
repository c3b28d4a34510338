//! Why a table cannot be written or read: where, and what to do.

/// Why a table cannot be written or read. Rows are counted from 1, after the header.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// Times do not grow.
    #[error("row {row}: its time {time} s does not come after {before} s: times must grow from row to row")]
    Order {
        /// Which row.
        row: u64,
        /// Of the row before.
        before: f64,
        /// Of this row.
        time: f64,
    },
    /// A number is not finite.
    #[error("row {row}: {column} is {value}: a controller needs finite numbers")]
    NotFinite {
        /// Which row.
        row: u64,
        /// Its name.
        column: String,
        /// What it is.
        value: f64,
    },
    /// A row has more or fewer axes than the header.
    #[error("row {row} has {found} columns and the header {expected}: give every row all columns")]
    Columns {
        /// Which row.
        row: u64,
        /// In the row.
        found: usize,
        /// In the header.
        expected: usize,
    },
    /// A field is not a number.
    #[error("row {row}: {column} is `{text}`: write a number")]
    Number {
        /// Which row.
        row: u64,
        /// Its name.
        column: String,
        /// What it says.
        text: String,
    },
    /// The header is not that of a PVT table.
    #[error(
        "the header is not that of a PVT table at column {column}, `{found}`: it must be `time [s]` or `duration [s]`, \
         then `NAME position [m]`, `NAME velocity [m/s]` for every axis, with different names"
    )]
    Header {
        /// Counted from 1.
        column: usize,
        /// What it says.
        found: String,
    },
    /// Where the velocity jumps, no cubic can follow.
    #[error(
        "axis {axis} changes its velocity by {jump} m/s at {time} s in no time, which moves the cubic beside it by \
         {distance} m, more than {tolerance} m: no PVT table can say that; allow more, or plan with an acceleration limit"
    )]
    Jump {
        /// Its name.
        axis: String,
        /// When, in s.
        time: f64,
        /// By how much, in m/s.
        jump: f64,
        /// How far the interpolation would be off, in m.
        distance: f64,
        /// How far it may be off, in m.
        tolerance: f64,
    },
    /// The tolerance is no distance, or so small that a table of it would have no end.
    #[error("the tolerance is {tolerance} m: it must be a positive length, and leave no more than 2^20 rows a segment")]
    Tolerance {
        /// In m.
        tolerance: f64,
    },
    /// The name of the file does not say what to write.
    #[error("{path}: a table is a file that ends in .csv or .json")]
    Format {
        /// As given.
        path: String,
    },
    /// Not the JSON of a table.
    #[error("not a table in JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// Not CSV.
    #[error("not a table in CSV: {0}")]
    Csv(#[from] csv::Error),
    /// The file system, which did not take it.
    #[error("{0}: make room, and get the right to write there")]
    Io(#[from] std::io::Error),
}
