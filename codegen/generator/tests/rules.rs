//! Every rule on formulas with random coefficients: where its condition holds it is used, and the steps have the value of
//! the formula at random points, within the bound in `f64`; where the condition does not hold it is refused, or decided by
//! the steps.

use closedform::Mpfr;
use closedform_generator::algebra::{Algebra, Sparse};
use closedform_generator::kernel::make;
use closedform_generator::pipeline::generate;
use closedform_generator::rust::{KernelText, ModuleText, print_module};
use closedform_generator::stable::strategy::ALL;
use closedform_maxima::Definition;
use closedform_project::family::Family;
use closedform_project::sample::sample;
use closedform_syntax::{Kernel, Precision, evaluate, parse_file};
use rug::Float;
use std::collections::{BTreeMap, BTreeSet};

const ALGEBRA: Algebra = Algebra::by::<Sparse>();

/// The precision of values, of which sums may cancel half.
const BITS: u32 = 800;

/// How often each formula is tried with other coefficients.
const TRIES: usize = 3;

/// Formulas of a, b, c and d, with a number in place of `?`, one a result.
struct Case {
    rule: &'static str,
    domain: &'static str,
    options: &'static str,
    formulas: &'static [&'static str],
}

const fn case(rule: &'static str, domain: &'static str, formulas: &'static [&'static str]) -> Case {
    Case { rule, domain, options: "few_roundings = false\n", formulas }
}

const fn with(options: &'static str, case: Case) -> Case {
    Case { options, ..case }
}

const POSITIVE: &str = "a > 0;b > 0;c > 0;d > 0";
const FEW: &str = "few_roundings = true\n";
const ONE_DIVISION: &str = "few_roundings = false\none_division = true\n";

/// Where conditions hold.
const USED: [Case; 31] = [
    case("compensated", "", &["?*a*b-c*d"]),
    case("compensated", POSITIVE, &["?*a^2*b-c"]),
    case("conjugate", "a >= 0;b > 0", &["sqrt(?*a+b)-sqrt(?*a)"]),
    case("conjugate", POSITIVE, &["(sqrt(a^2+?*b)-a)/c"]),
    case("cube-conjugate", POSITIVE, &["(?*a+b)^(1/3)-(?*a)^(1/3)"]),
    case("cube-conjugate", "a > 0;b > 0", &["(a*b)^(2/3)-?*a"]),
    case("cube-conjugate", "a < 0;b > 0", &["?*a^(1/3)+b^(1/3)"]),
    case("cube-conjugate", "", &["a^(1/3)-(?*b)^(1/3)"]),
    case("cube-quotient", "a # b", &["1/(a^(1/3)-b^(1/3))"]),
    case("cube-quotient", "a > 0;b < 0", &["c/((?*a)^(1/3)-b^(1/3))"]),
    case("differences-first", "c > 0", &["?*a/c-?*b/c-d"]),
    case("distributed", POSITIVE, &["3*a*(5*b*sqrt(c)+c)"]),
    with(FEW, case("double-double", POSITIVE, &["a*b/sqrt(?*a+b*c)"])),
    case("factored", "a # b", &["(a^3-3*b*a^2+3*b^2*a-b^3)/(a-b)"]),
    case("factored", "a > 0", &["?*a*b+?*a*c"]),
    case("monotone-newton", POSITIVE, &["positive_root(x^3+?*a*x-b,x)"]),
    case("monotone-newton", POSITIVE, &["positive_root(c*x^4+?*a*x^2-b*x-d,x)"]),
    case("fused", POSITIVE, &["(?*a+b)*(b+c)*(c+d)/((a+c)*(b+d))"]),
    case("known-sum", "b > 0;a+b > 0", &["2*a+(2*?+3)*b"]),
    case("merge-cubes", "b # 0", &["(?*a*c^2/(4*%pi^2*b))^(1/3)"]),
    case("merge-cubes", "a # 0", &["?*(a*b)^(1/3)/a"]),
    case("merge-cubes", POSITIVE, &["a^(1/3)*(b+?*c)^(2/3)"]),
    case("merge-roots", "a > 0;b > 0", &["?*sqrt(a)*sqrt(b)/a"]),
    case("merge-roots", "a+b > 0", &["?*sqrt(a+b)/(a+b)"]),
    with(ONE_DIVISION, case("one-reciprocal", POSITIVE, &["?*a/(b*c^2)", "(a+?)/(b^3*c)"])),
    case("same-sign-radicand", "a > 0;b > 0;c > 0;12*c > 4*a^2+6*a*b", &["(sqrt(9*b^2-12*a*b+4*a^2+96*c)-3*b-6*a)/?"]),
    case("sign-branch", "b > 0", &["sqrt(a^2+?*b)-a"]),
    case("sign-branch", "b > 0", &["1/(sqrt(?*a^2+b)+a)"]),
    case("sign-branch", "b # 0", &["a^(1/3)+?*b"]),
    case("through-result", POSITIVE, &["(sqrt(b^2+2*a*c)-b)/c", "sqrt(b^2+2*a*c)-b"]),
    case("certified", POSITIVE, &["?+max(a,2*b)"]),
];

