//! The turn to use Symbolica: a lock of the machine, because a second unlicensed process would abort.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use miette::Diagnostic;
use thiserror::Error;

use crate::limit::{LimitError, WAIT};

/// The right to use Symbolica. It ends when all processes that hold the lock file have ended or dropped it, so the process
/// that uses Symbolica shall hold it too.
#[derive(Debug)]
pub struct Turn {
    lock: File,
}

/// For how long to wait.
#[derive(Clone, Copy, Debug)]
pub struct Patience {
    /// Since when.
    start: Instant,
    /// How long.
    seconds: u64,
}

/// Why it is not our turn.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum TurnError {
    /// Another process holds the lock.
    #[error("another closedform command is doing algebra on this machine ({holder}lock {path})")]
    #[diagnostic(help(
        "Symbolica without a licence key runs once a machine: wait until that command has finished, then run this one \
         again, or set {} to more seconds than the {seconds} that this one has waited",
        WAIT.setting()
    ))]
    Busy {
        /// Who holds it, with a comma, if that is known.
        holder: String,
        /// The lock file.
        path: PathBuf,
        /// How long was waited.
        seconds: u64,
    },
    /// The lock file cannot be opened.
    #[error("cannot open the lock file {path}: {cause}")]
    #[diagnostic(help("make the folder writable, or point TMPDIR to one that is"))]
    Lock {
        /// The lock file.
        path: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
    /// How long to wait cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Patience(#[from] LimitError),
}

impl Patience {
    /// What the environment asks for, else what the project says, from now on.
    ///
    /// # Errors
    /// When the environment asks for something else than a number of seconds.
    pub fn of(project: Option<u64>) -> Result<Self, LimitError> {
        Ok(Self { start: Instant::now(), seconds: WAIT.seconds(project)? })
    }

    /// How many seconds it has.
    #[must_use]
    pub fn seconds(&self) -> u64 {
        self.seconds
    }

    /// Waits a moment, if any time is left.
    pub fn wait(&self, moment: Duration) -> bool {
        let left = Duration::from_secs(self.seconds).saturating_sub(self.start.elapsed());
        sleep(moment.min(left));
        !left.is_zero()
    }
}

impl Turn {
    /// Takes the machine's lock, or waits for it; what it waits for it says once.
    ///
    /// # Errors
    /// When another process still holds it in the end, or the lock file cannot be opened.
    pub fn take(patience: &Patience, say: impl FnMut(&str)) -> Result<Self, TurnError> {
        Self::take_at(std::env::temp_dir().join("closedform-symbolica.lock"), patience, say)
    }

    fn take_at(path: PathBuf, patience: &Patience, mut say: impl FnMut(&str)) -> Result<Self, TurnError> {
        let mut lock = open(&path).map_err(|cause| TurnError::Lock { path: path.clone(), cause })?;
        let mut told = patience.seconds == 0;
        loop {
            match lock.try_lock() {
                Ok(()) => break,
                Err(TryLockError::Error(cause)) => return Err(TurnError::Lock { path, cause }),
                Err(TryLockError::WouldBlock) => {
                    let holder = holder(&mut lock);
                    if !told {
                        let (path, seconds) = (path.display(), patience.seconds);
                        say(&format!(
                            "waiting for another closedform command that does algebra ({holder}lock {path}), \
                             {seconds} s at most"
                        ));
                        told = true;
                    }
                    if !patience.wait(Duration::from_millis(50)) {
                        return Err(TurnError::Busy { holder, path, seconds: patience.seconds });
                    }
                }
            }
        }
        // who cannot write it down only leaves it unsaid
        _ = lock.set_len(0).and_then(|()| lock.rewind()).and_then(|()| write!(lock, "{}", std::process::id()));
        Ok(Self { lock })
    }

    /// The lock file, for another process to hold it too.
    ///
    /// # Errors
    /// When the system has no more handles.
    pub fn shared(&self) -> io::Result<File> {
        self.lock.try_clone()
    }
}

impl Drop for Turn {
    /// Nobody shall be told of a process that has ended.
    fn drop(&mut self) {
        _ = self.lock.set_len(0);
    }
}

/// The file is there for all users of the machine, but only one of them may write it.
fn open(path: &Path) -> io::Result<File> {
    let written = OpenOptions::new().create(true).truncate(false).read(true).write(true).open(path);
    written.or_else(|cause| if cause.kind() == ErrorKind::PermissionDenied { File::open(path) } else { Err(cause) })
}

/// The process that wrote itself down, with a comma.
fn holder(lock: &mut File) -> String {
    let mut text = String::new();
    let read = lock.rewind().and_then(|()| lock.take(16).read_to_string(&mut text));
    let process: Option<u32> = read.ok().and_then(|_| text.trim().parse().ok());
    process.map(|process| format!("process {process}, ")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_ends_when_its_last_holder_lets_go() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lock");
        let patience = |seconds| Patience { start: Instant::now(), seconds };
        let mut said = Vec::new();
        let mut take = |seconds| Turn::take_at(path.clone(), &patience(seconds), |text| said.push(text.to_owned()));
        let turn = take(0).unwrap();
        let shared = turn.shared().unwrap();
        let busy = take(1).unwrap_err().to_string();
        drop(turn);
        assert!(take(0).is_err(), "the other holder has it still");
        drop(shared);
        drop(take(0).unwrap());
        let own = format!("process {}, lock {}", std::process::id(), path.display());
        assert!(busy.contains(&own), "{busy}");
        assert_eq!(said.len(), 1);
        assert!(said[0].contains(&own) && said[0].contains("1 s at most"), "{said:?}");
    }
}
