//! The two implementations of polynomials agree: on random polynomials, and on the kernels that are made with them.

use closedform_generator::algebra::{Algebra, Polynomial, Ring, Sparse, Term};
use closedform_generator::pipeline::generate;
use closedform_project::family::Family;
use closedform_symbolica::ALGEBRA;
use closedform_system::turn::{Patience, Turn};
use num_rational::BigRational;

const SMALL: Algebra = Algebra::by::<Sparse>();

const VARIABLES: usize = 3;

/// Symbolica runs once a machine and, without a licence, in one thread: the tests take one turn together.
#[test]
fn implementations_agree() {
    let _turn = Turn::take(&Patience::of(None).unwrap(), |_| ()).unwrap();
    random_polynomials_have_the_same_divisors_quotients_and_factors();
    a_worksheet_has_the_same_kernels();
}

/// Numbers without a pattern: Knuth's linear congruential generator MMIX.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }

    /// At most so many terms, each variable to the power `degree` at most.
    fn terms(&mut self, count: u64, degree: u64) -> Vec<Term> {
        let mut term = || Term {
            coefficient: BigRational::new((self.below(13) as i64 - 6).into(), (1 + self.below(3)).into()),
            exponents: (0..VARIABLES).map(|_| self.below(degree + 1) as u16).collect(),
        };
        let first = term();
        let count = 1 + first.exponents.iter().map(|exponent| u64::from(*exponent)).sum::<u64>() % count;
        std::iter::once(first).chain((1..count).map(|_| term())).collect()
    }
}

fn polynomial(ring: &Ring, terms: &[Term]) -> Polynomial {
    let terms = terms.iter().map(|term| ring.term(&term.coefficient, &term.exponents));
    terms.fold(ring.integer(0), |sum, term| sum.plus(&term))
}

/// What the algebra says of some polynomials, as terms, which are the same in both.
fn answers(ring: &Ring, [a, b, c]: [&[Term]; 3]) -> Vec<String> {
    let [a, b, c] = [a, b, c].map(|terms| polynomial(ring, terms));
    let (left, right) = (a.times(&c), b.times(&c));
    let shown = |polynomial: &Polynomial| format!("{:?}", polynomial.terms());
    let mut answers = vec![
        shown(&left.plus(&right.power(2))),
        shown(&left.gcd(&right).primitive().1),
        format!("{:?}", left.divided_by(&c).map(|quotient| shown(&quotient))),
        format!("{:?}", left.plus(&b).divided_by(&c).map(|quotient| shown(&quotient))),
    ];
    for polynomial in [&left, &b.power(2), &left.times(&b), &left.plus(&b)] {
        let factors = polynomial.factors();
        let powers = factors.powers.iter().map(|(factor, exponent)| format!("({})^{exponent}", shown(factor)));
        answers.push(format!("{} {}", factors.constant, powers.collect::<Vec<_>>().join(" ")));
    }
    answers
}

fn random_polynomials_have_the_same_divisors_quotients_and_factors() {
    let mut numbers = Numbers(1);
    let (large, small) = (ALGEBRA.ring(VARIABLES), SMALL.ring(VARIABLES));
    for _ in 0..30 {
        let [a, b, c] = [numbers.terms(3, 2), numbers.terms(3, 2), numbers.terms(2, 1)];
        if [&a, &b, &c].iter().any(|terms| polynomial(&small, terms).is_zero()) {
            continue;
        }
        let terms = [&a[..], &b[..], &c[..]];
        assert_eq!(answers(&large, terms), answers(&small, terms), "{terms:?}");
    }
}

const WORKSHEET: &str = "product_of_differences(a,b,c,d) := a*b - c*d$
ramp(t,e,a,d) := sqrt(t^2/4 + 3*e*t/4 + 9*e^2/16 + 3*d/a) - 3*t/2 - 3*e/4$
root_of_sum(x) := sqrt(x+1) - sqrt(x)$
cubic(v0,v1) := (v1^3 - 3*v0*v1^2 + 3*v0^2*v1 - v0^3)/(v1 - v0)$
speed(w,a,d) := (sqrt(w^2 + 2*a*d) - w)/a$
merged(a,b) := sqrt(a)*sqrt(b)/a$
as_written(a,b) := 1 + max(a,2*b)$
";

fn a_worksheet_has_the_same_kernels() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("made.mac");
    std::fs::write(&path, WORKSHEET).unwrap();
    let family = Family::from_worksheet(&path).unwrap();
    let text = |algebra| generate(algebra, std::slice::from_ref(&family), |_, _| ()).unwrap().files;
    assert_eq!(text(ALGEBRA), text(SMALL));
}
