//! What must hold of any text that is read as FPCores.

use closedform_maxima::{parse_expression, print};
use closedform_project::fpcore::cores;

/// Cores are read or refused at a place in the text, and their formulas mean the same after they were printed.
pub fn cores_of(text: &str) {
    let (cores, mistakes) = cores(text);
    for mistake in mistakes {
        let (start, len) = (mistake.span.offset(), mistake.span.len());
        assert!(text.get(start..start + len).is_some(), "{mistake:?}");
    }
    for core in cores {
        let printed = print(&core.definition.body);
        assert_eq!(parse_expression(&printed).map(|again| print(&again)), Ok(printed));
    }
}
