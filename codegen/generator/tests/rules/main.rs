//! Every rule on formulas with random coefficients: where its condition holds it is used, and the steps have the value of
//! the formula at random points, within the bound in `f64`; where the condition does not hold it is refused, or decided by
//! the steps.

#[macro_use]
mod cases;
mod steps;

use cases::{Case, POSITIVE, REFUSED, USED, case};
use closedform::Mpfr;
use closedform_generator::algebra::{Algebra, Sparse};
use closedform_generator::kernel::make;
use closedform_generator::pipeline::generate;
use closedform_generator::program::{Cost, cost};
use closedform_generator::rust::{KernelText, ModuleText, print_module};
use closedform_generator::stable::strategy::ALL;
use closedform_maxima::Definition;
use closedform_project::family::Family;
use closedform_project::sample::sample;
use closedform_syntax::{Kernel, Precision, evaluate, parse_file};
use rug::Float;
use std::collections::BTreeMap;

const ALGEBRA: Algebra = Algebra::by::<Sparse>();

/// The precision of values, of which sums may cancel half.
const BITS: u32 = 800;

/// The rules of passes, which keep the signs that forms decide.
const PASSES: [&str; 4] = ["distributed", "double-double", "fused", "one-reciprocal"];

/// How often each formula is tried with other coefficients.
const TRIES: usize = 3;

/// Small numbers without a pattern: Knuth's linear congruential generator MMIX.
struct Numbers(u64);

impl Numbers {
    /// Those of a case do not depend on the others.
    fn of(case: &Case) -> Self {
        Self(case.formulas.concat().bytes().map(u64::from).sum())
    }

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

/// The kernel of a family, its text and its steps, without a proof: what rules do wrong is left in it. What has no stable
/// form goes through the pipeline, which takes it as it is written.
fn kernel_of(family: &Family) -> (Kernel, String, Option<KernelText>) {
    let contract = family.completed(&family.contract.kernels[0]);
    let made = make(ALGEBRA, &family.contract, &contract, &references(family));
    let text = match &made {
        Ok(made) => text_of(made),
        Err(_) => generate(ALGEBRA, std::slice::from_ref(family), |_, _| ()).unwrap().files.remove("made.rs").unwrap(),
    };
    let kernel = parse_file(&text).unwrap_or_else(|cause| panic!("{cause}\n{text}")).remove(0);
    (kernel, text, made.ok())
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
    let mut points = sample(&contract.domain, &family.contract.inputs_of(contract), 60, 7).unwrap();
    let corners = points.iter().take(2).flat_map(|point| (1..16).map(|zeros| with_zeros(point, zeros)));
    let corners: Vec<Vec<f64>> = corners.filter(|corner| contract.domain.holds(corner)).collect();
    points.extend(corners);
    // what over- or underflows on the way is for other tests
    let moderate = |value: &f64| *value == 0.0 || (1e-12..1e12).contains(&value.abs());
    points.into_iter().filter(|point| point.iter().all(moderate)).collect()
}

/// A point with zeros in place of the inputs whose bits are set: terms vanish together there.
fn with_zeros(point: &[f64], zeros: u32) -> Vec<f64> {
    point.iter().enumerate().map(|(at, &value)| if zeros >> at & 1 == 1 { 0.0 } else { value }).collect()
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

/// Whether a distance is no larger than another: no number is not.
fn is_within(distance: f64, limit: f64) -> bool {
    distance <= limit
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
            // cancelled to nothing: the digits that are left are none; a zero is one
            if !exact.is_zero() && exact.clone().abs() < 1e-100 {
                continue;
            }
            let off = ulp(&steps[at].0, &exact);
            if !is_within(off, if root_is_iterated(text) { 1e-9 } else { 1e-20 }) {
                return Err(format!("{} is off by {off} ulp in its steps at {point:?}", reference.name));
            }
            let off = ulp(&Float::with_val(BITS, rounded[at]), &exact);
            let bound = kernel.meta.results[at].bound.unwrap();
            if kernel.meta.precision == Precision::Double && !is_within(off, bound) {
                return Err(format!("{} is off by {off} ulp, more than {bound}, at {point:?}", reference.name));
            }
            checked += 1;
        }
    }
    Ok(checked)
}

/// An iteration ends where `f64` would: the correction after it squares an error of some 2^-53, if its slope is right.
fn root_is_iterated(text: &str) -> bool {
    text.contains("positive_root([")
}

fn uses(kernel: &Kernel, rule: &str) -> bool {
    kernel.meta.rules.iter().any(|name| name == rule)
}

/// The largest bound of a result, and how many operations all of them take.
fn worth(kernel: &Kernel, made: Option<&KernelText>) -> (f64, usize) {
    let bound = kernel.meta.results.iter().filter_map(|result| result.bound).fold(0.0, f64::max);
    let Cost { additions, multiplications, divisions, roots, double_double } =
        made.map(|made| cost(&made.graph, &made.program.outputs)).unwrap_or_default();
    (bound, additions + multiplications + divisions + roots + double_double)
}

