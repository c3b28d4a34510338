//! What C callers do wrong has a status and a text; threads, empty arrays, examples and pkg-config; C99 without contraction.

mod common;

use common::{ARCHIVE, BOUND, answer, compile, compilers, demand};
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// What `edges.c` must say, line by line.
const SAID: &str = "\
good: 0: 
nothing: 0: 
null input: 4: turnaround::t_in: `t_out` is a null pointer
null result: 4: turnaround::t_in: `t_in_out` is a null pointer
misaligned: 5: turnaround::t_in: `t_out` is a pointer that is not aligned as its type demands
short input: 3: turnaround::t_in: `t_edge_total` must have length 1000, not 999
overlap: 6: turnaround::t_in: `t_in_out` shares memory with `t_edge_total`
endless: 3: turnaround::t_in: `t_out` is longer than memory
huge: 3: turnaround::t_in: `t_in_out` is longer than memory
results overlap: 6: turnaround::outer_ramp: `k_out` shares memory with `t0_out`
checked: 0: 
0.035025418253494825
outside: 1: turnaround::t_in: outside the domain: `d2Step > 0` does not hold for t_out = 0.002, t_edge_total = 0.028, a2_max = 2.0, d2_step = 0.0
not a number: 1: turnaround::t_in: outside the domain: `every input is finite` does not hold for t_out = NaN, t_edge_total = 0.028, a2_max = 2.0, d2_step = 0.002
little room: 1: turnaround:
no room: 1: as it was
no text: 1: 
untouched: 7
null: 4: turnaround::t_in: `result` is a null pointer
misaligned: 5: turnaround::t_in: `result` is a pointer that is not aligned as its type demands
found: turnaround::t_in
beyond: 1
Time of the ramp in of the symmetric turn-around that makes the step d2Step.: 4 inputs, d2Step [m], 5 conditions, tOut >= 0, bound 4.51
again: 0: 
threads: 4
";

/// Compiles a program with the static library and returns where it is.
fn linked(compiler: &str, source: &str) -> PathBuf {
    let name = source.rsplit(['/', '.']).nth(1).unwrap();
    let program = BOUND.join(format!("{name}-{compiler}"));
    let archive = ARCHIVE.to_str().unwrap();
    let output = ["-o", program.to_str().unwrap(), "-Iinclude", source, archive];
    compile(compiler, &[&output[..], &["-lm", "-lpthread", "-ldl"]].concat());
    program
}

#[test]
fn mistakes_of_callers_have_a_status_and_a_text() {
    fs::write(BOUND.join("edges.c"), include_str!("edges.c")).unwrap();
    for compiler in compilers() {
        assert_eq!(answer(&linked(compiler, "edges.c"), ""), SAID, "{compiler}");
    }
}

#[test]
fn the_examples_are_built_and_the_record_is_processed() {
    for compiler in compilers() {
        let record = linked(compiler, "examples/record.c");
        assert!(demand(&mut Command::new(&record)).starts_with("five_segment::ki_without_middle: 0."));
        let outside = Command::new(&record).arg("-1").output().unwrap();
        let said = String::from_utf8_lossy(&outside.stdout);
        assert!(
            !outside.status.success() && said.contains("INVALID") && said.contains("`DeltaX > 0` does not hold"),
            "{said}"
        );
        compile(compiler, &["-Iinclude", "-c", "-o", "controller.o", "examples/controller.c"]);
    }
}

/// Where the compiler may fuse a product with a sum, and is told to, the source forbids it.
#[test]
#[cfg(target_arch = "x86_64")]
fn no_product_is_fused_with_a_sum() {
    let source = "c99/closedform_kernels_tier1.c";
    let flags = ["-std=gnu99", "-O3", "-march=haswell", "-ffp-contract=fast", "-c", "-o"];
    let fused = |compiler: &str, source: &str| {
        let object = format!("fused-{compiler}.o");
        demand(Command::new(compiler).args(flags).args([&object, source]).current_dir(&*BOUND));
        demand(Command::new("objdump").args(["-d", &object]).current_dir(&*BOUND)).matches("vfm").count()
    };
    fs::write(BOUND.join("fused.c"), "double f(double a, double b, double c) { return a * b + c; }\n").unwrap();
    for compiler in compilers() {
        assert_eq!(fused(compiler, source), 0, "{compiler}");
        assert!(fused(compiler, "fused.c") > 0, "{compiler} fuses nothing: this test tells nothing");
    }
}

#[test]
fn arithmetic_that_breaks_the_bounds_is_refused() {
    for compiler in compilers() {
        let output = Command::new(compiler)
            .args(["-std=c99", "-ffast-math", "-fsyntax-only", "c99/closedform_kernels_tier1.c"])
            .current_dir(&*BOUND)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains("compile without -ffast-math"), "{compiler}: {said}");
    }
}
