//! What proves its bounds is what users link, and another bound of it is refused.

use closedform_bounds::check_text;
use closedform_tests::{bounds, kernels, worksheets};

#[test]
fn every_kernel_of_a_generated_text_is_linked() {
    let mut generated = Vec::new();
    for family in worksheets::families("toml") {
        let text = bounds::generated(&family);
        generated.extend(bounds::kernels(&text).into_iter().map(|(name, _)| format!("{family}::{name}")));
    }
    let linked: Vec<&str> = kernels::all().map(|kernel| kernel.info.name).collect();
    assert_eq!(generated, linked);
}

/// What other mistakes are refused, kernels for the purpose show (`judges/bounds.rs`).
#[test]
fn a_generated_kernel_is_refused_half_its_bound() {
    let single = |kernel: &&closedform::Kernel| kernel.info.results.len() == 1;
    let info = kernels::all().find(single).expect("a kernel of one result").info;
    let (family, name) = info.name.split_once("::").expect("a family");
    let bound = info.results[0].bound_ulp.expect("a bound");
    let [stated, halved] = [bound, bound / 2.0].map(|bound| format!("bound = {bound:?},"));
    let said = bounds::refusal(&bounds::generated(family), name, &stated, &halved);
    assert!(said.contains(&format!("kernel `{name}`")) && said.contains(&format!("{bound} ulp is what")), "{said}");
}

#[test]
fn what_is_no_kernel_is_no_proof() {
    assert!(check_text("#[kernel]\npub fn f(x: f64) -> f64 { x.sin() }").is_err());
    assert_eq!(check_text("fn f() {}"), Ok(Vec::new()));
}
