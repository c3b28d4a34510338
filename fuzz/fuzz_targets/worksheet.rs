//! Fuzz target: any text is read as a worksheet, or refused.
#![no_main]

#[path = "../entries/worksheet.rs"]
mod entry;

libfuzzer_sys::fuzz_target!(|text: &str| entry::worksheet(text));
