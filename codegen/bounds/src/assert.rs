//! The test of a source file: every bound that its kernels state is proved.

use crate::check::{Derived, check, derive};
use crate::keys::Keys;
use crate::place::{Place, place};
use crate::refusal::Refusal;
use crate::room::with_room;
use closedform_syntax::{Kernel, certified, sources};
use std::path::Path;

/// Proves every bound that the kernels of a source file state, in a test; the path begins at the crate's `Cargo.toml`.
///
/// ```no_run
/// closedform_bounds::assert_bounded!("src/lib.rs");
/// ```
///
/// It panics with file, line and remedy of every bound that is not proved, and of every certificate that is not right.
/// Of kernels that state no bound it prints what they could state, or why they have none: `cargo test -- --nocapture`
/// shows that.
#[macro_export]
macro_rules! assert_bounded {
    ($file:expr $(,)?) => {
        $crate::assert_file_bounded(::core::env!("CARGO_MANIFEST_DIR"), $file)
    };
}

/// What [`assert_bounded!`](crate::assert_bounded) calls.
///
/// # Panics
///
/// When the file cannot be read, holds no kernel, or a bound in it is not proved.
#[track_caller]
pub fn assert_file_bounded(folder: &str, file: &str) {
    let path = Path::new(folder).join(file);
    let text = match std::fs::read_to_string(&path) {
        Ok(text) => text,
        Err(cause) => panic!("cannot read {}: {cause}; name a source file of this crate", path.display()),
    };
    let found = with_room(|| Found::of(file, &text));
    found.notes.iter().for_each(|note| eprintln!("{note}"));
    assert!(found.complaints.is_empty(), "\n{}", found.complaints.join("\n\n"));
}

/// What is to be said of a source file.
#[derive(Default)]
struct Found {
    complaints: Vec<String>,
    notes: Vec<String>,
}

impl Found {
    fn of(file: &str, text: &str) -> Self {
        let mut found = Self::default();
        let sources = match sources(text) {
            Ok(sources) => sources,
            Err(error) => return found.unreadable(file, text, error),
        };
        if sources.is_empty() {
            found
                .complaints
                .push(format!("{file}: there is no `#[kernel]` function in it; name the file that has them"));
        }
        for source in sources {
            match source.and_then(closedform_syntax::Source::parse) {
                Ok(kernel) => found.kernel(file, text, &kernel),
                Err(error) => found = found.unreadable(file, text, error),
            }
        }
        found
    }

    fn unreadable(mut self, file: &str, text: &str, errors: syn::Error) -> Self {
        for error in errors {
            let place = Place::between(error.span(), error.span());
            self.complaints.push(place.shown(file, text, &error.to_string()));
        }
        self
    }

    fn kernel(&mut self, file: &str, text: &str, kernel: &Kernel) {
        let complaint = |refusal: &Refusal| place(kernel, refusal).shown(file, text, &refusal.to_string());
        if kernel.meta.bound_place.is_none() && kernel.meta.certificate.is_none() {
            match derive(kernel) {
                Ok(bounds) => {
                    let keys = keys(kernel, &bounds);
                    self.notes.push(format!("{file}: kernel `{}` can state `{keys}`", kernel.name));
                }
                Err(refusals) => self.notes.extend(refusals.iter().map(complaint)),
            }
            return;
        }
        match check(kernel) {
            Err(refusals) => self.complaints.extend(refusals.iter().map(complaint)),
            Ok(bounds) => {
                if let Err(error) = certified(kernel) {
                    let place = Place::between(error.span(), error.span());
                    let bounds: Vec<f64> = bounds.iter().map(|bound| bound.stated).collect();
                    let keys = Keys::of(kernel, &bounds);
                    self.complaints.push(place.shown(file, text, &format!("{error}; proved is `{keys}`")));
                }
            }
        }
    }
}

fn keys(kernel: &Kernel, bounds: &[Derived]) -> Keys {
    Keys::of(kernel, &bounds.iter().map(|bound| bound.ulp).collect::<Vec<_>>())
}
