//! What must hold of any text that is read as a contract.

use std::path::Path;

use closedform_project::contract;

/// The text is read or refused with a reason.
pub fn contract(text: &str) {
    if let Err(error) = contract::parse(Path::new("any.toml"), text) {
        assert!(!error.to_string().is_empty());
    }
}
