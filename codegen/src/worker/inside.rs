//! What the worker does in its own process: it generates, says how far it is, and ends with the command.

use super::words::{Word, send};
use super::{Source, WorkerError};
use crate::pipeline::{Generated, generate, unproved};
use crate::worksheet::derive::{Options, rederive};
use crate::worksheet::family::{Family, families};
use rustix::process::{Signal, getpid, kill_process};
use std::os::unix::process::parent_id;
use std::path::Path;
use std::time::Duration;
use std::{fs, thread};

/// Generates, and sends the result.
///
/// # Errors
/// When a family is wrong, or a kernel cannot be made or proved.
pub fn work(source: &Source, parent: u32) -> Result<(), WorkerError> {
    thread::spawn(move || end_with(parent));
    let generated = match source {
        Source::Folder(folder) => generated(&families(folder)?)?,
        Source::Worksheet(worksheet) => generated(&[Family::from_worksheet(worksheet)?])?,
        Source::Rederived { folder, kernels, .. } => {
            rederived(folder, kernels)?;
            Generated::default()
        }
    };
    Ok(send(&Word::Made(generated))?)
}

/// A command that was killed has nobody to stop its worker, which would keep others waiting.
fn end_with(parent: u32) {
    while parent_id() == parent {
        thread::sleep(Duration::from_millis(100));
    }
    _ = kill_process(getpid(), Signal::KILL);
}

fn generated(families: &[Family]) -> Result<Generated, WorkerError> {
    send(&Word::Kernels(families.iter().map(|family| family.contract.kernels.len()).sum()))?;
    generate(families, making).map_err(WorkerError::Pipeline)
}

/// Proves the kernels as checked in equal to what the worksheets derive now.
fn rederived(folder: &Path, kernels: &Path) -> Result<(), WorkerError> {
    let mut families = families(folder)?;
    for family in &mut families {
        making(&family.name);
        family.references = rederive(folder, &family.name, &Options::default())?;
    }
    let mut causes = Vec::new();
    for family in &families {
        making(&family.name);
        let text = fs::read_to_string(kernels.join(format!("{}.rs", family.name)))?;
        causes.extend(unproved(family, &text));
    }
    if causes.is_empty() { Ok(()) } else { Err(WorkerError::Changed(causes)) }
}

/// If nobody listens, the worker ends anyway.
fn making(what: &str) {
    _ = send(&Word::Making(what.to_owned()));
}
