//! The proofs prove what they say: a text with one wrong side of an `if`, or one wrong condition, is refused.

use closedform::Mpfr;
use closedform_generator::kernel::{ProofError, prove};
use closedform_generator::pipeline::{generate, unproved};
use closedform_maxima::Definition;
use closedform_project::contract::KernelContract;
use closedform_project::family::{Family, families};
use closedform_symbolica::ALGEBRA;
use closedform_syntax::{BinaryOp, Condition, Expr, Kernel, Output, Relation, parse_file, violated};
use closedform_system::turn::{Patience, Turn};
use std::path::{Path, PathBuf};

/// Symbolica runs once a machine and, without a licence, in one thread: the tests take one turn together.
#[test]
fn what_is_proved_is_what_is_said() {
    let _turn = turn_of_the_machine();
    every_side_of_every_if_is_proved();
    the_last_else_of_every_shipped_kernel_is_proved();
    more_ways_than_are_looked_at_are_refused();
    results_must_be_the_contracts();
    every_condition_of_every_shipped_kernel_is_proved();
    a_condition_without_a_value_does_not_hold();
    what_a_formula_needs_is_required_where_no_contract_says_it();
    a_domain_may_be_a_single_point();
    a_formula_as_written_is_proved_step_by_step();
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn turn_of_the_machine() -> Turn {
    let patience = Patience::of(None).unwrap();
    Turn::take(&patience, |_| ()).unwrap()
}

/// The family of a worksheet with a contract, and its generated text.
fn made(contract: &str, worksheet: &str) -> (Family, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("made.toml"), contract).unwrap();
    std::fs::write(folder.path().join("made.mac"), worksheet).unwrap();
    let family = Family::from_worksheet(&folder.path().join("made.mac")).unwrap();
    let mut generated = generate(ALGEBRA, std::slice::from_ref(&family), |_, _| ()).unwrap();
    (family, generated.files.remove("made.rs").unwrap())
}

fn kernel_of(text: &str) -> Kernel {
    parse_file(text).unwrap().remove(0)
}

/// The proof of a kernel that may have been doctored.
fn proof(family: &Family, contract: &KernelContract, kernel: &Kernel) -> Result<(), ProofError> {
    let own = family.results().filter(|(owner, ..)| owner.name == contract.name);
    let references: Vec<Definition> = own.map(|(.., reference)| reference.clone()).collect();
    prove(ALGEBRA, kernel, &family.completed(contract), &references)
}

const TERMS: usize = 12;

/// sqrt(x^2+k*y^2)-x, whose kernel decides by the sign of x.
fn term(k: usize) -> String {
    format!("sqrt(x^2+{k}*y^2)-x")
}

const INPUTS: &str = "[family]\ntitle = \"Many\"\n[inputs]\nx = { name = \"x\", unit = \"1\" }\ny = { name = \"y\", unit = \"1\" }\n\
                      [[kernel]]\nname = \"many\"\ndoc = \"Many.\"\ninputs = [\"x\", \"y\"]\ndomain = [\"y > 0\"]\n";

/// The same with one result.
const ONE: &str = concat!(
    "[family]\ntitle = \"One\"\n[inputs]\nx = { name = \"x\", unit = \"1\" }\ny = { name = \"y\", unit = \"1\" }\n",
    "[[kernel]]\nname = \"one\"\ndoc = \"One.\"\ninputs = [\"x\", \"y\"]\ndomain = [\"y > 0\"]\n",
    "[[kernel.result]]\nname = \"one\"\nworksheet = \"f\"\nunit = \"1\"\n"
);

fn twelve_results() -> (Family, String) {
    let mut contract = format!("{INPUTS}returns = \"Many\"\n");
    let mut worksheet = String::new();
    for k in 1..=TERMS {
        contract += &format!("[[kernel.result]]\nname = \"r{k}\"\nworksheet = \"f{k}\"\nunit = \"1\"\n");
        worksheet += &format!("f{k}(x,y):={}$\n", term(k));
    }
    made(&contract, &worksheet)
}

fn largest_of_twelve() -> (Family, String) {
    let terms = (1..=TERMS).map(term).collect::<Vec<_>>().join(",");
    made(ONE, &format!("f(x,y):=max({terms})$\n"))
}