/// Where they do not: what the rule would make of these is wrong, cancels, or is not worth it.
const REFUSED: [Case; 31] = [
    // the terms agree in sign
    case("compensated", POSITIVE, &["?*a*b+c*d"]),
    // the terms of the root's sum agree in sign
    case("conjugate", "a >= 0;b > 0", &["sqrt(?*a+b)+sqrt(?*a)"]),
    // both terms may vanish together, and with them the sum below the bar
    case("conjugate", "a >= 0;b >= 0", &["sqrt(?*a)+sqrt(b)"]),
    // the terms agree in sign
    case("cube-conjugate", POSITIVE, &["(?*a+b)^(1/3)+(?*a)^(1/3)"]),
    case("cube-conjugate", "a < 0;b < 0", &["?*a^(1/3)+b^(1/3)"]),
    // the difference stands below the bar, which canonical forms free of it
    case("cube-conjugate", POSITIVE, &["1/((a+?*b)^(1/3)-a^(1/3))"]),
    // three terms, two of which stand against one
    case("cube-conjugate", POSITIVE, &["a^(1/3)+b^(1/3)-?*c^(1/3)"]),
    // the terms agree in sign
    case("cube-quotient", "a > b;b > 0", &["1/(a^(1/3)-b^(1/3))"]),
    // these three terms are no squares with a product
    case("cube-quotient", POSITIVE, &["a^(2/3)-?*(a*b)^(1/3)+b^(2/3)+c"]),
    // h is left of a + h and b + h
    case("differences-first", "c > 0", &["5*a/c-7*b/c-d"]),
    // the factor has either sign, and so have the terms: their sum may be of terms of other signs than that of the formula
    case("distributed", "b > 0;c > 0", &["3*(a-d)*(5*b*sqrt(c)+c)"]),
    // a bound that is small enough
    case("double-double", POSITIVE, &["a*b/sqrt(?*a+b*c)"]),
    case("factored", POSITIVE, &["a^2+?*b"]),
    // no contract asks for few roundings, and they are few
    case("fused", POSITIVE, &["?*a+b*c"]),
    // the domain does not give the sign of the sum
    case("known-sum", "b > 0;a-b > 0", &["?*a+7*b"]),
    case("known-sum", "b > 0", &["?*a+7*b"]),
    case("known-sum", "b > 0;a+b # 0", &["?*a+7*b"]),
    // each root stands alone
    case("merge-cubes", POSITIVE, &["a^(1/3)+?*b^(1/3)"]),
    // a square root is no cube root
    case("merge-cubes", POSITIVE, &["?*sqrt(a)*sqrt(b)"]),
    // each root stands alone
    case("merge-roots", POSITIVE, &["sqrt(?*a)+sqrt(b)"]),
    // below the root of a quotient, a would lose its sign
    case("merge-roots", "a*b > 0;a # 0", &["?*sqrt(a*b)/a"]),
    // no contract asks for it
    case("one-reciprocal", POSITIVE, &["?*a/(b*c^2)", "(a+?)/(b^3*c)"]),
    // there is but one quotient
    with(ONE_DIVISION, case("one-reciprocal", POSITIVE, &["?*a/(b*c^2)", "a+b"])),
    // the norm is positive: a^2 - n would cancel
    case("same-sign-radicand", "a > 0;b > 0;a^2 > ?*b", &["a-sqrt(a^2-?*b)"]),
    // the root has a coefficient: its radicand is another part of the norm
    case("same-sign-radicand", "a > 0;b > 0", &["a*sqrt(b^2-2*a*b+3*a^2)-b*a-?*a"]),
    // the sign is known
    case("sign-branch", "a > 0;b > 0", &["sqrt(a^2+?*b)-a"]),
    case("sign-branch", "a < 0;b > 0", &["sqrt(a^2+?*b)-a"]),
    // the root that they share is no square root
    case("through-result", POSITIVE, &["((b^3+2*a*c)^(1/3)-b)/c", "(b^3+2*a*c)^(1/3)-b"]),
    // another root
    case("through-result", POSITIVE, &["(sqrt(b^2+?*a*c)-b)/c", "sqrt(b^2+?*a*d)-b"]),
    // no sum of the direct form cancels and there is nothing to take from it
    case("through-result", POSITIVE, &["(sqrt(b^2+?*a*c)-b)/c", "a+b"]),
    case("certified", POSITIVE, &["a*b-?*c*d"]),
];

