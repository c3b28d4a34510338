//! Cores of every kind, and what is said of what is none.

use closedform_maxima::print;

use super::*;

fn read(text: &str) -> Vec<Core> {
    let (cores, mistakes) = cores(text);
    assert!(mistakes.is_empty(), "{text}: {mistakes:?}");
    cores
}

fn body(text: &str) -> String {
    print(&read(&format!("(FPCore (x y z) {text})"))[0].definition.body)
}

#[test]
fn a_core_is_a_definition() {
    let text = "; two of them\n(FPCore speed (v [! :precision binary32 a]) :name \"A  speed\" :cite (dg-1 \"dg 2\")\n\
                :pre (and (< 0 v 10) (or (!= a 1 2) TRUE)) :spec (f x) :precision binary64\n (/ v a))\n\
                (FPCore () 1)";
    let [speed, one] = &read(text)[..] else { panic!("two") };
    assert_eq!(speed.identifier.as_deref(), Some("speed"));
    assert_eq!((speed.title.as_deref(), speed.cited.as_deref()), (Some("A speed"), Some("dg-1, \"dg 2\"")));
    assert_eq!(speed.properties, [":spec (f x)", ":precision binary64"]);
    assert_eq!(speed.definition.to_string(), "speed(v,a):=v/a");
    let conditions: Vec<String> = speed.conditions.iter().map(print).collect();
    assert_eq!(conditions, ["0<v", "v<10", "a#1 and a#2 and 1#2 or true"]);
    assert_eq!(&text[speed.definition.body.span.clone()], "(/ v a)");
    assert_eq!(one.identifier, None);
}

#[test]
fn every_operation_has_its_formula() {
    for (core, maxima) in [
        ("(+ x y z)", "x+y+z"),
        ("(- x)", "-x"),
        ("(- x y z)", "x-y-z"),
        ("(* 2 (+ x 1.5))", "2*(x+1.5)"),
        ("(/ (fabs x) -3)", "abs(x)/-3"),
        ("(sqrt (cbrt x))", "sqrt(x^(1/3))"),
        ("(pow x 3)", "x^3"),
        ("(fma x y z)", "x*y+z"),
        ("(hypot x y)", "sqrt(x^2+y^2)"),
        ("(fmin x (fmax y z))", "min(x,max(y,z))"),
        ("(fdim x y)", "max(x-y,0)"),
        ("(atan2 y x)", "atan2(y,x)"),
        ("(* PI (+ SQRT2 M_1_PI))", "%pi*(sqrt(2)+1/%pi)"),
        ("(expm1 x)", "exp(x)-1"),
        ("(- (floor x) (ceil x))", "floor(x)-ceiling(x)"),
        ("(+ (trunc x) (nearbyint x) (rint y))", "truncate(x)+round(x)+round(y)"),
        ("(- (/ x))", "-(1/x)"),
        ("(+ (fmod x y) (remainder x y))", "x-y*truncate(x/y)+(x-y*round(x/y))"),
        ("(let ([x y] [y x]) (- x y))", "y-x"),
        ("(let* ([x y] [y (+ x 1)]) (- x y))", "y-(y+1)"),
        ("(let ([t (+ x 1)]) (let ([x 2]) (* t x)))", "(x+1)*2"),
        ("(if (<= x y) (! :precision binary32 x) (digits 5 -1 10))", "if x<=y then x else 1/2"),
        ("(if (not (and (< x 1) (== y 2))) 0x1p-1 1/3)", "if not (x<1 and y=2) then 1/2 else 1/3"),
    ] {
        assert_eq!(body(core), maxima, "{core}");
    }
}

#[test]
fn names_that_mean_something_in_maxima_get_others() {
    let core = &read("(FPCore (if %pi inf x.im) (+ (+ if %pi) (+ inf x.im)))")[0];
    assert_eq!(core.definition.parameters[0], "if_");
    let printed = print(&core.definition.body);
    assert_eq!(closedform_maxima::parse_expression(&printed).as_ref(), Ok(&core.definition.body), "{printed}");
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    for (text, what, place) in [
        ("(FPCore (x) (while (< x 1) ([x x x]) x))", "`while` is no formula", "(while (< x 1) ([x x x]) x)"),
        ("(FPCore (x) (+ x w))", "`w` is no real number", "w"),
        ("(FPCore (x) (/ x INFINITY))", "`INFINITY` is no real number", "INFINITY"),
        ("(FPCore (x) (+ 1 (round x)))", "`round`, which turns from the middle", "(round x)"),
        ("(FPCore (x) (sqrt x x))", "`sqrt` does not take 2 operands", "(sqrt x x)"),
        ("(FPCore ((a 3)) 1)", "an argument that is no number", "(a 3)"),
        ("(FPCore (x x) x)", "the argument `x` occurs twice", "x"),
        ("(FPCore (x) :precision (fixed 1 2) x)", "a format that is not for real numbers", "(fixed 1 2)"),
        ("(FPCore (x) x x)", "a core has one body", "x"),
        ("(FPCore (x))", "a core without arguments or body", "(FPCore (x))"),
        ("(define f 1)", "not an FPCore", "(define f 1)"),
        ("(FPCore (x) (+ x 1)", "`(` without its counterpart", "("),
        ("(FPCore (x) (+ x 1])", "`]` without its counterpart", "]"),
        ("(FPCore (x) :name \"a x)", "string without end", "\""),
        ("(FPCore (x) ((+ x) 1))", "no operation", "(+ x)"),
        ("(FPCore (x) (let ([a]) 1))", "no binding", "[a]"),
        ("(FPCore f (x) x) (FPCore (x) (f x x))", "`f` takes 1 arguments, not 2", "(f x x)"),
        ("(FPCore (x) (if x 1))", "`if` is not written like this", "(if x 1)"),
        ("; nothing", "there is no FPCore in the file", ""),
    ] {
        let (_, mistakes) = cores(text);
        let [mistake] = &mistakes[..] else { panic!("{text}: {mistakes:?}") };
        assert!(mistake.what.starts_with(what), "{text}: {mistake:?}");
        let (start, len) = (mistake.span.offset(), mistake.span.len());
        assert_eq!(&text[start..start + len], place, "{text}");
    }
}

