//! No kernel without its contract, reference, golden values and bound, and none of these without a kernel.

use closedform::Info;
use closedform_tests::{coverage, kernels};

#[test]
fn nothing_is_missing() {
    let infos: Vec<&Info> = kernels::all().map(|kernel| kernel.info).collect();
    let gaps: Vec<String> = coverage::families(&infos).iter().flat_map(coverage::Family::gaps).collect();
    assert!(gaps.is_empty(), "{}", gaps.join("\n"));
}