/// Small numbers without a pattern: Knuth's linear congruential generator MMIX.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        2 + (self.0 >> 33) % 11
    }
}

impl Case {
    /// The family of the formulas, every `?` the same number.
    fn family(&self, number: u64) -> Family {
        let number = number.to_string();
        let conditions = self.domain.split(';').filter(|text| !text.is_empty());
        let domain: Vec<String> = conditions.map(|text| text.replace('?', &number)).collect();
        let inputs: String =
            ["a", "b", "c", "d"].map(|name| format!("{name} = {{ name = \"{name}\", unit = \"1\" }}\n")).concat();
        let returns = if self.formulas.len() > 1 { "returns = \"Made\"\n" } else { "" };
        let results: String = (1..=self.formulas.len())
            .map(|at| format!("[[kernel.result]]\nname = \"r{at}\"\nworksheet = \"f{at}\"\nunit = \"1\"\n"))
            .collect();
        let contract = format!(
            "[family]\ntitle = \"Made\"\n[inputs]\n{inputs}[[kernel]]\nname = \"made\"\ndoc = \"Made.\"\n\
             inputs = [\"a\", \"b\", \"c\", \"d\"]\ndomain = {domain:?}\n{returns}{}{results}",
            self.options
        );
        let formula = |(at, text): (usize, &&str)| format!("f{}(a,b,c,d):={}$\n", at + 1, text.replace('?', &number));
        let worksheet: String = self.formulas.iter().enumerate().map(formula).collect();
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("made.toml"), contract).unwrap();
        std::fs::write(folder.path().join("made.mac"), worksheet).unwrap();
        Family::from_worksheet(&folder.path().join("made.mac")).unwrap()
    }
}

/// The kernel of a family and its text, without a proof: what rules do wrong is left in it. What has no stable form goes
/// through the pipeline, which takes it as it is written.
fn kernel_of(family: &Family) -> (Kernel, String) {
    let contract = family.completed(&family.contract.kernels[0]);
    let text = match make(ALGEBRA, &family.contract, &contract, &references(family)) {
        Ok(made) => text_of(&made),
        Err(_) => generate(ALGEBRA, std::slice::from_ref(family), |_| ()).unwrap().files.remove("made.rs").unwrap(),
    };
    (parse_file(&text).unwrap_or_else(|cause| panic!("{cause}\n{text}")).remove(0), text)
}

fn text_of(kernel: &KernelText) -> String {
    let kernels = std::slice::from_ref(kernel);
    print_module(&ModuleText { family: "made", title: "Made", source: "", made_from: "made.mac", kernels })
}

fn references(family: &Family) -> Vec<Definition> {
    family.results().map(|(.., reference)| reference.clone()).collect()
}

fn points(family: &Family) -> Vec<Vec<f64>> {
    let contract = &family.contract.kernels[0];
    let contract = &family.completed(contract);
    let points = sample(&contract.domain, &family.contract.inputs_of(contract), 60, 7).unwrap();
    // what over- or underflows on the way is for other tests
    let moderate = |value: &f64| *value == 0.0 || (1e-12..1e12).contains(&value.abs());
    points.into_iter().filter(|point| point.iter().all(moderate)).collect()
}

/// The value of a reference, all of whose digits are right at so many bits unless it is zero.
fn exact(reference: &Definition, point: &[f64]) -> Option<Float> {
    let inputs: BTreeMap<String, Float> =
        reference.parameters.iter().cloned().zip(point.iter().map(|value| Float::with_val(BITS, *value))).collect();
    closedform_maxima::evaluate(&reference.body, &inputs, BITS).ok().filter(Float::is_finite)
}

