//! Standard input and output in the place of files.

use std::path::Path;

/// The name that stands for standard input where a file is read, and for standard output where one is written.
const STANDARD: &str = "-";

/// Whether a path is that name.
pub fn is_standard(path: &Path) -> bool {
    path == Path::new(STANDARD)
}
