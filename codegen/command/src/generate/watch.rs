//! `closedform generate --watch`: again at every change of a worksheet or contract, until Ctrl-C.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use closedform_system::output;
use miette::IntoDiagnostic;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag::register_conditional_shutdown;

/// How often the folder is looked at; a change is taken when it has rested so long.
const PAUSE: Duration = Duration::from_millis(300);

/// When each worksheet and contract was written, and how long it is.
type State = BTreeMap<PathBuf, (SystemTime, u64)>;

/// Acts now and after every change of the folder's worksheets and contracts; what goes wrong is said, and watching goes on.
///
/// # Errors
///
/// When Ctrl-C cannot be waited for.
pub fn run(folder: &Path, act: impl Fn() -> miette::Result<()>) -> miette::Result<()> {
    // every file is written in one step, so that there is nothing to undo
    for signal in [SIGINT, SIGTERM] {
        register_conditional_shutdown(signal, 0, Arc::new(true.into())).into_diagnostic()?;
    }
    loop {
        // what changes while it acts is a change too
        let seen = state(folder);
        if let Err(report) = act() {
            output::warn(&format!("{report:?}"));
        }
        output::note(&format!("watching {}; Ctrl-C ends it", folder.display()));
        wait(folder, &seen);
    }
}

/// Waits until the folder is another one, and rests.
fn wait(folder: &Path, seen: &State) {
    let mut last = state(folder);
    loop {
        sleep(PAUSE);
        let now = state(folder);
        if now == last && now != *seen {
            return;
        }
        last = now;
    }
}

fn state(folder: &Path) -> State {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let written_by_people = |path: &PathBuf| path.extension().is_some_and(|end| end == "mac" || end == "toml");
    let paths = entries.map(|entry| entry.path()).filter(written_by_people);
    let known = paths.filter_map(|path| {
        let about = fs::metadata(&path).ok()?;
        Some((path, (about.modified().ok()?, about.len())))
    });
    known.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_people_write_is_watched() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str| fs::write(folder.path().join(name), name).unwrap();
        write("a.mac");
        let before = state(folder.path());
        write("a.ref");
        assert_eq!(state(folder.path()), before);
        write("a.toml");
        assert_ne!(state(folder.path()), before);
        assert!(state(&folder.path().join("nowhere")).is_empty());
    }
}
