//! The last step onto the root of a polynomial: `x - x*(p(x)/s(x))` is right to a hundredth before it is rounded.
//!
//! Let p = c0 + .. + cn x^n have coefficients that are not positive below the power t and not negative above it, r be its
//! positive root, and s(x) the sum of (j-t) cj x^j, whose terms are all nonnegative. As a function of ln x, p(x)/x^t rises
//! with the slope s(x)/x^t, and its second derivative is at most n times that: the step is Newton's in ln x, but for
//! the square of the correction. From x within a factor 1 + e of r it leaves less than (n/2 + 1) e^2.
//!
//! The iterate: where each coefficient has a relative error of at most k units, positive over negative terms are off by
//! 2k at most. They rise at least as fast as x, so the root moves by no more.
//!
//! The remainder p(x): a `compensated!` one is right whatever cancels. A `residual!` is off by some units of 2^-106 of the
//! sum T of its terms' magnitudes; it is shown that T is at most [`TERMS`] times the sum of the |cj| x^j, which is at most
//! 2 s(r), since the terms with j = t are balanced by the others.

use crate::case::{Case, Fact};
use crate::count::{Count, Counter, integer, within};
use crate::forms::number;
use crate::polynomial::{Atom, Polynomial};
use crate::refusal::Reason;
use crate::sign::Sign;
use crate::text::text;
use crate::trusted;
use closedform_syntax::{BinaryOp, Expr};
use num_rational::BigRational;
use num_traits::{One, Signed};

/// How far from the root an iterate may be, and how far off a slope, in units: far more than they are.
const OFF: i64 = 1 << 16;

/// How much larger than the coefficients their own terms may be.
const TERMS: i64 = 1 << 20;

/// The parts of `x - x*(remainder/slope)`.
struct Parts<'k> {
    start: &'k Expr,
    coefficients: &'k [Expr],
    remainder: &'k Expr,
    slope: &'k Expr,
}

/// The count of a difference that corrects a root; `None` of any other.
pub fn of<'k>(counter: &Counter<'k>, expr: &'k Expr, case: &Case, step: &str) -> Option<Count> {
    let parts = Parts::of(counter, expr)?;
    let proved = Proof { counter, parts, case, step }.proved();
    Some(proved.and_then(|cause| match cause {
        None => Ok(counter.rounding() + trusted::correction()),
        Some(cause) => counter.refuse(step, Reason::Correction { correction: text(expr), cause }),
    }))
}

impl<'k> Parts<'k> {
    fn of(counter: &Counter<'k>, expr: &'k Expr) -> Option<Self> {
        let resolved = |expr| counter.forms.resolved(expr);
        let (start, change) = operands(expr, BinaryOp::Sub)?;
        let Expr::PositiveRoot(coefficients) = resolved(start) else { return None };
        let (factor, ratio) = operands(resolved(change), BinaryOp::Mul)?;
        let (remainder, slope) = operands(resolved(ratio), BinaryOp::Div)?;
        let same = std::ptr::eq(resolved(start), resolved(factor));
        same.then_some(Self { start: resolved(start), coefficients, remainder, slope })
    }
}

fn operands(expr: &Expr, wanted: BinaryOp) -> Option<(&Expr, &Expr)> {
    match expr {
        Expr::Binary { op, left, right } if *op == wanted => Some((left, right)),
        _ => None,
    }
}

struct Proof<'a, 'k> {
    counter: &'a Counter<'k>,
    parts: Parts<'k>,
    case: &'a Case,
    step: &'a str,
}

/// What is missing, if anything.
type Cause = Option<&'static str>;