/// Every `if` of steps and results, in order.
fn choices(kernel: &mut Kernel) -> Vec<&mut Expr> {
    let mut found = Vec::new();
    kernel.lets.iter_mut().for_each(|step| collect_choices(&mut step.value, &mut found));
    match &mut kernel.output {
        Output::Value(value) => collect_choices(value, &mut found),
        Output::Struct { fields, .. } => fields.iter_mut().for_each(|(_, value)| collect_choices(value, &mut found)),
    }
    found
}

fn collect_choices<'k>(expr: &'k mut Expr, found: &mut Vec<&'k mut Expr>) {
    match expr {
        Expr::If { .. } => found.push(expr),
        Expr::Neg(inner) | Expr::Call(_, inner) => collect_choices(inner, found),
        Expr::Binary { left, right, .. } => [left, right].into_iter().for_each(|side| collect_choices(side, found)),
        Expr::Extreme { items, .. } | Expr::PositiveRoot(items) => {
            items.iter_mut().for_each(|item| collect_choices(item, found));
        }
        _ => {}
    }
}

fn doubled(expr: &Expr) -> Expr {
    Expr::Binary { op: BinaryOp::Add, left: expr.clone().into(), right: expr.clone().into() }
}

fn every_side_of_every_if_is_proved() {
    for (family, text) in [twelve_results(), largest_of_twelve()] {
        assert!(unproved(ALGEBRA, &family, &text, |_, _| ()).is_empty());
        let (kernel, contract) = (kernel_of(&text), &family.contract.kernels[0]);
        assert_eq!(choices(&mut kernel.clone()).len(), TERMS, "{text}");
        for (at, side) in (0..TERMS).flat_map(|at| [(at, true), (at, false)]) {
            let mut doctored = kernel.clone();
            let Expr::If { then, otherwise, .. } = &mut *choices(&mut doctored)[at] else { panic!("an if") };
            let side_of = if side { then } else { otherwise };
            **side_of = doubled(side_of);
            let refused = matches!(proof(&family, contract, &doctored), Err(ProofError::Different(..)));
            assert!(refused, "if {at}, {}", if side { "then" } else { "else" });
        }
    }
}

fn the_last_else_of_every_shipped_kernel_is_proved() {
    let mut doctored_kernels = 0;
    for (family, contract, mut kernel) in shipped() {
        let Some(Expr::If { otherwise, .. }) = choices(&mut kernel).pop() else { continue };
        **otherwise = doubled(otherwise);
        assert!(proof(&family, &contract, &kernel).is_err(), "{}::{}", family.name, contract.name);
        doctored_kernels += 1;
    }
    assert!(doctored_kernels > 5, "{doctored_kernels}");
}

/// A kernel by hand whose `if`s choose between different values: each doubles the ways.
fn more_ways_than_are_looked_at_are_refused() {
    let (family, text) = made(ONE, "f(x,y):=x-x*y$\n");
    let chosen = |ifs: usize, last: &str| {
        let body: String =
            (0..ifs).map(|at| format!("let s{at} = if x > {at}.5 {{ 1.0 }} else {{ {last} }};\n")).collect();
        let squares: String = (0..ifs).map(|at| format!(" * s{at} * s{at}")).collect();
        let start =
            text.find("let").or_else(|| text.find("compensated!(x")).unwrap_or_else(|| text.find("x * ").unwrap());
        kernel_of(&format!("{}{body} (x - x * y){squares}\n}}\n", &text[..start]))
    };
    let contract = &family.contract.kernels[0];
    assert!(proof(&family, contract, &chosen(8, "-1.0")).is_ok());
    assert!(matches!(proof(&family, contract, &chosen(8, "-2.0")), Err(ProofError::Different(..))));
    let error = proof(&family, contract, &chosen(11, "-1.0")).unwrap_err();
    assert!(matches!(error, ProofError::TooManyBranches { choices: 11, .. }), "{error}");
    assert!(error.to_string().contains("the 11 `if`s") && error.to_string().contains("more than 1024 ways"), "{error}");
}

