//! The kernels under judgement.

use closedform::Kernel;

use crate::check::Judge;
use crate::reference::References;

/// Every kernel that users can link.
pub fn all() -> impl Iterator<Item = &'static Kernel> {
    closedform_kernels::ALL.iter().copied()
}

/// A judge for every kernel.
pub fn judges() -> Vec<Judge> {
    all().map(judge).collect()
}

/// The judge of the kernel `family::name`.
pub fn judge_of(name: &str) -> Judge {
    judge(all().find(|kernel| kernel.info.name == name).unwrap_or_else(|| panic!("no kernel `{name}`")))
}

/// The judge of a kernel, by the references of its family.
pub fn judge(kernel: &'static Kernel) -> Judge {
    let references = References::load(kernel.info.family);
    Judge::new(kernel, &references).unwrap_or_else(|missing| panic!("{missing}"))
}
