//! Mutants of kernels of every kind: none survives. `closedform mutants` without a name goes through all kernels.

mod common;

use common::{edit, fails, project, repository, succeeds};

/// Plain ones, with branches, with roots in sums, with several results, with a polynomial root, and the greatest of some.
const KERNELS: [&str; 7] = [
    "fly_axis::a1_in",
    "milling_time::limit_of_axes",
    "milling_time::step_speed",
    "optimum::quartic",
    "turnaround::t_in",
    "turnaround::t_in_of_tau",
    "waypoints::linear",
];

#[test]
fn no_mutant_survives() {
    for kernel in KERNELS {
        succeeds(&repository(), &["mutants", kernel]);
    }
}

#[test]
fn a_listed_mutant_must_survive() {
    let project = project();
    std::fs::create_dir_all(project.path().join("tests")).unwrap();
    let list = project.path().join("tests/EQUIVALENT.toml");
    std::fs::write(
        &list,
        "[[equivalent]]\nkernel = \"fly_axis::a1_in\"\nstep = \"result\"\nmistakes = [\"first operand alone\"]\nreason = \"none\"\n",
    )
    .unwrap();
    let said = fails(project.path(), &["mutants", "fly_axis::a1_in"]);
    assert!(said.contains("1 entry of the list is not needed"), "{said}");
    edit(&list, "reason", "because");
    assert!(fails(project.path(), &["mutants", "fly_axis::a1_in"]).contains("no list of equivalent mutants"));
}
