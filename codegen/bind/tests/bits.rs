//! Every kernel in C: the bits of the Rust kernel at golden values, worst inputs and outside the domain.

mod common;

use closedform::{CallError, Kernel};
use closedform_bind::Library;
use closedform_kernels::ALL;
use closedform_project::{golden, kept};
use common::{ARCHIVE, BOUND, answer, compile, compilers, library, repository};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

/// The points of a kernel, and how many of them come from golden values.
#[derive(Default)]
struct Points {
    all: Vec<Vec<f64>>,
    golden: usize,
}

/// The values of `inputs` in the order of the kernel.
fn in_order(kernel: &Kernel, inputs: &[(String, f64)]) -> Vec<f64> {
    let value = |name: &str| inputs.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let values = kernel.info.inputs.iter().map(|input| value(input.maxima).expect("a value for every input"));
    values.collect()
}

/// Golden values, worst inputs, and what is no input.
fn points() -> BTreeMap<&'static str, Points> {
    let mut points: BTreeMap<&str, Points> = BTreeMap::new();
    for kernel in ALL {
        let file = repository().join(format!("maxima-ref/{}.tsv", kernel.info.family));
        let own = points.entry(kernel.info.name).or_default();
        for value in golden::load(&file).unwrap() {
            if kernel.info.results[0].worksheet == value.worksheet {
                own.all.push(in_order(kernel, &value.inputs));
            }
        }
        own.golden = own.all.len();
        assert!(own.golden > 0, "no golden values of {}", kernel.info.name);
        let (first, count) = (own.all[0].clone(), kernel.info.inputs.len());
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, -1.0, 1e-320, 1e300] {
            own.all.push(vec![bad; count]);
            for position in 0..count {
                let mut point = first.clone();
                point[position] = bad;
                own.all.push(point);
            }
        }
    }
    for kept in kept::load(&repository().join("tests")).unwrap() {
        let kernel = ALL.iter().find(|kernel| kernel.info.name == kept.kernel).expect("a kernel of that name");
        points.entry(kernel.info.name).or_default().all.push(in_order(kernel, &kept.inputs));
    }
    points
}