#[test]
fn formulas_do_not_grow_without_end() {
    let doubled: String = (0..60).map(|at| format!("(let ([x{} (+ x{at} x{at})]) ", at + 1)).collect();
    let text = format!("(FPCore (x0) {doubled}x60{})", ")".repeat(60));
    assert!(cores(&text).1[0].what.contains("too large"));
    let deep = format!("(FPCore (x) {}x{})", "(sqrt ".repeat(100_000), ")".repeat(100_000));
    assert!(cores(&deep).1[0].what.contains("nested too deep"));
    let calls: String =
        (1..60).map(|at| format!("(FPCore f{at} (x) (let ([a (f{} x)] [b (f{} x)]) 1))\n", at - 1, at - 1)).collect();
    let begun = std::time::Instant::now();
    assert!(cores(&format!("(FPCore f0 (x) x)\n{calls}")).1[0].what.contains("too large"));
    assert!(begun.elapsed().as_secs() < 20);
    let long = format!("(FPCore (x) (+ {}))", "x ".repeat(100_000));
    assert!(cores(&long).1[0].what.contains("too large"));
}

/// Formulas transcribed by hand, each into FPCore and into MPFR.
#[test]
fn cores_mean_what_they_say() {
    use rug::Float;
    use std::collections::BTreeMap;
    type Formula = fn(&[Float]) -> Float;
    let cases: [(&str, usize, Formula); 6] = [
        // Hamming, Numerical Methods for Scientists and Engineers, 1987, example 3.1
        ("(FPCore (a) (- (sqrt (+ a 1)) (sqrt a)))", 1, |p| {
            Float::with_val(300, &p[0] + 1u32).sqrt() - p[0].clone().sqrt()
        }),
        // the same, problem 3.3.4
        ("(FPCore (a) (- (cbrt (+ a 1)) (cbrt a)))", 1, |p| {
            Float::with_val(300, &p[0] + 1u32).cbrt() - p[0].clone().cbrt()
        }),
        // the quadratic formula, the same, problem 3.2.1
        ("(FPCore (a b c) (let* ([d (- (* b b) (* 4 a c))]) (/ (+ (- b) (sqrt (fmax d 0))) (* 2 a))))", 3, |p| {
            let d = Float::with_val(300, p[1].square_ref()) - Float::with_val(300, &p[0] * &p[2]) * 4u32;
            (d.max(&Float::with_val(300, 0)).sqrt() - &p[1]) / Float::with_val(300, &p[0] * 2u32)
        }),
        // the area of a triangle, Kahan, Miscalculating Area and Angles of a Needle-like Triangle, 2014
        ("(FPCore (a b c) (let ([s (/ (+ a b c) 2)]) (fabs (* s (- s a) (- s b) (- s c)))))", 3, |p| {
            let s = (Float::with_val(300, &p[0] + &p[1]) + &p[2]) / 2u32;
            let [a, b, c] = [&p[0], &p[1], &p[2]].map(|side| Float::with_val(300, &s - side));
            (s * a * b * c).abs()
        }),
        // the distance of two points, and of the nearer of two
        ("(FPCore (a b) (fmin (hypot a b) (fma a b 0x1.8p1)))", 2, |p| {
            let product = Float::with_val(300, &p[0] * &p[1]) + 3u32;
            Float::with_val(300, p[0].hypot_ref(&p[1])).min(&product)
        }),
        ("(FPCore (a b) (fdim (pow a 3) (- 1/3 (digits 5 -1 10) b)))", 2, |p| {
            let third = Float::with_val(300, 1) / 3u32 - 0.5;
            let difference: Float = Float::with_val(300, p[0].square_ref()) * &p[0] - (third - &p[1]);
            difference.max(&Float::with_val(300, 0))
        }),
    ];
    let mut state = 1_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        2.0_f64.powi((state >> 60) as i32 - 8) * (1.0 + (state >> 12) as f64 / (1_u64 << 52) as f64)
    };
    for (text, count, formula) in cases {
        let definition = &read(text)[0].definition;
        for _ in 0..200 {
            let point: Vec<Float> = (0..count).map(|_| Float::with_val(300, random())).collect();
            let inputs: BTreeMap<String, Float> =
                definition.parameters.iter().cloned().zip(point.iter().cloned()).collect();
            let found = closedform_maxima::evaluate(&definition.body, &inputs, 300).unwrap();
            let expected = formula(&point);
            let off = Float::with_val(300, &found - &expected).abs();
            assert!(off <= expected.clone().abs() * 1e-60, "{text} at {point:?}: {found}, not {expected}");
        }
    }
}
