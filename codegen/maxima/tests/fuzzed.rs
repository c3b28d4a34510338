//! The corpus of the fuzz target `worksheet` and random changes of it.

#[path = "../../../fuzz/entries/worksheet.rs"]
mod entry;
#[path = "../../../fuzz/entries/replay.rs"]
mod replay;

#[test]
fn any_worksheet_is_read_or_refused() {
    replay::replay("worksheet", |bytes| entry::worksheet(&String::from_utf8_lossy(bytes)));
}
