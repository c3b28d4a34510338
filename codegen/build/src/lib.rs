//! Freshness: generated files are as they were generated, of inputs as they are now, by this version.
//!
//! A build script asks for that in one line, without Maxima and without Symbolica:
//!
//! ```no_run
//! closedform_build::check("../maxima-ref");
//! ```

#![forbid(unsafe_code)]

mod fresh;
mod stamp;

pub use fresh::{Cause, MARK, Origin, Stale, WORKSHEETS, inputs, is_marked, remedy, stale, worksheet, worksheet_of};
pub use stamp::{Stamp, VERSION, hash, stamped};

use std::path::Path;

/// For `build.rs`: ends the build, and says what to run, unless everything below `src/generated/` of the crate at hand is
/// fresh. `worksheets` is the folder of the worksheets, from the crate's own one.
pub fn check(worksheets: impl AsRef<Path>) {
    let (generated, worksheets) = (Path::new("src/generated"), worksheets.as_ref());
    for folder in [generated, worksheets] {
        println!("cargo::rerun-if-changed={}", folder.display());
    }
    match stale(generated, worksheets) {
        Ok(stale) if stale.is_empty() => {}
        Ok(stale) => {
            stale.iter().for_each(|stale| println!("cargo::error={stale}"));
            println!("cargo::error=run `{}`, read the difference and commit it", remedy(&stale));
        }
        Err(cause) => {
            println!("cargo::error=cannot read {} and {}: {cause}", generated.display(), worksheets.display())
        }
    }
}
