//! The corpora of the fuzz targets `contract`, `script` and `cores`, and random changes of them.

#[path = "../../../fuzz/entries/contract.rs"]
mod contract;
#[path = "../../../fuzz/entries/cores.rs"]
mod cores;
#[path = "../../../fuzz/entries/replay.rs"]
mod replay;
#[path = "../../../fuzz/entries/script.rs"]
mod script;

#[test]
fn any_contract_is_read_or_refused() {
    replay::replay("contract", |bytes| contract::contract(&String::from_utf8_lossy(bytes)));
}

#[test]
fn any_file_of_a_worksheet_is_read_or_refused() {
    replay::replay("script", script::script);
}

#[test]
fn any_cores_are_read_or_refused() {
    replay::replay("cores", |bytes| cores::cores_of(&String::from_utf8_lossy(bytes)));
}