fn results_must_be_the_contracts() {
    let (family, text) = twelve_results();
    let contract = &family.contract.kernels[0];
    let (kernel, mut swapped, mut short) = (kernel_of(&text), kernel_of(&text), kernel_of(&text));
    let Output::Struct { fields, .. } = &mut swapped.output else { panic!("a struct") };
    fields.swap(0, 1);
    let Output::Struct { fields, .. } = &mut short.output else { panic!("a struct") };
    fields.pop();
    short.meta.results.pop();
    let mut turned = kernel.clone();
    turned.inputs.swap(0, 1);
    for (kernel, expected) in [(swapped, "fields"), (short, "results"), (turned, "inputs")] {
        let error = proof(&family, contract, &kernel).unwrap_err();
        assert!(matches!(error, ProofError::Signature { what, .. } if what == expected), "{error}");
    }
    assert!(proof(&family, contract, &kernel).is_ok());
}

/// Every shipped kernel.
fn shipped() -> Vec<(Family, KernelContract, Kernel)> {
    let mut all = Vec::new();
    for family in families(&repository().join("maxima-ref")).unwrap() {
        let path = repository().join(format!("kernels/src/generated/{}.rs", family.name));
        for kernel in parse_file(&std::fs::read_to_string(Path::new(&path)).unwrap()).unwrap() {
            let contract = family.contract.kernels.iter().find(|contract| kernel.name == contract.name).unwrap();
            all.push((family.clone(), contract.clone(), kernel));
        }
    }
    all
}

/// Every comparison of a condition, to be changed.
fn comparisons(condition: &mut Condition) -> Vec<(&mut Relation, &mut Expr, &mut Expr)> {
    match condition {
        Condition::Compare { op, left, right } => vec![(op, left, right)],
        Condition::And(left, right) | Condition::Or(left, right) => {
            let mut found = comparisons(left);
            found.extend(comparisons(right));
            found
        }
        Condition::Not(inner) => comparisons(inner),
    }
}

/// One mistake in a comparison; nothing if it is none there.
type Mistake = fn(&mut Relation, &mut Expr, &mut Expr) -> Option<()>;

const MISTAKES: [(&str, Mistake); 4] = [
    ("an order is flipped", |op, _, _| {
        *op = if op.mirrored() == *op { op.negated() } else { op.mirrored() };
        Some(())
    }),
    ("an edge is let in or out", |op, _, _| {
        let moved = op.mirrored().negated();
        (moved.mirrored() != moved).then(|| *op = moved)
    }),
    ("a coefficient is another one", |_, left, right| {
        first_number(left).or_else(|| first_number(right)).map(|number| *number += 1.0)
    }),
    ("a name is another one", |_, left, right| {
        let sum = Expr::Binary { op: BinaryOp::Add, left: left.clone().into(), right: left.clone().into() };
        *right = sum;
        Some(())
    }),
];

/// What is no mistake. At these edges another part of the condition holds: it is positive there.
const EDGES_OF_OTHERS: [&str; 5] = [
    "five_segment::by_accelerations: `a0+a1 >= 0 or 3*DeltaX*Ki*a0 > (a0+a1)^2*t1^2`, comparison 0: an edge is let in or out",
    "five_segment::by_accelerations: `a1 >= 0 or (a1^2+2*a0*a1+9*a0^2)*t1^2+3*DeltaX*(9*Ki*a0+8*a1*(1-Ki)) >= 0 or 108*t1^2*(3*a0-a1)^2*DeltaX*Ki*a0 >= ((a1^2+2*a0*a1+9*a0^2)*t1^2+3*DeltaX*(9*Ki*a0+8*a1*(1-Ki)))^2`, comparison 0: an edge is let in or out",
    "five_segment::ki_without_middle: `a1 >= 0 or 3*a0*DeltaX > a1^2*t1^2`, comparison 0: an edge is let in or out",
    "turnaround::t_in_of_tau: `4*tau < 3*tEFSkip or 12*delta > (4*tau-3*tEFSkip)*(8*tau-3*tEFSkip)`, comparison 0: an edge is let in or out",
    "turnaround::tau_of_t_in: `2*tIn < 3*tEFSkip or 12*delta > (2*tIn-3*tEFSkip)^2`, comparison 0: an edge is let in or out",
];

