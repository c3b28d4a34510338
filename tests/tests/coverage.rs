//! No contract, reference or golden value without a kernel; that no kernel lacks any, each one's own test says.

use closedform::Info;
use closedform_tests::{coverage, kernels};

#[test]
fn nothing_is_left_over() {
    let infos: Vec<&Info> = kernels::all().map(|kernel| kernel.info).collect();
    let left: Vec<String> = coverage::families(&infos).iter().flat_map(coverage::Family::strangers).collect();
    assert!(left.is_empty(), "{}", left.join("\n"));
}
