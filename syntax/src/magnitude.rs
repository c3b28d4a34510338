//! Magnitudes: between which powers of two inputs must lie so that no step of a kernel over- or underflows in `f64`.
//!
//! Every value is followed as bounds of its magnitude, a power of two that it is a multiple of, and its sign. A sum whose
//! terms may cancel is either zero or no smaller than the power of two that they are multiples of. What magnitudes cannot
//! tell the runtime tests at every call: that `compensated!` expressions are larger than their threshold, divisors not zero,
//! radicands not negative.

mod bounds;
mod compensated;
mod signs;

use closedform_arith::{Precision, Signs as InputSigns};

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
    largest(|exponent| kernel_stays(kernel, exponent))
}

/// The same of the arithmetic that [bounds its own error](closedform_arith::Bounded), in which a compensated expression is
/// what `f64` makes of it.
pub fn ordinary_when_bounded(kernel: &Kernel) -> u32 {
    largest(|exponent| stays_in(kernel, Arithmetic::Bounded, exponent))
}

/// The signs that inputs have in the domain, as far as its conditions compare them with numbers.
pub fn input_signs(kernel: &Kernel) -> Vec<InputSigns> {
    let mut signs = Signs::of_inputs();
    kernel.requires.iter().for_each(|require| signs.learn(&require.condition));
    kernel.inputs.iter().map(|input| signs.of_input(&input.name)).collect()
}

/// The largest exponent at which all `stays`; 0 where there is none.
fn largest(stays: impl Fn(i64) -> bool) -> u32 {
    let (mut known, mut leaves) = (0, LARGEST + 1);
    while leaves - known > 1 {
        let middle = known.midpoint(leaves);
        *(if stays(middle.into()) { &mut known } else { &mut leaves }) = middle;
    }
    known
}

/// The arithmetics that calls begin with.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Arithmetic {
    Double,
    DoubleDouble,
    Bounded,
}

/// Whether no step over- or underflows at inputs of these exponents, in the arithmetics that calls begin with.
fn kernel_stays(kernel: &Kernel, exponent: i64) -> bool {
    // `faithful` begins with double-double in any case
    let in_f64 = kernel.meta.precision == Precision::Double;
    stays_in(kernel, Arithmetic::DoubleDouble, exponent) && (!in_f64 || stays_in(kernel, Arithmetic::Double, exponent))
}

fn stays_in(kernel: &Kernel, arithmetic: Arithmetic, exponent: i64) -> bool {
    let inputs = vec![Bounds::float(-exponent, exponent); kernel.inputs.len()];
    // what is rounded at every step may have another sign than conditions tell of it
    let mut signs = if arithmetic == Arithmetic::Bounded { Signs::of_inputs() } else { Signs::default() };
    for require in &kernel.requires {
        // Where an earlier condition does not hold, nobody looks at a later one.
        let walk = Walk { arithmetic, signs: &signs, slots: inputs.clone() };
        if walk.condition(&require.condition).is_none() {
            return false;
        }
        signs.learn(&require.condition);
    }
    Walk { arithmetic, signs: &signs, slots: inputs }.evaluation(kernel).is_some()
}

/// What is known of inputs and steps, in order.
struct Walk<'a> {
    arithmetic: Arithmetic,
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
            Expr::Call(function, inner) => self.value(inner)?.called(*function),
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
            Expr::Compensated(expression) if self.arithmetic == Arithmetic::Bounded => self.value(&expression.value),
            Expr::Residual(expression) if self.arithmetic == Arithmetic::Bounded => self.value(expression),
            Expr::Compensated(expression) => {
                self.stays(compensated::compensated(expression, self.signs, &|leaf| self.value(leaf))?, Bounds::normal)
            }
            Expr::Residual(expression) => {
                self.stays(compensated::residual(expression, self.signs, &|leaf| self.value(leaf))?, Bounds::finite)
            }
            // Its magnitude is unknown, and its polynomial vanishes there, so that it escalates nearly always.
            Expr::PositiveRoot(_) => None,
        }
    }

    /// The number in double-double, or in `f64` if it is `fine`, or with a bound of its error.
    fn stays(&self, number: Bounds, fine: fn(Bounds) -> Option<Bounds>) -> Option<Bounds> {
        match self.arithmetic {
            Arithmetic::Double => fine(number),
            Arithmetic::DoubleDouble => Some(number.tested()),
            Arithmetic::Bounded => number.with_its_error(),
        }
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
    fn what_bounds_its_error_takes_no_sign_for_granted_but_those_of_inputs() {
        let of = |body: &str| {
            let source = format!("#[kernel]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
            let kernel = crate::parse_file(&source).unwrap().remove(0);
            (ordinary_when_bounded(&kernel), input_signs(&kernel))
        };
        use InputSigns as S;
        let (told, signs) = of("require!(x > 0.0 && 0.0 >= y); let s = x - y; s * s * s");
        assert_eq!((told, signs), (323, vec![S::POSITIVE, S::NOT_POSITIVE]));
        // x y - 1 is a multiple of what the product is rounded to, and no condition makes it larger
        let rounded = "let s = compensated!(x * y - 1.0); s * s * s";
        let (told, signs) = of(&format!("require!(compensated!(x * y - 1.0) > 0.0); {rounded}"));
        assert_eq!((told, signs), (of(rounded).0, vec![S::ANY, S::ANY]));
        assert_eq!(of("positive_root([-abs(x), 0.0, 1.0])").0, 0);
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
