//! The pictures of the README are what the command draws today.
#![cfg(feature = "command")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

/// No picture in the README is larger.
const MOST_BYTES: usize = 60_000;

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let read = |entry: fs::DirEntry| {
        (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).expect("a picture"))
    };
    entries.map(read).collect()
}

#[test]
fn the_pictures_are_up_to_date() {
    let fresh = tempfile::tempdir().expect("a folder");
    let status = Command::new(env!("CARGO_BIN_EXE_closedform-motion")).arg("gallery").arg(fresh.path()).status();
    assert!(status.expect("runs").success());
    let (drawn, kept) = (files(fresh.path()), files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures")));
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    let remedy = "run `cargo run -p closedform-motion -- gallery motion/pictures`";
    assert_eq!(names(&drawn), names(&kept), "{remedy}");
    for (name, picture) in &drawn {
        assert!(picture.len() < MOST_BYTES, "{name} has {} bytes", picture.len());
        assert!(picture == &kept[name], "{name} is stale: {remedy}");
    }
}
