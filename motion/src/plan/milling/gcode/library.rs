//! Sub-programs where they stand: in the lines of a file, or in a file of their own.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::dialect::Dialect;
use super::source::Line;
use super::statement::{Keyword, Label, Statement};
use super::text::Text;

/// A file of a sub-program that is larger than this is none.
const LARGEST: u64 = 16 << 20;

/// The lines of a sub-program: those behind its name, up to its end.
///
/// `O1 sub` ends with `O1 endsub`; a program with the number 1 ends where the next one begins.
pub(super) fn cut<'a>(
    lines: impl Iterator<Item = &'a Line>,
    label: &str,
    dialect: Dialect,
    text: &mut Text,
) -> Option<Vec<Line>> {
    let mut found: Option<(Keyword, Vec<Line>)> = None;
    for line in lines {
        let statement = Statement::of_raw(&line.bytes, dialect, text);
        match (&mut found, statement) {
            (None, Some(begin)) if begin.is(label, &[Keyword::Sub, Keyword::Program]) => {
                found = Some((begin.keyword, Vec::new()));
            }
            (None, _) => {}
            (Some((Keyword::Sub, lines)), Some(end)) if end.is(label, &[Keyword::EndSub]) => {
                lines.push(line.clone());
                return found.map(|(_, lines)| lines);
            }
            (
                Some((Keyword::Program, _)),
                Some(Statement { keyword: Keyword::Program, label: Label::Known(_), .. }),
            ) => {
                break;
            }
            (Some((_, lines)), _) => lines.push(line.clone()),
        }
    }
    found.filter(|(keyword, _)| *keyword == Keyword::Program).map(|(_, lines)| lines)
}

/// The same from a file that has its name; a file without that sub-program is one as a whole.
pub(super) fn load(folders: &[PathBuf], label: &str, dialect: Dialect, text: &mut Text) -> Option<Vec<Line>> {
    // A name from a file must not lead out of the folder.
    if !label.bytes().all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-')) || label.is_empty() {
        return None;
    }
    let bytes = folders.iter().find_map(|folder| read(folder, label))?;
    let lines: Vec<Line> = (1..)
        .zip(bytes.split(|byte| *byte == b'\n'))
        .map(|(number, bytes)| Line { number, bytes: Rc::from(bytes) })
        .collect();
    cut(lines.iter(), label, dialect, text).or(Some(lines))
}

fn read(folder: &Path, label: &str) -> Option<Vec<u8>> {
    let wanted = |name: &str| {
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
        let stem = stem.to_ascii_lowercase();
        let number = stem.strip_prefix('o').unwrap_or(&stem).trim_start_matches('0');
        let known = matches!(ending.to_ascii_lowercase().as_str(), "ngc" | "nc" | "gcode" | "cnc" | "tap" | "");
        known && (stem == label || (label.bytes().all(|byte| byte.is_ascii_digit()) && number == label))
    };
    let mut names: Vec<_> = std::fs::read_dir(folder).ok()?.flatten().map(|entry| entry.file_name()).collect();
    names.sort();
    let name = names.into_iter().find(|name| name.to_str().is_some_and(wanted))?;
    let mut bytes = Vec::new();
    let file = File::open(folder.join(name)).ok()?;
    file.take(LARGEST).read_to_end(&mut bytes).ok()?;
    Some(bytes)
}