/// A program that reads a kernel's number and the bits of inputs a line, and writes what every call says.
fn driver(library: &Library) -> String {
    let mut text = String::from(include_str!("driver.c"));
    let prefix = "closedform_kernels";
    let header = fs::read_to_string(BOUND.join("c99/closedform_kernels_tier1.h")).unwrap();
    for (position, kernel) in library.kernels.iter().enumerate() {
        let (n, m) = (kernel.inputs.len(), kernel.results.len());
        let own = format!("{}_{}", kernel.family, kernel.name);
        let list = |count: usize, item: &dyn Fn(usize) -> String| (0..count).map(item).collect::<Vec<_>>().join(", ");
        let inputs = list(n, &|at| format!("in[{at}]"));
        let views = list(n, &|at| format!("view(in, {at})"));
        let spans = list(m, &|at| format!("span(out, {at})"));
        let pointers = list(m, &|at| format!("&out[{at}]"));
        let returned = if kernel.returned.is_some() { format!("{prefix}_{own}_results") } else { "double".to_owned() };
        let tier1 = format!("{prefix}_tier1_{own}(");
        let tier1 =
            if header.contains(&tier1) { format!("{tier1}{inputs}, {pointers})") } else { "NO_TIER1".to_owned() };
        let _ = write!(
            text,
            "\nstatic void kernel_{position}(const double *in) {{
    double out[ROOM];
    char said[2000];
    int status;
    {returned} result;
    memset(&result, 0x55, sizeof result);
    result = {prefix}_{own}({inputs});
    print((const double *)&result, {m});
    result = {prefix}_{own}_faithful({inputs});
    print((const double *)&result, {m});
    memset(&result, 0, sizeof result);
    status = {prefix}_{own}_checked({inputs}, &result, said, sizeof said);
    printf(\"%d\\t\", status);
    print((const double *)&result, {m});
    printf(\"%s\\t\", said);
    status = {prefix}_{own}_batch({views}, {spans}, said, sizeof said);
    printf(\"%d\\t\", status);
    print(row(out, {m}), {m});
    memset(out, 0, sizeof out);
    status = {tier1};
    printf(\"%d\\t\", status);
    print(out, {m});
    printf(\"\\n\");
}}
"
        );
    }
    let calls = (0..library.kernels.len()).map(|position| format!("kernel_{position}")).collect::<Vec<_>>().join(", ");
    let counts = library.kernels.iter().map(|kernel| kernel.inputs.len().to_string()).collect::<Vec<_>>().join(", ");
    text + &format!(
        "\nint main(void) {{
    static void (*const calls[])(const double *) = {{{calls}}};
    static const int counts[] = {{{counts}}};
    return answer(calls, counts);
}}
"
    )
}

fn bits(values: &[f64]) -> String {
    values
        .iter()
        .map(|value| if value.is_nan() { "nan".to_owned() } else { format!("{:016x}", value.to_bits()) })
        .collect::<Vec<_>>()
        .join(" ")
}

/// What the library must say of a point: the columns of the driver before those of tier 1.
fn expected(kernel: &Kernel, point: &[f64]) -> Vec<String> {
    let count = kernel.info.results.len();
    let mut values = vec![0.0; count];
    kernel.eval(point, &mut values).unwrap();
    let eval = bits(&values);
    kernel.faithful(point, &mut values).unwrap();
    let faithful = bits(&values);
    values.fill(0.0);
    let (status, text) = match kernel.checked(point, &mut values) {
        Ok(()) => (0, String::new()),
        Err(error @ CallError::Domain(_)) => (1, error.to_string()),
        Err(error) => (2, error.to_string()),
    };
    vec![eval.clone(), faithful, status.to_string(), bits(&values), text, "0".to_owned(), eval]
}

#[test]
fn every_kernel_has_the_bits_of_rust() {
    let (points, library) = (points(), library());
    let position = |name: &str| library.kernels.iter().position(|kernel| kernel.full_name() == name).unwrap();
    let mut input = String::new();
    for (name, own) in &points {
        for point in &own.all {
            let bits: Vec<String> = point.iter().map(|value| format!("{:016x}", value.to_bits())).collect();
            let _ = writeln!(input, "{} {}", position(name), bits.join(" "));
        }
    }
    let source = BOUND.join("driver.c");
    fs::write(&source, driver(&library)).unwrap();
    for compiler in compilers() {
        let program = BOUND.join(format!("driver-{compiler}"));
        let archive = ARCHIVE.to_str().unwrap();
        let output = [
            "-o",
            program.to_str().unwrap(),
            "-O2",
            "-Iinclude",
            "-Ic99",
            "driver.c",
            "c99/closedform_kernels_tier1.c",
        ];
        compile(compiler, &[&output[..], &[archive, "-lm", "-lpthread", "-ldl"]].concat());
        compare(compiler, &points, &answer(&program, &input));
    }
}

fn compare(compiler: &str, points: &BTreeMap<&str, Points>, output: &str) {
    let mut lines = output.lines();
    let (mut settled, mut golden) = (0, 0);
    for (name, own) in points {
        let kernel = ALL.iter().find(|kernel| kernel.info.name == *name).unwrap();
        let (mut has_tier1, mut at_golden) = (false, 0);
        for (at, point) in own.all.iter().enumerate() {
            let found: Vec<&str> = lines.next().expect("a line for every point").split('\t').collect();
            let expected = expected(kernel, point);
            assert_eq!(found[..7], expected, "{compiler}: {name} at {point:?}");
            has_tier1 |= found[7] != "-1";
            match found[7] {
                "0" => assert_eq!(found[8], expected[0], "{compiler}: tier 1 of {name} at {point:?}"),
                "1" => assert_eq!((found[8], expected[2].as_str()), (expected[0].as_str(), "1"), "{name} at {point:?}"),
                "2" => assert!(found[8].split(' ').all(|value| value == "nan"), "{name} at {point:?}: {found:?}"),
                other => assert_eq!(other, "-1", "{name} at {point:?}"),
            }
            at_golden += usize::from(at < own.golden && found[7] == "0");
        }
        assert!(!has_tier1 || at_golden > 0, "{compiler}: tier 1 of {name} settles no golden value");
        settled += at_golden;
        golden += if has_tier1 { own.golden } else { 0 };
    }
    assert_eq!(lines.next(), None);
    println!("{compiler}: {} lines, tier 1 settles {settled} of {golden} golden values", output.lines().count());
}
