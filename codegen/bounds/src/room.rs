//! Room on the stack: expressions and steps are walked by recursion, in threads whose stack may be small.

use std::panic::resume_unwind;
use std::thread::{Builder, scope};

/// What the highest kernel asks for, with much to spare; memory is taken as it is used.
const STACK: usize = 1 << 28;

/// Does some work where there is room for it; in this thread where no other one can be had.
pub fn with_room<T: Send>(work: impl Fn() -> T + Sync) -> T {
    scope(|scope| match Builder::new().stack_size(STACK).spawn_scoped(scope, &work) {
        Ok(thread) => thread.join().unwrap_or_else(|panic| resume_unwind(panic)),
        Err(_) => work(),
    })
}
