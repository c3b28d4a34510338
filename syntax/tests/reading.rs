//! What is read from a kernel that has no mistakes.

use closedform_syntax::{BinaryOp, Condition, Expr, Kernel, Operations, Output, operations, parse_file};

const SOURCE: &str = r#"
    /// Two
    /// lines.
    ///
    /// And more.
    #[kernel(
        family = "five_segment",
        maxima = "rampFn(x,y) := ..",
        rules("conjugate"),
        bound(t1 = 4, a1 = 6.5),
        results(t1(worksheet = "t1Fn", unit = "s")),
    )]
    pub(crate) fn ramp(
        #[input(maxima = "xIn", unit = "m", typical(1e-3, 2.0))] x: f64,
        y: f64,
    ) -> Ramp {
        require!(x > 0.0, "xIn > 0");
        require!(!(x - (y + 1.0) == -x * 2.0) && (x < y || y <= 0.5 / (x / y)));
        let t1 = if x != y { sqrt(x) } else { abs(-y) + PI };
        let root = positive_root([-x, 0.0, y]);
        Ramp { t1, a1: compensated!(t1 * root - y) / root }
    }
"#;

fn ramp() -> Kernel {
    parse_file(SOURCE).expect("no mistakes").remove(0)
}

#[test]
fn the_attribute_is_read() {
    let meta = ramp().meta;
    assert_eq!(meta.family.as_deref(), Some("five_segment"));
    assert_eq!(meta.maxima.as_deref(), Some("rampFn(x,y) := .."));
    assert_eq!((meta.latex, meta.source), (None, None));
    assert_eq!(meta.summary, "Two lines.");
    assert_eq!(meta.rules, ["conjugate"]);
    let [t1, a1] = &meta.results[..] else { panic!("two results") };
    assert_eq!((t1.worksheet.as_deref(), t1.unit.as_deref(), t1.bound), (Some("t1Fn"), Some("s"), Some(4.0)));
    assert_eq!((a1.worksheet.as_deref(), a1.unit.as_deref(), a1.bound), (None, None, Some(6.5)));
}

#[test]
fn inputs_are_read() {
    let [x, y] = &ramp().inputs[..] else { panic!("two inputs") };
    assert_eq!((x.maxima.as_deref(), x.unit.as_deref(), x.typical), (Some("xIn"), Some("m"), Some((1e-3, 2.0))));
    assert_eq!((y.maxima.as_deref(), y.unit.as_deref(), y.typical), (None, None, None));
}

#[test]
fn a_condition_prints_with_the_parentheses_it_needs() {
    let texts: Vec<_> = ramp().requires.into_iter().map(|require| require.text).collect();
    assert_eq!(texts, ["xIn > 0", "!(x - (y + 1.0) == -x * 2.0) && (x < y || y <= 0.5 / (x / y))"]);
}

#[test]
fn names_resolve_to_slots() {
    let kernel = ramp();
    let Output::Struct { name, fields } = &kernel.output else { panic!("a struct") };
    assert_eq!(name, "Ramp");
    assert!(matches!(&fields[0].1, Expr::Name(t1) if t1.slot == 2));
    let Expr::Binary { op: BinaryOp::Div, right, .. } = &fields[1].1 else { panic!("a quotient") };
    assert!(matches!(&**right, Expr::Name(root) if root.slot == 3));
    assert!(matches!(&kernel.requires[1].condition, Condition::And(..)));
}

#[test]
fn operations_are_counted() {
    let (compensated, compensated_expressions) = (2, 1);
    let expected =
        Operations { add: 1, div: 1, sqrt: 1, compensated, compensated_expressions, root: 1, ..Operations::default() };
    assert_eq!(operations(&ramp()), expected);
}

#[test]
fn a_file_without_kernels_has_none() {
    assert!(parse_file("fn f() {} mod m;").expect("Rust").is_empty());
    assert!(parse_file("fn f( {}").is_err());
}

#[test]
fn kernels_are_found_wherever_they_stand() {
    let source = r#"#!/usr/bin/env rust
        //! Kernels.
        use closedform::kernel;
        #[kernel] fn one(x: f64) -> f64 { x }
        mod a { mod b { /** two */ #[inline] #[closedform::kernel()] pub(crate) fn two(x: f64) -> f64 { x } } }
        fn main() { #[kernel] fn three(x: f64) -> f64 { x } }
        impl S { fn f(&self) { if true { #[kernel] fn four(x: f64) -> f64 { x } } } }
        kept! { #[kernel] fn five(x: f64) -> f64 { x } }
        macro_rules! made { ($name:ident) => { #[kernel] fn $name(x: f64) -> f64 { x } } }
        #[kernel] mod no_function {}
        #[kernel] struct NoFunction { f: fn(f64) -> f64 }
        #[inline] fn no_kernel(x: f64) -> f64 { "} #[kernel] fn f() {".len() as f64 }
    "#;
    let names: Vec<_> = parse_file(source).expect("kernels").into_iter().map(|k| k.name.to_string()).collect();
    assert_eq!(names, ["one", "two", "three", "four", "five"]);
}