impl<'k> Proof<'_, 'k> {
    fn proved(&self) -> Result<Cause, crate::Refusal> {
        let off = self.counter.count(self.parts.start, self.case, self.step)?;
        let slope_off = self.counter.count(self.parts.slope, self.case, self.step)?;
        if !within(&off, OFF) || !within(&slope_off, OFF) {
            return Ok(Some("its iterate or its slope may be too far off"));
        }
        let coefficients: Vec<Polynomial> =
            self.parts.coefficients.iter().map(|c| (*self.counter.forms.of(c)).clone()).collect();
        let Some(factor) = self.factor(&coefficients) else {
            return Ok(Some("the remainder is not the polynomial whose root it starts from"));
        };
        let coefficients: Vec<Polynomial> = coefficients.iter().map(|c| c.scaled(&factor)).collect();
        if !self.has_slope(&coefficients) {
            return Ok(Some(
                "the divisor is not the sum of (j-t)*cj*x^j over the polynomial's terms, t being a power at which \
                 their signs are shown to turn",
            ));
        }
        self.remainder_is_right(&coefficients)
    }

    /// The iterate as an atom.
    fn unknown(&self) -> Option<Atom> {
        self.counter.forms.of(self.parts.start).as_atom()
    }

    fn polynomial(&self, coefficients: &[Polynomial], weight: impl Fn(i64) -> i64) -> Polynomial {
        let unknown = self.unknown().map(Polynomial::atom).unwrap_or_default();
        let terms = coefficients.iter().zip(0..).map(|(coefficient, power)| {
            coefficient.times(&unknown.power(power)).scaled(&integer(weight(i64::from(power))))
        });
        terms.fold(Polynomial::default(), |sum, term| sum.plus(&term))
    }

    /// What the remainder is times the polynomial.
    fn factor(&self, coefficients: &[Polynomial]) -> Option<BigRational> {
        self.counter.forms.of(self.parts.remainder).ratio(&self.polynomial(coefficients, |_| 1))
    }

    /// Whether the slope turns at a power where the signs do.
    fn has_slope(&self, coefficients: &[Polynomial]) -> bool {
        let slope = self.counter.forms.of(self.parts.slope);
        let count = coefficients.len() as i64;
        let turn = (0..count).find(|turn| *slope == self.polynomial(coefficients, |power| power - turn));
        turn.is_some_and(|turn| {
            coefficients.iter().zip(0..).all(|(coefficient, power)| {
                let weighted = coefficient.scaled(&integer(power - turn));
                self.counter.sign_of_form(&weighted, self.case).is(Sign::NONNEGATIVE)
            })
        })
    }

    fn remainder_is_right(&self, coefficients: &[Polynomial]) -> Result<Cause, crate::Refusal> {
        let (factor, expression) = self.compensated_expression(self.parts.remainder);
        let inner = match expression {
            Expr::Compensated(expression) => &*expression.value,
            Expr::Residual(inner) => &**inner,
            _ => return Ok(Some("the remainder is neither a `compensated!` nor a `residual!`")),
        };
        if let Some(operand) = self.rounded_leaf(inner)? {
            let (expression, operand) = (text(expression), text(operand));
            return self.counter.refuse(self.step, Reason::Rounded { expression, operand });
        }
        let coefficients: Vec<Polynomial> = coefficients.iter().map(|c| c.scaled(&factor.recip())).collect();
        let right = matches!(expression, Expr::Compensated(_)) || self.terms_are_few(&coefficients, inner);
        Ok((!right).then_some(
            "the terms of its `residual!` are not shown to be of the size of the polynomial's, so that they may cancel \
             beyond what two doubles hold: write `compensated!`",
        ))
    }

    /// The compensated expression in a remainder, and the literal that multiplies it.
    fn compensated_expression(&self, remainder: &'k Expr) -> (BigRational, &'k Expr) {
        match self.counter.forms.resolved(remainder) {
            Expr::Neg(inner) => {
                let (factor, expression) = self.compensated_expression(inner);
                (-factor, expression)
            }
            Expr::Binary { op: BinaryOp::Mul, left, right } => match &**left {
                Expr::Literal { value, .. } if *value != 0.0 => {
                    let (factor, expression) = self.compensated_expression(right);
                    (factor * number(*value), expression)
                }
                _ => (BigRational::one(), remainder),
            },
            expression => (BigRational::one(), expression),
        }
    }

    /// A leaf of a compensated expression that is neither exact nor the iterate.
    fn rounded_leaf(&self, expression: &'k Expr) -> Result<Option<&'k Expr>, crate::Refusal> {
        match expression {
            Expr::Neg(inner) => self.rounded_leaf(inner),
            Expr::Binary { left, right, .. } => match self.rounded_leaf(left)? {
                Some(leaf) => Ok(Some(leaf)),
                None => self.rounded_leaf(right),
            },
            leaf if std::ptr::eq(self.counter.forms.resolved(leaf), self.parts.start) => Ok(None),
            leaf => Ok((self.counter.count(leaf, self.case, self.step)? != integer(0)).then_some(leaf)),
        }
    }

    /// Whether the magnitudes of a compensated expression's terms are bounded by those of its coefficients, whatever the
    /// signs of inputs.
    fn terms_are_few(&self, coefficients: &[Polynomial], expression: &'k Expr) -> bool {
        let noise = trusted::residual(operations(expression)) * integer(2 * TERMS);
        if noise > integer(1 << 40) {
            return false;
        }
        let form = self.counter.forms.of(expression);
        let open = form.atoms().into_iter().filter(|atom| !self.case.facts.borrow().atom(*atom).is_definite());
        let cases = open.fold(vec![Vec::new()], |cases: Vec<Vec<Fact>>, atom| {
            let with =
                |sign: Sign| cases.iter().map(move |facts| [&facts[..], &[(Polynomial::atom(atom), sign)]].concat());
            with(Sign::NONNEGATIVE).chain(with(Sign::NEGATIVE)).collect()
        });
        self.case.split(&cases).iter().all(|case| self.terms_are_few_in(coefficients, expression, case))
    }

    fn terms_are_few_in(&self, coefficients: &[Polynomial], expression: &'k Expr, case: &Case) -> bool {
        let Some(unknown) = self.unknown() else { return false };
        case.facts.borrow_mut().set_atom(unknown, Sign::POSITIVE);
        let terms = self.magnitudes(expression, case).coefficients(unknown);
        terms.iter().zip(coefficients).all(|(terms, coefficient)| {
            let negative = self.counter.sign_of_form(coefficient, case).is(Sign::NONPOSITIVE);
            let size = if negative { coefficient.negated() } else { coefficient.clone() };
            let rest = size.scaled(&integer(TERMS)).minus(terms);
            self.counter.sign_of_form(&rest, case).is(Sign::NONNEGATIVE)
        })
    }

    /// The sum of the magnitudes of a compensated expression's terms, before any of them cancel.
    fn magnitudes(&self, expression: &'k Expr, case: &Case) -> Polynomial {
        let part = |inner| self.magnitudes(inner, case);
        match expression {
            Expr::Neg(inner) => part(inner),
            Expr::Binary { op: BinaryOp::Mul, left, right } => part(left).times(&part(right)),
            Expr::Binary { left, right, .. } => part(left).plus(&part(right)),
            Expr::Literal { value, .. } => Polynomial::constant(number(*value).abs()),
            leaf => {
                let form = self.counter.forms.of(leaf);
                let negative = self.counter.sign_of_form(&form, case).is(Sign::NONPOSITIVE);
                if negative { form.negated() } else { (*form).clone() }
            }
        }
    }
}

fn operations(expression: &Expr) -> usize {
    let mut count = 0;
    expression.visit(&mut |part| count += usize::from(matches!(part, Expr::Binary { .. })));
    count
}
