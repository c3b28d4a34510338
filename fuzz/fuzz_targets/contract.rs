//! Fuzz target: any text is read as a contract, or refused.
#![no_main]

#[path = "../entries/contract.rs"]
mod entry;

libfuzzer_sys::fuzz_target!(|text: &str| entry::contract(text));
