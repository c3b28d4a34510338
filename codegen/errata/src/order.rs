//! The order of the errata on the page: `errata/ORDER`, a name a line.

use std::collections::BTreeSet;
use std::path::Path;

use super::error::VerdictError;
use closedform_project::family::family_names;
use closedform_project::source;

/// The list.
const ORDER: &str = "ORDER";

/// The names of the errata, in the order of the page.
pub(super) fn names(errata: &Path) -> Result<Vec<String>, VerdictError> {
    let path = errata.join(ORDER);
    let text = source::read(&path, "write a list of the errata, one name a line, in the order of the page")?;
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let names: Vec<String> = lines.map(str::to_owned).collect();
    match complaint(&names, &family_names(errata)?) {
        Some(complaint) => Err(VerdictError::Order { path, complaint }),
        None => Ok(names),
    }
}

fn complaint(listed: &[String], present: &[String]) -> Option<String> {
    let mut seen = BTreeSet::new();
    let twice = listed.iter().find(|name| !seen.insert(*name)).map(|name| format!("`{name}` is listed twice"));
    let unlisted = present.iter().find(|name| !listed.contains(name));
    let unlisted = unlisted.map(|name| format!("`{name}` is not listed, but {name}.toml is there"));
    let missing = listed.iter().find(|name| !present.contains(name));
    let missing = missing.map(|name| format!("`{name}` is listed, but there is no {name}.toml"));
    twice.or(unlisted).or(missing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_complete_and_has_no_more() {
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        assert_eq!(complaint(&names(&["b", "a"]), &names(&["a", "b"])), None);
        let complain = |listed, present| complaint(&names(listed), &names(present)).unwrap();
        assert!(complain(&["a", "a"], &["a"]).contains("twice"));
        assert!(complain(&["a"], &["a", "b"]).contains("not listed"));
        assert!(complain(&["a", "b"], &["a"]).contains("there is no b.toml"));
    }
}