/// And what is not zero is not twice itself.
const TWICE: [&str; 8] = [
    "look_ahead::half_turn: `ux # 0 or uy # 0 or uz # 0`, comparison 0: a name is another one",
    "look_ahead::half_turn: `ux # 0 or uy # 0 or uz # 0`, comparison 1: a name is another one",
    "look_ahead::half_turn: `ux # 0 or uy # 0 or uz # 0`, comparison 2: a name is another one",
    "milling_time::direction: `x # 0 or y # 0 or z # 0`, comparison 0: a name is another one",
    "milling_time::direction: `x # 0 or y # 0 or z # 0`, comparison 1: a name is another one",
    "milling_time::direction: `x # 0 or y # 0 or z # 0`, comparison 2: a name is another one",
    "pvt::arrival_first: `a0 # 0 or v1+2*v0 > 0`, comparison 0: a name is another one",
    "pvt::arrival_last: `a0 # 0 or v1+2*v0 < 0`, comparison 0: a name is another one",
];

fn first_number(expr: &mut Expr) -> Option<&mut f64> {
    match expr {
        Expr::Literal { value, .. } => Some(value),
        Expr::Compensated(expression) => first_number(&mut expression.value),
        Expr::Neg(inner) => first_number(inner),
        Expr::Binary { left, right, .. } => first_number(left).or_else(|| first_number(right)),
        _ => None,
    }
}

fn every_condition_of_every_shipped_kernel_is_proved() {
    let mut accepted = Vec::new();
    for (family, contract, kernel) in shipped() {
        let name = format!("{}::{}", family.name, contract.name);
        let mut refused = |doctored: &Kernel, what: String| {
            if !matches!(proof(&family, &contract, doctored), Err(ProofError::Domain { .. })) {
                accepted.push(format!("{name}: {what}"));
            }
        };
        for at in 0..kernel.requires.len() {
            let text = kernel.requires[at].text.clone();
            let mut doctored = kernel.clone();
            doctored.requires.remove(at);
            refused(&doctored, format!("`{text}` is dropped"));
            for (what, mistake) in MISTAKES {
                for part in 0..comparisons(&mut kernel.requires[at].condition.clone()).len() {
                    let mut doctored = kernel.clone();
                    let (op, left, right) = comparisons(&mut doctored.requires[at].condition).remove(part);
                    if mistake(op, left, right).is_some() {
                        refused(&doctored, format!("`{text}`, comparison {part}: {what}"));
                    }
                }
            }
        }
    }
    let mut equivalent: Vec<&str> = EDGES_OF_OTHERS.into_iter().chain(TWICE).collect();
    equivalent.sort_unstable();
    accepted.sort_unstable();
    assert_eq!(accepted, equivalent);
}

/// The kernel of one formula of x and y with this domain.
fn kernel_in(domain: &[&str], formula: &str) -> Kernel {
    let text = made(&ONE.replace("[\"y > 0\"]", &format!("{domain:?}")), &format!("f(x,y):={formula}$\n"));
    kernel_of(&text.1)
}

/// Whether a kernel lets in a point, decided with more bits than its conditions have.
fn lets_in(kernel: &Kernel, point: &[f64]) -> bool {
    let numbers: Vec<Mpfr> = point.iter().map(|value| Mpfr::new(2000, *value)).collect();
    violated(kernel, &numbers).is_none()
}

/// A condition, and points at which it holds, and at which it does not.
type Decided<'a> = (&'a str, &'a [[f64; 2]], &'a [[f64; 2]]);

