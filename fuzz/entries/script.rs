//! What must hold of any bytes that are read as the file of a worksheet.

use std::path::Path;

use closedform_project::script::Script;

/// The bytes are read or refused with a reason, and every letter that was read has a place.
pub fn script(bytes: &[u8]) {
    for name in ["any.mac", "any.wxm", "any.wxmx"] {
        match Script::of(Path::new(name), bytes) {
            Ok(script) => {
                let starts = script.text().char_indices().map(|(at, _)| at).step_by(97);
                assert!(script.places(starts).iter().all(|place| place.starts_with(name)));
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}
