//! Worksheets that another one loads and that stand beside it.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use crate::script::Script;
use crate::worksheet;

/// Such a worksheet.
pub(crate) struct Beside {
    /// Its file.
    pub(crate) path: PathBuf,
    /// Its text.
    pub(crate) script: Script,
}

/// The worksheets that a text loads, and those that these load, by the names under which they are mentioned. They stand in
/// the folder of the worksheet or below it.
pub(crate) fn beside(path: &Path, text: &str) -> BTreeMap<String, Beside> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut found = BTreeMap::new();
    let mut open = vec![text.to_owned()];
    while let Some(text) = open.pop() {
        for name in worksheet::loaded(&text) {
            let stays = Path::new(&name).components().all(|part| matches!(part, Component::Normal(_)));
            let candidates = [folder.join(&name), folder.join(format!("{name}.mac"))];
            let file = candidates.into_iter().find(|file| stays && file.is_file() && *file != path);
            if let Some(path) = file
                && let Ok(script) = Script::load(&path)
                && !found.contains_key(&name)
            {
                open.push(script.text().to_owned());
                found.insert(name, Beside { path, script });
            }
        }
    }
    found
}
