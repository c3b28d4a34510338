//! The turn to use Symbolica: a lock of the machine, because a second unlicensed process would abort.

use std::fs::{File, OpenOptions, TryLockError};
use std::path::PathBuf;
use thiserror::Error;

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
         Symbolica without a licence key runs once a machine: wait until that command has finished, then run this one again"
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
    /// Takes the machine's lock.
    ///
    /// # Errors
    /// When another process holds it, or the lock file cannot be opened.
    pub fn take() -> Result<Self, TurnError> {
        let path = std::env::temp_dir().join("closedform-symbolica.lock");
        let open = OpenOptions::new().create(true).truncate(false).write(true).open(&path);
        let lock = open.map_err(|cause| TurnError::Lock { path: path.clone(), cause })?;
        match lock.try_lock() {
            Ok(()) => Ok(Self { _lock: lock }),
            Err(TryLockError::WouldBlock) => Err(TurnError::Busy(path)),
            Err(TryLockError::Error(cause)) => Err(TurnError::Lock { path, cause }),
        }
    }
}
