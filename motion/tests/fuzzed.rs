//! The corpus of the fuzz target `gcode` and random changes of it.

#[path = "../../fuzz/entries/gcode.rs"]
mod entry;
#[path = "../../fuzz/entries/replay.rs"]
mod replay;

#[test]
fn any_program_is_timed_or_refused() {
    replay::replay("gcode", entry::gcode);
}
