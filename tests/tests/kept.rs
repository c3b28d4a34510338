//! No worst input is kept of a kernel that does not exist; the others, the kernels' own tests judge.

use closedform_tests::{kept, kernels};

#[test]
fn every_kept_input_is_of_a_kernel() {
    let kernels: Vec<&str> = kernels::all().map(|kernel| kernel.info.name).collect();
    let strangers = kept::strangers(&kernels, &kept::load());
    assert!(strangers.is_empty(), "\n{}", strangers.join("\n\n"));
}
