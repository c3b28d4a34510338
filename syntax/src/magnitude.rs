//! Magnitudes: between which powers of two inputs must lie so that no step of a kernel over- or underflows in `f64`.
//!
//! Every value is followed as bounds of its magnitude, a power of two that it is a multiple of, and its sign. A sum whose
//! terms may cancel is either zero or no smaller than the power of two that they are multiples of. What magnitudes cannot
//! tell the runtime tests at every call: that `compensated!` expressions are larger than their threshold, divisors not zero,
//! radicands not negative.

mod bounds;
mod compensated;
mod signs;

use closedform_arith::Precision;

use crate::kernel::{BinaryOp, Condition, Expr, Kernel};

use bounds::Bounds;
use signs::Signs;

/// The largest k that is tried.
const LARGEST: u32 = 1000;

/// The largest k of: where every input is 0 or of a magnitude from 2^-k to 2^k, no step of a kernel in `f64` over- or
/// underflows (in double-double each is tested), and no product inside a compensated expression loses its error. 0 where
/// there is none, where the kernel finds the root of a polynomial, and where it certifies every call.
pub fn ordinary(kernel: &Kernel) -> u32 {
    if kernel.meta.precision == Precision::Certified {
        return 0;
    }
    let (mut stays, mut leaves) = (0, LARGEST + 1);
    while leaves - stays > 1 {
        let middle = stays.midpoint(leaves);
        *(if kernel_stays(kernel, middle.into()) { &mut stays } else { &mut leaves }) = middle;
    }
    stays
}

/// Whether no step over- or underflows at inputs of these exponents, in the arithmetics that calls begin with.
fn kernel_stays(kernel: &Kernel, exponent: i64) -> bool {
    // `faithful` begins with double-double in any case
    let in_f64 = kernel.meta.precision == Precision::Double;
    stays_in(kernel, Precision::DoubleDouble, exponent) && (!in_f64 || stays_in(kernel, Precision::Double, exponent))
}

fn stays_in(kernel: &Kernel, precision: Precision, exponent: i64) -> bool {
    let inputs = vec![Bounds::float(-exponent, exponent); kernel.inputs.len()];
    let mut signs = Signs::default();
    for require in &kernel.requires {
        // Where an earlier condition does not hold, nobody looks at a later one.
        let walk = Walk { precision, signs: &signs, slots: inputs.clone() };
        if walk.condition(&require.condition).is_none() {
            return false;
        }
        signs.learn(&require.condition);
    }
    Walk { precision, signs: &signs, slots: inputs }.evaluation(kernel).is_some()
}

/// What is known of inputs and steps, in order.
struct Walk<'a> {
    precision: Precision,
    signs: &'a Signs,
    slots: Vec<Bounds>,
}

