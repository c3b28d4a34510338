//! The corpus of the fuzz target `kernel` and random changes of it.

#[path = "../../fuzz/entries/kernel.rs"]
mod entry;
#[path = "../../fuzz/entries/replay.rs"]
mod replay;

#[test]
fn any_kernel_is_read_or_refused() {
    replay::replay("kernel", |bytes| entry::kernel(&String::from_utf8_lossy(bytes)));
}
