//! The same work for many items, on all processors.

use std::num::NonZero;
use std::sync::Mutex;
use std::thread;

/// What `work` makes of every item, in their order.
pub fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let queue = Mutex::new(items.iter().enumerate());
    let done = Mutex::new(Vec::new());
    let next = || queue.lock().expect("no worker panics with the queue").next();
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(|| {
                while let Some((position, item)) = next() {
                    let result = work(item);
                    done.lock().expect("no worker panics with the results").push((position, result));
                }
            });
        }
    });
    let mut done = done.into_inner().expect("no worker panics with the results");
    done.sort_by_key(|(position, _)| *position);
    done.into_iter().map(|(_, result)| result).collect()
}
