//! Proofs: the texts that are generated are proved, and none that differs from them in a sign, a number or a name.

use super::values::ALGEBRA;
use closedform_generator::kernel::{ProofError, prove};
use closedform_generator::pipeline::{generate, generate_what_can_be};
use closedform_maxima::Definition;
use closedform_project::family::Family;
use closedform_syntax::{Kernel, parse_file};

/// A domain and a formula of x and y, which is generated with the precision.
const FORMULAS: [(&str, &str, &str); 5] = [
    ("\"x > 0\", \"y > 0\"", "(x^2-y^2)/(x+3*y)", "double"),
    ("\"y > 0\"", "sqrt(x^2+y)-x", "double"),
    ("\"x >= 0\", \"y > x\"", "sqrt(y)-sqrt(y-x)", "double"),
    ("\"x > y^2\"", "x-y^2", "double"),
    ("\"x > 0\", \"y > 0\"", "1+max(x,2*y)", "certified"),
];

/// The family of one formula, and its generated text.
fn made(domain: &str, formula: &str) -> (Family, String) {
    let folder = tempfile::tempdir().unwrap();
    let contract = format!(
        "[family]\ntitle = \"One\"\n[inputs]\nx = {{ name = \"x\", unit = \"1\" }}\ny = {{ name = \"y\", unit = \"1\" }}\n\
         [[kernel]]\nname = \"one\"\ndoc = \"One.\"\ninputs = [\"x\", \"y\"]\ndomain = [{domain}]\n\
         [[kernel.result]]\nname = \"one\"\nworksheet = \"f\"\nunit = \"1\"\n"
    );
    std::fs::write(folder.path().join("made.toml"), contract).unwrap();
    std::fs::write(folder.path().join("made.mac"), format!("f(x,y):={formula}$\n")).unwrap();
    let family = Family::from_worksheet(&folder.path().join("made.mac")).unwrap();
    let mut generated = generate(ALGEBRA, std::slice::from_ref(&family), |_, _| ()).unwrap();
    (family, generated.files.remove("made.rs").unwrap())
}

fn proof(family: &Family, kernel: &Kernel) -> Result<(), ProofError> {
    let contract = &family.contract.kernels[0];
    let references: Vec<Definition> = family.results().map(|(.., reference)| reference.clone()).collect();
    prove(ALGEBRA, kernel, &family.completed(contract), &references)
}

/// Everything of a text in place of which something else could stand.
const MISTAKES: [(&str, &str); 14] = [
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " + "),
    (" / ", " * "),
    (" > ", " < "),
    (" >= ", " <= "),
    ("2.0", "3.0"),
    ("3.0", "2.0"),
    ("sqrt(", "abs("),
    ("max(", "min("),
    ("(x", "(y"),
    (" y", " x"),
    ("-y", "-x"),
    ("1.0", "2.0"),
];

/// The texts with one mistake in the function, in a line that has this part, and what it is.
fn doctored(text: &str, part: &str) -> Vec<(String, String)> {
    let start = text.find(") -> f64 {").unwrap();
    let (head, body) = text.split_at(start);
    let mut found = Vec::new();
    for (right, wrong) in MISTAKES {
        for (at, _) in body.match_indices(right) {
            let line = body[..at].matches('\n').count();
            // the words of a condition are no part of the function
            let quoted = body[..at].matches('"').count() % 2 == 1;
            if quoted || !body.lines().nth(line).is_some_and(|line| line.contains(part)) {
                continue;
            }
            let mistaken = format!("{head}{}{wrong}{}", &body[..at], &body[at + right.len()..]);
            found.push((format!("line {line}: `{right}` for `{wrong}`"), mistaken));
        }
    }
    found
}

#[test]
fn what_is_generated_is_proved_and_nothing_else() {
    for (domain, formula, precision) in FORMULAS {
        let (family, text) = made(domain, formula);
        assert_eq!(text.contains("\"certified\""), precision == "certified", "{text}");
        let kernel = parse_file(&text).unwrap().remove(0);
        proof(&family, &kernel).unwrap_or_else(|cause| panic!("{formula}: {cause}\n{text}"));
        let mut refused = 0;
        for (what, doctored) in doctored(&text, "") {
            let Ok(mut kernels) = parse_file(&doctored) else { continue };
            assert!(proof(&family, &kernels.remove(0)).is_err(), "{formula}: {what} is proved in\n{text}");
            refused += 1;
        }
        assert!(refused > 3, "{formula}: {refused} texts");
    }
}

