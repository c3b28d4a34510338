//! The corpus of the fuzz target `contract` and random changes of it.

#[path = "../../../fuzz/entries/contract.rs"]
mod entry;
#[path = "../../../fuzz/entries/replay.rs"]
mod replay;

#[test]
fn any_contract_is_read_or_refused() {
    replay::replay("contract", |bytes| entry::contract(&String::from_utf8_lossy(bytes)));
}
