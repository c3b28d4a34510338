//! The way from one folder to another, so that what is written there can be moved with both.

use std::path::{Component, Path, PathBuf};

/// The way from one folder to another, from where both really are; the other itself where they have no root in common.
#[must_use]
pub fn way(from: &Path, to: &Path) -> PathBuf {
    let (from, to) = (whole(from), whole(to));
    let shared = from.components().zip(to.components()).take_while(|(one, other)| one == other).count();
    if shared == 0 {
        return to;
    }
    let up = from.components().skip(shared).map(|_| Component::ParentDir);
    up.chain(to.components().skip(shared)).collect()
}

/// A path from the root, through links; what does not exist yet stands behind what does.
fn whole(path: &Path) -> PathBuf {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    for above in absolute.ancestors() {
        if let (Ok(real), Ok(rest)) = (above.canonicalize(), absolute.strip_prefix(above)) {
            return if rest.as_os_str().is_empty() { real } else { real.join(rest) };
        }
    }
    absolute
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_leads_over_what_both_share() {
        let way = |from: &str, to: &str| way(Path::new(from), Path::new(to)).display().to_string();
        assert_eq!(way("/no-such/a/mine", "/no-such/a/closedform/runtime"), "../closedform/runtime");
        assert_eq!(way("/no-such/a/b/c", "/no-such/x/runtime"), "../../../x/runtime");
        assert_eq!(way("/no-such/closedform", "/no-such/closedform/runtime"), "runtime");
    }
}
