//! Why there is no picture.

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// There is nothing to see.
    #[error("there is nothing to draw: {what}")]
    Empty {
        /// What is missing.
        what: &'static str,
    },
    /// The name of the file does not say what to write.
    #[error("{path}: a picture is a file that ends in .svg, .png or .html")]
    Format {
        /// As given.
        path: String,
    },
    /// The plotting library fails.
    #[error("the picture cannot be drawn: {why}")]
    Draw {
        /// What is the matter with it.
        why: String,
    },
    /// It is too large for a PNG.
    #[error("the picture cannot become a PNG: {why}: write .svg")]
    Png {
        /// What is the matter with it.
        why: String,
    },
    /// The file system, which did not take it.
    #[error("{0}: make room, and get the right to write there")]
    Io(#[from] std::io::Error),
}

impl PlotError {
    /// Of the plotting library.
    pub(super) fn draw(error: impl std::fmt::Display) -> Self {
        Self::Draw { why: error.to_string() }
    }
}
