//! What must hold of any text that is read as Rust with kernels.

use closedform_syntax::{RULES, certificate, operations, ordinary, parse_file};

/// The text is read or refused with a reason, and of every kernel that was read the macro can tell what it needs.
pub fn kernel(text: &str) {
    match parse_file(text) {
        Ok(kernels) => kernels.iter().for_each(|kernel| {
            assert!(certificate(kernel).starts_with(&format!("{RULES}-")));
            _ = operations(kernel);
            _ = ordinary(kernel);
        }),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
