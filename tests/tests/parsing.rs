//! Worksheets survive parsing and printing, as their reference expressions do.

use closedform_tests::printing::check_printing;
use closedform_tests::worksheets;

#[test]
fn worksheets_survive_printing() {
    let families = worksheets::families("mac");
    assert!(!families.is_empty(), "no files *.mac");
    for family in families {
        check_printing(&worksheets::read(&family, "mac")).unwrap_or_else(|broken| panic!("{family}.mac: {broken}"));
    }
}
