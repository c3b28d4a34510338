//! The errata and the kernels: shipped formulas are what rows say, and no printed error is.

use std::collections::BTreeSet;

use closedform_tests::claim::Case;
use closedform_tests::errata::{Row, rows};
use closedform_tests::reference::References;
use closedform_tests::{parallel, worksheets};

/// Functions that no row is about, by their names or how these begin, and why they are shipped.
const NOT_PRINTED: [(&str, &str); 24] = [
    ("Ki_c", "the cell of 4.4.1 prints it for another braking, where it is wrong"),
    ("dd1Out_dtIn", "II 1.3 prints the other derivative of the same distance"),
    ("la_", "no printed derivation looks ahead"),
    ("mt_constant_speed", "the limit of short steps; the derivation prints the steps"),
    ("mt_constant_time", "as before"),
    ("mt_cut_time", "the limit of the derivation's sum"),
    ("mt_cut_speed", "the feed limit is not in the derivation"),
    ("mt_limit", "the derivation says in words that the least speed of the axes is driven"),
    ("quartic_abcd", "%o262 has all four roots by radicals, this is the positive one"),
    ("rscn_tIn_of_tOut", "%o202 has it put into the overhead"),
    ("s5SX_", "section 3 solved for the accelerations; the derivation solves it for the times"),
    ("sc_", "no printed derivation limits the jerk"),
    ("tIn_tE0", "%o259 in the variables of section 4.6"),
    ("wp_a_c10", "0.1 prints it within S1(t)"),
    ("wp_a_c11", "0.1 prints it within S1(t)"),
    ("wp_a_c20", "0.1 prints it within S2(t)"),
    ("wp_a_c21", "0.1 prints it within S2(t)"),
    ("wp_c_", "the derivation states this problem and does not solve it"),
    ("wp_d_", "as before"),
    ("wp_e_", "as before"),
    ("wp_f_", "as before"),
    ("wp_length_2d", "at the derivation's speed of 1 it is the time"),
    ("wp_length_3d", "the derivation has two coordinates"),
    ("wp_time_3d", "the derivation has two coordinates"),
];

/// All that is wrong with the rows, each with its name.
fn demand(work: impl Fn(&Row) -> Vec<String> + Sync) {
    let complain = |(family, row): &(String, Row)| -> Vec<String> {
        work(row).into_iter().map(|complaint| format!("{family}, {}: {complaint}", row.cell)).collect()
    };
    let complaints = parallel::map(&rows(), complain).concat();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// That the kernel is the true form, its own test says.
#[test]
fn every_claim_is_of_a_kernel() {
    demand(|row| row.claims.iter().filter_map(|claim| Case::new(row, claim).err()).collect());
}

#[test]
fn kernels_are_not_the_printed_errors() {
    demand(|row| {
        if !row.is_error {
            return Vec::new();
        }
        let differs = row.claims.iter().map(|claim| Case::new(row, claim)?.differs()).collect::<Result<Vec<bool>, _>>();
        match differs {
            Ok(differs) if differs.contains(&true) => Vec::new(),
            Ok(_) => vec!["the printed form has the kernels' values at the example".to_owned()],
            Err(error) => vec![error],
        }
    });
}

#[test]
fn every_reference_is_printed_or_accounted_for() {
    let printed: BTreeSet<String> =
        rows().into_iter().flat_map(|(_, row)| row.claims).map(|claim| claim.function).collect();
    let families = worksheets::families("ref").into_iter();
    let shipped: BTreeSet<String> =
        families.flat_map(|family| References::load(&family).names().map(str::to_owned).collect::<Vec<_>>()).collect();
    let unprinted: BTreeSet<&String> = shipped.difference(&printed).collect();
    let is_meant = |entry: &str, name: &str| name == entry || entry.ends_with('_') && name.starts_with(entry);
    let unaccounted = |name: &&String| !NOT_PRINTED.iter().any(|(entry, _)| is_meant(entry, name));
    let missing = unprinted.iter().copied().filter(unaccounted);
    let missing = missing.map(|name| format!("`{name}`: name it in a row, or in NOT_PRINTED"));
    let needless = |entry: &str| {
        let printed_too = printed.iter().any(|name| is_meant(entry, name));
        printed_too || !unprinted.iter().any(|name| is_meant(entry, name))
    };
    let needless = NOT_PRINTED.iter().filter(|(entry, _)| needless(entry));
    let needless = needless.map(|(entry, reason)| format!("`{entry}` ({reason}): strike it out of NOT_PRINTED"));
    let complaints: Vec<String> = missing.chain(needless).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}
