//! Every kernel's stated bound is what its Rust text proves, and a doctored text is refused.

use closedform_bounds::check_text;
use closedform_tests::{bounds, kernels};

#[test]
fn every_bound_is_derived_from_the_text() {
    let mut proved = Vec::new();
    let mut refused = Vec::new();
    for (family, checked) in bounds::all() {
        match checked {
            Ok(more) => proved.extend(more.into_iter().map(|bound| (format!("{family}::{}", bound.kernel), bound))),
            Err(error) => refused.push(format!("{family}: {error}")),
        }
    }
    assert!(refused.is_empty(), "\n{}", refused.join("\n"));
    let linked: Vec<(&str, &str, Option<f64>)> = kernels::all()
        .flat_map(|kernel| kernel.info.results.iter().map(|result| (kernel.info.name, result.name, result.bound_ulp)))
        .collect();
    let derived: Vec<(&str, &str, Option<f64>)> =
        proved.iter().map(|(kernel, bound)| (kernel.as_str(), bound.result.as_str(), Some(bound.ulp))).collect();
    assert_eq!(derived, linked, "what is proved is not what users link");
}

/// Kernel, what is changed in it to what, and what must be said.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

fn refuse(cases: &[Case]) {
    for (family, kernel, from, to, expected) in cases {
        let said = bounds::refusal(family, kernel, from, to);
        assert!(said.contains(&format!("kernel `{kernel}`")), "{said}");
        for text in *expected {
            assert!(
                said.contains(text),
                "`{from}` as `{to}` in `{family}::{kernel}`: {text:?} is not said in:\n{said}"
            );
        }
    }
}

#[test]
fn wrong_bounds_are_refused() {
    refuse(&[
        ("turnaround", "t_in", "bound = 4.51", "bound = 3.51", &["`t_in`", "3.51 ulp", "4.51 ulp is what"]),
        ("turnaround", "t_in", "bound = 4.51", "bound = 4.5", &["stated as 4.5 ulp"]),
        ("turnaround", "t_in", "bound = 4.51", "bound = 4.54", &["stated as 4.54 ulp", "to be 4.51 ulp"]),
        ("turnaround", "t_in", "bound = 4.51,", "", &["no bound is stated", "4.51 ulp"]),
        ("turnaround", "ramp_in", "v2_in = 0.5", "v2_in = 0.4", &["`v2_in`", "0.5 ulp is what"]),
        ("waypoints", "linear", "c01 = 2.0", "c01 = 1.0", &["`c01`", "2 ulp is what"]),
        ("optimum", "quartic", "bound = 0.51", "bound = 0.5", &["0.51 ulp is what"]),
        ("overhead", "t_edge", "bound = 0.51", "bound = 0.5", &["0.51 ulp is what"]),
        ("overhead", "t_edge", "precision = \"double-double\"", "precision = \"double\"", &["stated as 0.51 ulp"]),
        ("turnaround", "t_in", "bound = 4.51", "precision = \"double-double\", bound = 4.51", &["0.51 ulp"]),
    ]);
}

#[test]
fn sums_that_may_cancel_are_refused() {
    const CANCELS: &str = "may cancel";
    refuse(&[
        (
            "turnaround",
            "t_in",
            "(root + polynomial2",
            "(root - polynomial2",
            &["`t_in`", CANCELS, "the right one not positive"],
        ),
        ("turnaround", "outer_ramp", "= root + 3.0", "= root - 3.0", &["`sum2`", CANCELS]),
        ("milling_time", "direction", "x * x + ", "x * y + ", &["`root`", CANCELS, "open"]),
        ("milling_time", "cut_speed", "+ 4.0 * length", "- 4.0 * length", &["`root`", CANCELS]),
        ("step_move", "continuous_move", "5.0 * root + ko", "5.0 * root - ko", &["`sum`", CANCELS]),
        ("step_move", "continuous_move", "product2 + cancelling8", "product2 - cancelling8", &["`kx1`", CANCELS]),
        ("overhead", "step_limited", "product2 * root + ", "product2 * root - ", &["`t_ovr_hd`", CANCELS]),
    ]);
}

