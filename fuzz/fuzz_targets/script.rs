//! Fuzz target: any bytes are read as the file of a worksheet, or refused.
#![no_main]

#[path = "../entries/script.rs"]
mod entry;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| entry::script(bytes));