/// Two formulas of a contract, one of which has a domain without points.
fn one_of_two() -> Family {
    let folder = tempfile::tempdir().unwrap();
    let kernel = |name: &str, domain: &str| {
        format!(
            "[[kernel]]\nname = \"{name}\"\ndoc = \"One.\"\ninputs = [\"x\"]\ndomain = [{domain}]\n\
             [[kernel.result]]\nname = \"{name}\"\nworksheet = \"{name}\"\nunit = \"1\"\n"
        )
    };
    let contract = "[family]\ntitle = \"Two\"\n[inputs]\nx = { name = \"x\", unit = \"1\" }\n".to_owned();
    let contract = contract + &kernel("empty", "\"x > 1\", \"x < 1\"") + &kernel("fine", "\"x > 0\"");
    std::fs::write(folder.path().join("made.toml"), contract).unwrap();
    std::fs::write(folder.path().join("made.mac"), "empty(x):=x+1$\nfine(x):=x+2$\n").unwrap();
    Family::from_worksheet(&folder.path().join("made.mac")).unwrap()
}

#[test]
fn what_cannot_be_made_is_left_out_where_that_is_wanted() {
    let family = one_of_two();
    let families = std::slice::from_ref(&family);
    let causes = generate(ALGEBRA, families, |_, _| ()).unwrap_err();
    assert_eq!(causes.len(), 1, "{causes:?}");
    let mut told = Vec::new();
    let generated =
        generate_what_can_be(ALGEBRA, families, |name, place| told.push(format!("{place}: {name}"))).unwrap();
    let made: Vec<&str> = generated.kernels.iter().map(|made| made.kernel.as_str()).collect();
    let refused: Vec<&str> = generated.refused.iter().map(|refused| refused.kernel.as_str()).collect();
    assert_eq!((made, refused), (vec!["made::fine"], vec!["made::empty"]));
    assert!(generated.files["made.rs"].contains("fn fine(") && !generated.files["made.rs"].contains("fn empty("));
    // once to be made; then to be proved, beside the other one and alone
    let about = |text: &str| told.iter().filter(|told| told.ends_with(text)).count();
    assert_eq!((about("made.mac:1:1: made::empty"), about("made.mac:2:1: made::fine")), (1, 3), "{told:?}");
    // of nothing but what cannot be made there is nothing
    let empty = family.without(&["fine".to_owned()].into());
    assert_eq!(generate_what_can_be(ALGEBRA, &[empty], |_, _| ()).unwrap_err().len(), 1);
}

/// The step of Newton's method may be another one: the root stays where it is, and how near the result is to it is for the
/// proof of the bound to say. The polynomials of iteration and remainder may not.
#[test]
fn a_root_is_proved_by_its_polynomials() {
    let (family, text) = made("\"x > 0\", \"y > 0\"", "positive_root(z^3+x*z-y,z)");
    assert!(proof(&family, &parse_file(&text).unwrap().remove(0)).is_ok());
    for part in ["positive_root([", "residual!("] {
        let mistakes = doctored(&text, part);
        assert!(!mistakes.is_empty(), "{text}");
        for (what, doctored) in mistakes {
            let Ok(mut kernels) = parse_file(&doctored) else { continue };
            assert!(proof(&family, &kernels.remove(0)).is_err(), "{what} is proved in\n{text}");
        }
    }
}

#[test]
fn conditions_are_proved_besides_values() {
    let (family, text) = made("\"x > 0\", \"y > x\"", "x*y");
    let kernel = parse_file(&text).unwrap().remove(0);
    for at in 0..kernel.requires.len() {
        let mut without = kernel.clone();
        without.requires.remove(at);
        assert!(matches!(proof(&family, &without), Err(ProofError::Domain { .. })), "condition {at}");
    }
    let mut more = kernel.clone();
    let extra = made("\"x > 5\", \"y > x\"", "x*y").1;
    more.requires.push(parse_file(&extra).unwrap().remove(0).requires.remove(0));
    assert!(matches!(proof(&family, &more), Err(ProofError::Domain { .. })));
    let mut implied = kernel.clone();
    let weaker = made("\"y > 0\", \"x > 0\"", "x*y").1;
    implied.requires.push(parse_file(&weaker).unwrap().remove(0).requires.remove(0));
    assert!(proof(&family, &implied).is_ok(), "what follows may be required besides");
}

#[test]
fn conditions_of_a_box_prove_what_a_formula_needs() {
    let doppler = "-y*(3314/10+6/10*x)/(3314/10+6/10*x+y)^2";
    let within = "\"x >= -30\", \"x <= 50\", \"y >= -100\", \"y <= 100\"";
    let (family, text) = made(within, doppler);
    let kernel = parse_file(&text).unwrap().remove(0);
    let required: Vec<&str> = kernel.requires.iter().map(|require| require.text.as_str()).collect();
    assert_eq!(required, ["x >= -30", "x <= 50", "y >= -100", "y <= 100"], "nothing is added\n{text}");
    assert!(proof(&family, &kernel).is_ok() && !text.contains("certified"), "{text}");
    // as far as zero, and a point beyond
    let (_, text) = made(&within.replace("y >= -100", "y > -3134/10"), doppler);
    assert!(!text.contains("# 0"), "{text}");
    let (_, text) = made(&within.replace("y >= -100", "y >= -3134/10"), doppler);
    assert!(text.contains("# 0"), "{text}");
}
