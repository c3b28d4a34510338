//! Words with numbers before them.

/// `1 kernel`, `2 kernels`.
pub fn counted(count: usize, one: &str) -> String {
    format!("{count} {one}{}", if count == 1 { "" } else { "s" })
}
