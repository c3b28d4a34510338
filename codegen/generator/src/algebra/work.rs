//! A limit of work: what may be spent on one formula, counted in terms and not in seconds, so that the same formula has
//! the same form on every machine.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

thread_local! {
    static LEFT: Cell<u64> = const { Cell::new(u64::MAX) };
}

/// More work than was allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooMuchWork;

/// Does what takes no more than `limit`.
///
/// # Errors
/// Where it takes more: all of it is given up.
pub fn limited<T>(limit: u64, task: impl FnOnce() -> T) -> Result<T, TooMuchWork> {
    let before = LEFT.replace(limit);
    // Arithmetic has no results that could say so: the limit unwinds from the depth of a task whose values are all lost.
    let done = catch_unwind(AssertUnwindSafe(task));
    LEFT.set(before);
    done.map_err(|payload| match payload.downcast::<TooMuchWork>() {
        Ok(reached) => *reached,
        Err(fault) => resume_unwind(fault),
    })
}

/// Counts work, before it is done.
pub fn spend(cost: usize) {
    let left = LEFT.get().checked_sub(cost as u64);
    match left {
        Some(left) => LEFT.set(left),
        // no message: this is no fault
        None => resume_unwind(Box::new(TooMuchWork)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_task_ends_where_its_limit_is_reached() {
        let spent = |steps: usize| limited(100, || (0..steps).for_each(|_| spend(10)));
        assert_eq!((spent(10), spent(11)), (Ok(()), Err(TooMuchWork)));
    }

    #[test]
    fn limits_are_of_one_task() {
        let inner = limited(10, || limited(100, || spend(50)));
        assert_eq!(inner, Ok(Ok(())));
        assert_eq!(limited(10, || (limited(5, || spend(6)), spend(10))).map(|both| both.0), Ok(Err(TooMuchWork)));
    }

    #[test]
    #[should_panic(expected = "a fault")]
    fn another_panic_stays_one() {
        let _ = limited(10, || panic!("a fault"));
    }
}
