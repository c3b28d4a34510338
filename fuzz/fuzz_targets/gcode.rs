//! Fuzz target: any bytes are timed as G-code, or refused.
#![no_main]

#[path = "../entries/gcode.rs"]
mod entry;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| entry::gcode(bytes));
