//! Fuzz target: any text is read as a kernel, or refused.
#![no_main]

#[path = "../entries/kernel.rs"]
mod entry;

libfuzzer_sys::fuzz_target!(|text: &str| entry::kernel(text));
