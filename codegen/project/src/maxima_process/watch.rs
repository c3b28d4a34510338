//! The watch over a run: how far it is, what it has used, and that it ends with the command that started it.

use std::cell::Cell;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use std::os::unix::process::CommandExt;

use closedform_system::output::is_quiet;
use indicatif::{ProgressBar, ProgressStyle};

use super::Maxima;
use super::error::Used;
use closedform_system::processor::time_of_group;

/// How often to look.
pub(super) const GLANCE: Duration = Duration::from_millis(100);

/// One run of Maxima, seen from outside.
pub(super) struct Watch<'a> {
    maxima: &'a Maxima,
    /// Maxima's process group.
    group: u32,
    start: Instant,
    bar: ProgressBar,
    /// How many statements have begun, the call of the worksheet itself being the first.
    begun: Cell<u64>,
    guard: Option<Child>,
}

impl<'a> Watch<'a> {
    /// Of a run of so many statements.
    pub(super) fn new(maxima: &'a Maxima, child: &Child, statements: usize) -> Self {
        let style = ProgressStyle::with_template("Maxima: statement {pos} of {len}, {elapsed}");
        let bar = if is_quiet() { ProgressBar::hidden() } else { ProgressBar::new(statements as u64) };
        let bar = style.map_or_else(|_| bar.clone(), |style| bar.clone().with_style(style));
        Self { maxima, group: child.id(), start: Instant::now(), bar, begun: Cell::new(0), guard: guard(child.id()) }
    }

    /// A statement begins.
    pub(super) fn statement(&self) {
        let worksheet = self.begun.replace(self.begun.get() + 1);
        self.bar.set_position(worksheet.min(self.bar.length().unwrap_or(worksheet)));
    }

    /// What the run has used, once that is too much.
    pub(super) fn exhausted(&self) -> Option<Used> {
        self.bar.tick();
        let (limit, elapsed) = (self.maxima.limit, self.start.elapsed());
        match time_of_group(self.group) {
            Some(processor) if processor >= limit => Some(Used::Processor { limit }),
            Some(processor) => (elapsed >= self.maxima.patience()).then_some(Used::Waiting { elapsed, processor }),
            None => (elapsed >= limit).then_some(Used::Elapsed { limit }),
        }
    }
}

impl Drop for Watch<'_> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        if let Some(guard) = &mut self.guard {
            // an error means that it has ended with the group
            _ = guard.kill();
            _ = guard.wait();
        }
    }
}

/// A member of Maxima's process group that waits for the end of this process and ends the group then: a group of its own is
/// not reached by an interrupt at the terminal, and who is killed cannot stop anybody. Without a shell there is none.
fn guard(group: u32) -> Option<Child> {
    let mut shell = Command::new("sh");
    shell.args(["-c", "read -r never; kill -9 0"]).process_group(i32::try_from(group).ok()?);
    shell.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().ok()
}