impl Walk<'_> {
    /// Steps and results; `None` where one may leave the range.
    fn evaluation(mut self, kernel: &Kernel) -> Option<()> {
        for step in &kernel.lets {
            let value = self.value(&step.value)?;
            self.slots.push(value);
        }
        kernel.output.values().try_for_each(|value| self.value(value).map(drop))
    }

    fn value(&self, expr: &Expr) -> Option<Bounds> {
        self.unsigned(expr).map(|bounds| self.signs.refine(expr, bounds))
    }

    /// The value but for what conditions tell of its sign.
    fn unsigned(&self, expr: &Expr) -> Option<Bounds> {
        match expr {
            Expr::Literal { value, .. } => Some(Bounds::literal(*value)),
            Expr::Name(name) => Some(self.slots[name.slot]),
            Expr::Pi(_) => Some(Bounds::literal(std::f64::consts::PI)),
            Expr::Neg(inner) => Some(self.value(inner)?.negated()),
            Expr::Call(function, inner) => Some(self.value(inner)?.called(*function)),
            Expr::Binary { op, left, right } => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                match op {
                    BinaryOp::Add => self.stays(left.sum(right), Bounds::finite),
                    BinaryOp::Sub => self.stays(left.sum(right.negated()), Bounds::finite),
                    BinaryOp::Mul => self.stays(left.product(right).rounded(), Bounds::normal),
                    BinaryOp::Div => self.stays(left.quotient(right), Bounds::normal),
                }
            }
            Expr::Extreme { items, .. } => self.any(items.iter()),
            Expr::If { condition, then, otherwise } => {
                self.condition(condition)?;
                self.any([&**then, &**otherwise].into_iter())
            }
            Expr::Compensated(expression) => {
                self.stays(compensated::compensated(expression, self.signs, &|leaf| self.value(leaf))?, Bounds::normal)
            }
            Expr::Residual(expression) => {
                self.stays(compensated::residual(expression, self.signs, &|leaf| self.value(leaf))?, Bounds::finite)
            }
            // Its magnitude is unknown, and its polynomial vanishes there, so that it is in doubt nearly always.
            Expr::PositiveRoot(_) => None,
        }
    }

    /// The number in double-double, or in `f64` if it is `fine`.
    fn stays(&self, number: Bounds, fine: fn(Bounds) -> Option<Bounds>) -> Option<Bounds> {
        if self.precision == Precision::DoubleDouble { Some(number.tested()) } else { fine(number) }
    }

    /// What is known of a value that is one of these.
    fn any<'e>(&self, mut items: impl Iterator<Item = &'e Expr>) -> Option<Bounds> {
        let first = self.value(items.next()?)?;
        items.try_fold(first, |any, item| Some(any.or(self.value(item)?)))
    }

    fn condition(&self, condition: &Condition) -> Option<()> {
        match condition {
            Condition::Compare { left, right, .. } => {
                [left, right].into_iter().try_for_each(|side| self.value(side).map(drop))
            }
            Condition::And(left, right) | Condition::Or(left, right) => {
                [left, right].into_iter().try_for_each(|side| self.condition(side))
            }
            Condition::Not(inner) => self.condition(inner),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(body: &str) -> u32 {
        let source = format!("#[kernel]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
        ordinary(&crate::parse_file(&source).unwrap().remove(0))
    }

    #[test]
    fn products_and_quotients_share_the_exponents() {
        assert_eq!(of("x"), LARGEST);
        assert_eq!(of("x * y"), 511);
        assert_eq!(of("x / y"), 511);
        assert_eq!(of("x * y * x"), 340);
        assert_eq!(of("x / (y * y)"), 340);
        assert_eq!(of("sqrt(x * x + y * y)"), 511);
        assert_eq!(of("1e300 * x * 1e300"), 0);
    }

    #[test]
    fn a_sum_that_cancels_is_no_smaller_than_a_last_place() {
        // (x - y)^3 is no less than 2^(3 (-k - 52))
        assert_eq!(of("(x - y) * (x - y) * (x - y)"), 288);
        assert_eq!(of("require!(x > 0.0); require!(y < 0.0); (x - y) * (x - y) * (x - y)"), 340);
        assert_eq!(of("require!(y >= 0.0); require!(x > y); 1.0 / (x * x + y) / x"), 340);
    }

    #[test]
    fn a_condition_learns_from_earlier_ones_alone() {
        let late = of("require!((x + y) * (x + y) * (x + y) > 0.0); require!(x > 0.0 && y > 0.0); x");
        let early = of("require!(x > 0.0 && y > 0.0); require!((x + y) * (x + y) * (x + y) > 0.0); x");
        assert_eq!((late, early), (288, 340));
    }

    #[test]
    fn products_in_compensated_expressions_keep_their_errors() {
        assert_eq!(of("compensated!(x * y)"), 484);
        assert_eq!(of("compensated!(x * y - x * x * y)"), 322);
        assert_eq!(of("compensated!((x - y) * (x + y) * x)"), 288);
    }

    #[test]
    fn in_double_double_sums_of_steps_are_what_counts() {
        // a product lies above 2^-968, a step in double-double above 2^-450, in `f64` at 2^(-2 k - 52) or above
        assert_eq!(of("let s = x - y * x; compensated!(s * x - y)"), 305);
        assert_eq!(of("let s = x - y * x; compensated!(s * s * x - y)"), 68);
        assert_eq!(of("let s = x - y * x; compensated!(s * s * s - y)"), 0);
    }

    #[test]
    fn conditions_tell_the_signs_of_sums() {
        let of = |condition: &str| of(&format!("require!({condition}); let s = x + y; 1.0 / (s * s * s + s)"));
        assert!(of("x + y > 0.0") > 0 && of("x + y < 0.0") == of("x + y > 0.0"));
        assert_eq!(of("x + y != 0.0"), of("x * y > 0.0"));
    }

    #[test]
    fn roots_of_polynomials_are_watched() {
        assert_eq!(of("positive_root([-abs(x), 0.0, 1.0])"), 0);
    }
}
