//! Every legal name of Maxima gives Rust that reads back, with names of its own for everything.

use std::collections::BTreeSet;

use closedform_generator::pipeline::generate;
use closedform_project::contract::rust_name;
use closedform_project::family::Family;
use closedform_syntax::parse_file;

use super::values::ALGEBRA;

/// What names are put together of, as Maxima reads them: letters of all kinds, and what a backslash makes one.
const PIECES: [&str; 28] = [
    "%alpha",
    "_a",
    "__",
    "x\\-y",
    "\\-",
    "\u{fc}n\u{ef}",
    "\u{65e5}",
    "\u{393}",
    "a\\?b",
    "\\1",
    "a\\ b",
    "\\\\",
    "\\$",
    "fn",
    "Self",
    "self",
    "crate",
    "R",
    "f64",
    "batch",
    "d_",
    "tIn",
    "t_in",
    "T",
    "e1",
    "x",
    "type",
    "\\\"",
];

/// Numbers that follow from a random seed.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % end
    }

    /// Some names, all different.
    fn names(&mut self, count: usize) -> Vec<String> {
        let mut found = BTreeSet::new();
        while found.len() < count {
            let pieces = 1 + self.below(3);
            found.insert((0..pieces).map(|_| PIECES[self.below(PIECES.len())]).collect::<String>());
        }
        let mut names: Vec<String> = found.into_iter().collect();
        (0..count).for_each(|at| names.swap(at, self.below(count)));
        names
    }
}

fn is_distinct<'a>(names: impl Iterator<Item = &'a str>) -> bool {
    let mut seen = BTreeSet::new();
    { names }.all(|name| seen.insert(name))
}

#[test]
fn every_legal_name_gives_rust_that_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("names.mac");
    let mut random = Random(1);
    for _ in 0..30 {
        let names = random.names(8);
        let [f, g, h, a, b, c, d, e] = names.as_slice() else { panic!("eight names") };
        let text = format!("{f}({a},{b}) := {a}+2*{b}$ {g}: {c}^2+{d}*{e}$ {h}({c}) := [{c}/3, {d} = {c}^2, {b}-{c}]$");
        std::fs::write(&path, &text).unwrap();
        let sheet = Family::sheet(&path).unwrap();
        assert!(sheet.error.is_none() && sheet.family.contract.kernels.len() == 3, "{text}: {:?}", sheet.summary);
        let contract = &sheet.family.contract;
        let made = generate(ALGEBRA, std::slice::from_ref(&sheet.family), |_| ());
        let made = made.unwrap_or_else(|causes| panic!("{text}: {causes:?}"));
        let rust = parse_file(&made.files["names.rs"]).unwrap_or_else(|cause| panic!("{text}: {cause}"));
        assert_eq!(rust.len(), 3, "{text}");
        assert!(is_distinct(rust.iter().map(|kernel| kernel.name.as_str())), "{text}");
        for kernel in &contract.kernels {
            let inputs = contract.inputs_of(kernel);
            assert!(is_distinct(inputs.iter().map(|input| input.name.as_str())), "{text}");
            assert!(is_distinct(kernel.results.iter().map(|result| result.name.as_str())), "{text}");
            let all = inputs.iter().map(|input| &input.name).chain(kernel.results.iter().map(|result| &result.name));
            all.chain([&kernel.name]).for_each(|name| assert_eq!(rust_name(name), Ok(()), "{text}: {name}"));
        }
    }
}
