//! The turn to use Symbolica: a lock of the machine, because a second unlicensed process would abort.

use std::fs::{File, OpenOptions, TryLockError};
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, Instant};
use thiserror::Error;

/// The environment variable that says for how many seconds to wait for the lock; without it, not at all.
pub const WAIT: &str = "CLOSEDFORM_WAIT";

/// The right to use Symbolica, until it is dropped.
pub struct Turn {
    _lock: File,
}

/// Why it is not our turn.
#[derive(Debug, Error)]
pub enum TurnError {
    /// Another process holds the lock.
    #[error(
        "another closedform command is doing algebra on this machine (lock {0})\n\
         Symbolica without a licence key runs once a machine: wait until that command has finished, then run this one \
         again, or set {WAIT} to the seconds that this one may wait"
    )]
    Busy(PathBuf),
    /// The lock file cannot be opened.
    #[error("cannot open the lock file {path}: {cause}\nmake the folder writable or point TMPDIR to one that is")]
    Lock {
        /// The lock file.
        path: PathBuf,
        /// What the system said.
        cause: std::io::Error,
    },
}

impl Turn {
    /// Takes the machine's lock, after a wait if [`WAIT`] allows one.
    ///
    /// # Errors
    /// When another process holds it, or the lock file cannot be opened.
    pub fn take() -> Result<Self, TurnError> {
        let path = std::env::temp_dir().join("closedform-symbolica.lock");
        let open = OpenOptions::new().create(true).truncate(false).write(true).open(&path);
        let lock = open.map_err(|cause| TurnError::Lock { path: path.clone(), cause })?;
        let end = Instant::now() + patience();
        loop {
            match lock.try_lock() {
                Ok(()) => return Ok(Self { _lock: lock }),
                Err(TryLockError::WouldBlock) if Instant::now() < end => sleep(Duration::from_millis(50)),
                Err(TryLockError::WouldBlock) => return Err(TurnError::Busy(path)),
                Err(TryLockError::Error(cause)) => return Err(TurnError::Lock { path, cause }),
            }
        }
    }
}

fn patience() -> Duration {
    let seconds = std::env::var(WAIT).ok().and_then(|text| text.parse().ok());
    Duration::from_secs(seconds.unwrap_or(0))
}
