//! Every message as the compiler shows it: one file in `ui/` for each message of `#[kernel]`, named like it, and in
//! `ui/record/` for each of `#[derive(Record)]`.

#[test]
fn messages() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*.rs");
    cases.compile_fail("tests/ui/record/*.rs");
}
