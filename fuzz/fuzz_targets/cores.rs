//! Fuzz target: any text is read as FPCores, or refused.
#![no_main]

#[path = "../entries/cores.rs"]
mod entry;

libfuzzer_sys::fuzz_target!(|text: &str| entry::cores_of(text));