/// What is wrong with a rule in a case where it is used, or where it is not.
fn complaints(case: &Case, used: bool) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut numbers = Numbers::of(case);
    for _ in 0..TRIES {
        let family = case.family(numbers.next());
        let (kernel, text, made) = kernel_of(&family);
        let formulas: Vec<String> = references(&family).iter().map(ToString::to_string).collect();
        let mut complain = |what: String| complaints.push(format!("{}, {formulas:?}: {what}\n{text}", case.rule));
        // what the kernel decides by a sign has a form for either
        let decided = !used && case.rule != "sign-branch" && uses(&kernel, "sign-branch");
        if uses(&kernel, case.rule) != used && !decided {
            complain(format!("the rule is {}", if used { "not used" } else { "used" }));
        }
        if used && case.rule != "sign-branch" && !PASSES.contains(&case.rule) && uses(&kernel, "sign-branch") {
            complain("a sign is decided that is known".to_owned());
        }
        let worth = worth(&kernel, made.as_ref());
        if worth.0 > case.worth.0 || worth.1 > case.worth.1 {
            complain(format!("its bound and operations are {worth:?}, not {:?}", case.worth));
        }
        if let Some(made) = &made {
            let points = points(&family);
            let wrong = points.iter().find_map(|point| steps::wrong_sign(&made.graph, &made.program.outputs, point));
            wrong.into_iter().chain(steps::turned(&made.graph, &made.program.outputs)).for_each(&mut complain);
        }
        if let Err(refusals) = closedform_bounds::check(&kernel) {
            let refusals: Vec<String> = refusals.iter().map(ToString::to_string).collect();
            complain(format!("its bound is not proved: {}", refusals.join(", ")));
        }
        match has_the_values(&kernel, &text, &family) {
            Ok(checked) if checked < 10 => complain(format!("only {checked} values")),
            Ok(_) => {}
            Err(what) => complain(what),
        }
    }
    complaints
}

/// A rule is used where its condition holds, and refused where it does not.
fn holds(rule: &str) {
    let about = |cases: &'static [Case]| cases.iter().filter(|case| case.rule == rule);
    assert!(about(&USED).count() > 0, "{rule} has no case");
    assert!(about(&REFUSED).count() > 0 || rule == "monotone-newton", "{rule} has no counterexample");
    let used = about(&USED).flat_map(|case| complaints(case, true));
    let refused = about(&REFUSED).flat_map(|case| complaints(case, false));
    let complaints: Vec<String> = used.chain(refused).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// A test for each rule, of its name, and one that none is left out.
macro_rules! a_test_for_each_rule {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            holds(&stringify!($name).replace('_', "-"));
        })*

        #[test]
        fn every_rule_has_a_test() {
            let tested = [$(stringify!($name)),*].map(|name| name.replace('_', "-"));
            assert_eq!(tested.to_vec(), ALL.map(|rule| rule.name).to_vec());
            let known = |case: &Case| tested.iter().any(|name| name == case.rule);
            assert!(USED.iter().chain(&REFUSED).all(known), "a case of no rule");
        }
    };
}

for_each_rule!(a_test_for_each_rule);

/// The coefficients change sign never, twice, or nobody knows, or one of the ends may be 0: there may be no root, or several.
#[test]
fn monotone_newton_and_certified_refuse_a_root_that_is_not_the_only_one() {
    for (domain, polynomial) in [
        (POSITIVE, "x^3+a*x+b"),
        (POSITIVE, "x^2-3*a*x+b"),
        (POSITIVE, "x^3-a*x^2+b*x-c"),
        ("a > 0", "x^3+a*x-b"),
        ("a > 0;b >= 0", "x^3+a*x-b"),
        ("a >= 0;b > 0", "a*x-b"),
        (POSITIVE, "b-a*x"),
    ] {
        let formula = Box::leak(format!("positive_root({polynomial},x)").into_boxed_str());
        let formulas: &'static [&'static str] = Box::leak(Box::new([&*formula]));
        let family = case("monotone-newton", domain, formulas).family(2);
        let contract = family.completed(&family.contract.kernels[0]);
        let made = make(ALGEBRA, &family.contract, &contract, &references(&family));
        let turned = polynomial == "b-a*x" && domain == POSITIVE;
        assert_eq!(made.is_ok(), turned, "{polynomial}");
        // nor is it left to certified arithmetic
        let generated = generate(ALGEBRA, std::slice::from_ref(&family), |_, _| ());
        assert_eq!(generated.is_ok(), turned, "{polynomial}");
    }
}

/// Double-double holds what powers of the root cancel, but not what the terms of a coefficient do.
#[test]
fn monotone_newton_takes_the_exact_residual_where_a_coefficient_may_cancel() {
    for (case, exact) in
        USED.iter().filter(|case| case.rule == "monotone-newton").zip([false, false, false, false, false, true])
    {
        let (.., text, _) = kernel_of(&case.family(3));
        let residuals = ["residual!(", "compensated!("].map(|name| text.contains(name));
        assert_eq!(residuals, [!exact, exact], "{text}");
    }
}