fn a_condition_without_a_value_does_not_hold() {
    let cases: [Decided; 9] = [
        ("(x+y)/(x-y) <= 2", &[[5.0, 1.0], [1.0, 2.0]], &[[2.0, 2.0], [0.0, 0.0], [2.0, 1.0]]),
        ("x^-2 >= 4", &[[0.5, 0.0], [-0.25, 1.0]], &[[0.0, 1.0], [1.0, 1.0]]),
        ("(x^2-y^2)/(x-y) > 0", &[[2.0, 1.0]], &[[2.0, 2.0], [-2.0, 1.0]]),
        ("x*y/(x*y) > 0", &[[2.0, -1.0]], &[[0.0, 1.0], [1.0, 0.0], [0.0, 0.0]]),
        ("1/(1/x) > -1", &[[2.0, 0.0], [-0.5, 0.0]], &[[0.0, 1.0], [-3.0, 1.0]]),
        ("abs(y/x) >= 1", &[[2.0, -3.0]], &[[0.0, 1.0], [0.0, 0.0], [2.0, 1.0]]),
        ("not y/x > 1", &[[2.0, 1.0], [-1.0, 5.0]], &[[0.0, 1.0], [0.0, 0.0], [1.0, 2.0]]),
        ("not (y/x > 1 and y > 0)", &[[2.0, 1.0], [0.0, -1.0]], &[[0.0, 1.0], [1.0, 2.0]]),
        ("y/x > 1 or y = 0", &[[2.0, 3.0], [0.0, 0.0]], &[[0.0, 1.0], [1.0, 1.0]]),
    ];
    for (condition, inside, outside) in cases {
        let kernel = kernel_in(&[condition], "x+2*y");
        assert!(inside.iter().all(|point| lets_in(&kernel, point)), "{condition}");
        for point in outside {
            assert!(!lets_in(&kernel, point), "{condition} at {point:?}");
        }
    }
}

fn what_a_formula_needs_is_required_where_no_contract_says_it() {
    for (domain, formula, texts, outside) in [
        (&[][..], "x/(2*y)", &["y # 0"][..], &[[1.0, 0.0], [0.0, 0.0]][..]),
        (&[], "(-y+sqrt(y^2-4*x))/(2*x)", &["y^2-4*x >= 0", "x # 0"], &[[0.0, 1.0], [1.0, 1.0]]),
        (&["x > y"], "1/(x-y)+1/x", &["x > y", "x # 0"], &[[0.0, -1.0], [1.0, 1.0]]),
        (&["x > 1"], "sqrt(x-y)/x", &["x > 1", "x-y >= 0"], &[[2.0, 3.0]]),
        (&["x > 1", "y >= 2"], "sqrt(x*y-1)/(x+y)", &["x > 1", "y >= 2"], &[[1.0, 2.0]]),
        (&["x # 0 or y # 0"], "x/sqrt(x^2+y^2)", &["x # 0 or y # 0"], &[[0.0, 0.0]]),
        (
            &["x > y and y > 1 or y > x and x > 1"],
            "1/(x-y)+sqrt(x*y)",
            &["x > y and y > 1 or y > x and x > 1"],
            &[[2.0, 2.0]],
        ),
        // the last condition holds wherever the others do, which the search does not find
        (
            &["y > 0"],
            "6*(x-1)/(x+1+4*sqrt(x))+y",
            &["y > 0", "x >= 0", "4^2*x-(x+1)^2 # 0 or 4*(x+1)*(4^2*x) > 0"],
            &[[-1.0, 1.0]],
        ),
    ] {
        let kernel = kernel_in(domain, formula);
        let required: Vec<&str> = kernel.requires.iter().map(|require| require.text.as_str()).collect();
        assert_eq!(required, texts, "{formula}");
        for point in outside {
            assert!(!lets_in(&kernel, point), "{formula} at {point:?}");
        }
    }
}

fn a_domain_may_be_a_single_point() {
    for domain in [&["x >= 9", "x <= 9"][..], &["x = 9"]] {
        let kernel = kernel_in(domain, "x*y+1/x");
        assert!(lets_in(&kernel, &[9.0, 2.0]));
        assert!(!lets_in(&kernel, &[9.0_f64.next_up(), 2.0]));
    }
}

fn a_formula_as_written_is_proved_step_by_step() {
    let (family, text) = made(ONE, "f(x,y):=1+max(x,2*y)$\n");
    let contract = &family.contract.kernels[0];
    assert!(text.contains("precision = \"certified\""), "{text}");
    assert!(proof(&family, contract, &kernel_of(&text)).is_ok());
    for (right, wrong) in
        [("1.0 + ", "1.0 - "), ("2.0 * y", "2.5 * y"), ("max(", "min("), ("require!(y > ", "require!(x > ")]
    {
        let (before, function) = text.split_at(text.find("pub fn").unwrap());
        assert!(function.contains(right), "{right} in {function}");
        let doctored = format!("{before}{}", function.replacen(right, wrong, 1));
        assert!(proof(&family, contract, &kernel_of(&doctored)).is_err(), "{wrong}");
    }
}