#[test]
fn dropped_compensation_is_refused() {
    refuse(&[
        (
            "turnaround",
            "outer_ramp",
            "let cancelling = compensated!(",
            "let cancelling = (",
            &["`cancelling`", "may cancel"],
        ),
        (
            "overhead",
            "step_limited",
            "require!(compensated!(3.0 * delta - t_in * t_in)",
            "require!((3.0 * delta - t_in * t_in)",
            &["`require!`", "rounding may turn"],
        ),
        ("turnaround", "outer_ramp", "a0 / sum2", "compensated!(a0 * sum2)", &["`v0`", "takes `sum2` for exact"]),
    ]);
}

#[test]
fn dropped_conditions_are_refused() {
    refuse(&[
        (
            "turnaround",
            "t_in",
            "require!(t_edge_total >= 0.0",
            "require!(t_edge_total <= 0.0",
            &["`t_in`", "may cancel"],
        ),
        ("overhead", "step_limited", "require!(v1_scan > v1_diff, \"v1Scan > v1Diff\");", "", &["`sum`", "may cancel"]),
        (
            "step_move",
            "continuous_move",
            "require!(ko > 0.0, \"Ko > 0\");",
            "",
            &["`root`", "stands under a root, and may be negative"],
        ),
        ("milling_time", "step_speed", "if u >= 0.0", "if u <= 0.0", &["`step_speed`", "root + u", "may cancel"]),
        ("milling_time", "step_speed", "if u >= 0.0", "if a >= 0.0", &["`step_speed`", "root + u", "may cancel"]),
        ("pvt", "arrival_first", "difference2 >= 0.0) ||", "difference2 <= 0.0) ||", &["`a1`", "may cancel"]),
    ]);
}

#[test]
fn more_roundings_are_refused() {
    refuse(&[
        ("turnaround", "t_in", "2.0 * cancelling /", "3.0 * cancelling /", &["`t_in`", "5.51 ulp is what"]),
        ("milling_time", "cut_time", "2.0 * root", "root / 3.0", &["`cut_time`", "3 ulp is what"]),
        ("milling_time", "step_time", "length / speed", "length * (1.0 / speed)", &["`step_time`", "2 ulp is what"]),
        (
            "turnaround",
            "t_in_of_d2_in",
            "sqrt(6.0 * d2_in / a2_max)",
            "sqrt(6.0 * d2_in) / sqrt(a2_max)",
            &["3.5 ulp is what"],
        ),
    ]);
}

#[test]
fn wrong_corrections_of_roots_are_refused() {
    refuse(&[
        ("optimum", "quartic", "2.0 * qa * start", "3.0 * qa * start", &["`quartic`", "the divisor is not the sum"]),
        ("optimum", "quartic", "+ qc) - qd", "- qc) - qd", &["the remainder is not the polynomial"]),
        ("optimum", "quartic", "require!(qd > 0.0, \"qd > 0\");", "", &["`quartic`"]),
        (
            "optimum",
            "quartic",
            "start - start * (remainder",
            "start + start * (remainder",
            &["`remainder`", "no bound of its own"],
        ),
        ("optimum", "t_i", "cancelling2 = compensated!", "cancelling2 = residual!", &["`t_i`", "write `compensated!`"]),
        (
            "optimum",
            "t_in",
            "cancelling2 = compensated!",
            "cancelling2 = residual!",
            &["`t_in`", "write `compensated!`"],
        ),
    ]);
}

/// Where the residual of t_i in double-double was off by more than the last digit: 8*v^2 cancels against 3*a^2*delta.
#[test]
fn roots_keep_their_bound_where_a_coefficient_cancels() {
    let judge = kernels::judge_of("optimum::t_i");
    for point in [
        [1.591153435001304, 1.1022271581100482, 1e-35, 1.27963710888946],
        [1.4327670679050533, 1.7622800824579419, 1e-60, 4.0342928119081245],
    ] {
        judge.errors(&point, "the residual cancels").unwrap_or_else(|failure| panic!("{failure}"));
    }
}

#[test]
fn what_is_no_kernel_is_no_proof() {
    assert!(check_text("#[kernel]\npub fn f(x: f64) -> f64 { x.sin() }").is_err());
    assert_eq!(check_text("fn f() {}"), Ok(Vec::new()));
}