/// How far a number is from the exact one, in units of its last place in `f64`.
fn ulp(found: &Float, exact: &Float) -> f64 {
    let difference = Float::with_val(BITS, found - exact).abs();
    match exact.get_exp() {
        Some(exponent) => (difference >> (exponent - 53)).to_f64(),
        None => {
            if difference.is_zero() {
                0.0
            } else {
                f64::INFINITY
            }
        }
    }
}

/// The values of the steps are those of the formulas, and in `f64` they are within the bounds that the text states.
fn has_the_values(kernel: &Kernel, text: &str, family: &Family) -> Result<usize, String> {
    let mut checked = 0;
    for point in points(family) {
        let numbers: Vec<Mpfr> = point.iter().map(|value| Mpfr::new(BITS, *value)).collect();
        let steps = evaluate(kernel, &numbers);
        let rounded = evaluate(kernel, &point);
        for (at, reference) in references(family).iter().enumerate() {
            let Some(exact) = exact(reference, &point) else { continue };
            // cancelled to nothing: the digits that are left are none
            if exact.clone().abs() < 1e-100 {
                continue;
            }
            let off = ulp(&steps[at].0, &exact);
            if off > 1e-20 && !(root_is_iterated(text) && off < 0.51) {
                return Err(format!("{} is off by {off} ulp in its steps at {point:?}", reference.name));
            }
            let off = ulp(&Float::with_val(BITS, rounded[at]), &exact);
            let bound = kernel.meta.results[at].bound.unwrap();
            if kernel.meta.precision == Precision::Double && off > bound {
                return Err(format!("{} is off by {off} ulp, more than {bound}, at {point:?}", reference.name));
            }
            checked += 1;
        }
    }
    Ok(checked)
}

/// An iteration ends where `f64` would.
fn root_is_iterated(text: &str) -> bool {
    text.contains("positive_root([")
}

fn uses(kernel: &Kernel, rule: &str) -> bool {
    kernel.meta.rules.iter().any(|name| name == rule)
}

/// What is wrong with the rules in these cases.
fn complaints(cases: &[Case], used: bool) -> Vec<String> {
    let (mut complaints, mut numbers) = (Vec::new(), Numbers(1));
    for case in cases {
        for _ in 0..TRIES {
            let family = case.family(numbers.next());
            let (kernel, text) = kernel_of(&family);
            let formulas: Vec<String> = references(&family).iter().map(ToString::to_string).collect();
            let mut complain = |what: String| complaints.push(format!("{}, {formulas:?}: {what}\n{text}", case.rule));
            if uses(&kernel, case.rule) != used {
                complain(format!("the rule is {}", if used { "not used" } else { "used" }));
            }
            match has_the_values(&kernel, &text, &family) {
                Ok(checked) if checked < 10 => complain(format!("only {checked} values")),
                Ok(_) => {}
                Err(what) => complain(what),
            }
        }
    }
    complaints
}

#[test]
fn rules_are_used_where_their_conditions_hold() {
    let complaints = complaints(&USED, true);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    let named: BTreeSet<&str> = USED.iter().map(|case| case.rule).collect();
    assert_eq!(named, ALL.iter().map(|rule| rule.name).collect(), "every rule has a case");
}

#[test]
fn rules_are_refused_where_their_conditions_do_not_hold() {
    let complaints = complaints(&REFUSED, false);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    let named: BTreeSet<&str> = REFUSED.iter().map(|case| case.rule).chain(["monotone-newton"]).collect();
    assert_eq!(named, ALL.iter().map(|rule| rule.name).collect(), "every rule has a counterexample");
}

/// The coefficients change sign never, twice, or nobody knows: there may be no root, or several.
#[test]
fn a_root_that_is_not_the_only_one_is_refused() {
    for (domain, polynomial) in [
        (POSITIVE, "x^3+a*x+b"),
        (POSITIVE, "x^2-3*a*x+b"),
        (POSITIVE, "x^3-a*x^2+b*x-c"),
        ("a > 0", "x^3+a*x-b"),
        (POSITIVE, "b-a*x"),
    ] {
        let formula = Box::leak(format!("positive_root({polynomial},x)").into_boxed_str());
        let formulas: &'static [&'static str] = Box::leak(Box::new([&*formula]));
        let family = case("monotone-newton", domain, formulas).family(2);
        let contract = family.completed(&family.contract.kernels[0]);
        let made = make(ALGEBRA, &family.contract, &contract, &references(&family));
        let turned = polynomial == "b-a*x";
        assert_eq!(made.is_ok(), turned, "{polynomial}");
    }
}
