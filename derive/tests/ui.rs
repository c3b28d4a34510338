//! Every message as the compiler shows it: one file in `ui/` for each, named like the message.

#[test]
fn messages() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
