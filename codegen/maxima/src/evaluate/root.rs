//! The one positive root of a polynomial, by bracketing.

use rug::Float;
use rug::float::prec_max;
use rug::ops::Pow;

use crate::ast::Expr;

use super::error::EvalError;
use super::scope::{Local, Result, Scope};

/// Roots are looked for between `2^-REACH` and `2^REACH`.
const REACH: i32 = 1 << 16;

/// Bits that the polynomial is evaluated with beyond those of the root.
const GUARD_BITS: u32 = 64;

/// The one positive root of `polynomial` in `variable`.
pub(super) fn positive_root(scope: &Scope, polynomial: &Expr, variable: &Expr) -> Result<Float> {
    let Some(variable) = variable.as_symbol() else {
        return Err(EvalError::NotNumeric { what: "a root in something that is no name", span: variable.span.clone() });
    };
    let mut function = Function { scope: *scope, polynomial, variable, falling: false };
    function.scope.precision = scope.precision.saturating_add(GUARD_BITS).min(prec_max());
    function.falling = function.at(&function.power_of_two(REACH))?.is_sign_negative();
    let root = match function.octave()? {
        Octave::Exactly(exponent) => function.power_of_two(exponent),
        Octave::From(exponent) => function.refine(exponent, scope.precision)?,
    };
    Ok(scope.float(root))
}

/// A polynomial as a function of its variable, negated if it falls in the end.
struct Function<'a> {
    scope: Scope<'a>,
    polynomial: &'a Expr,
    variable: &'a str,
    falling: bool,
}

/// Where a root is.
enum Octave {
    /// At two to this power.
    Exactly(i32),
    /// Between two to this power and its double.
    From(i32),
}

impl Function<'_> {
    fn power_of_two(&self, exponent: i32) -> Float {
        self.scope.float(Float::i_exp(1, exponent))
    }

    fn at(&self, place: &Float) -> Result<Float> {
        let local = Local { name: self.variable, value: place, outer: self.scope.local() };
        let scope = self.scope.with(&local);
        let value = scope.value(self.polynomial)?;
        Ok(if self.falling { -value } else { value })
    }

    /// Finds powers of two on both sides of the root, and moves them together.
    fn octave(&self) -> Result<Octave> {
        let start = self.at(&self.power_of_two(0))?;
        if start.is_zero() {
            return Ok(Octave::Exactly(0));
        }
        let outwards = if start.is_sign_negative() { 1 } else { -1 };
        let (mut inner, mut outer) = (0, outwards);
        while self.at(&self.power_of_two(outer))?.cmp0() != start.cmp0().map(std::cmp::Ordering::reverse) {
            (inner, outer) = (outer, outer * 2);
            if outer.abs() > REACH {
                return Err(EvalError::NoPositiveRoot { span: self.polynomial.span.clone() });
            }
        }
        self.narrow(inner.min(outer), inner.max(outer))
    }

    fn narrow(&self, mut low: i32, mut high: i32) -> Result<Octave> {
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            match self.at(&self.power_of_two(middle))? {
                value if value.is_zero() => return Ok(Octave::Exactly(middle)),
                value if value.is_sign_negative() => low = middle,
                _ => high = middle,
            }
        }
        Ok(Octave::From(low))
    }

    /// The root between two to `exponent` and its double, to `bits` bits: false position, kept from stalling by halving
    /// the weight of an end that stays (Illinois), and by bisecting every third time.
    fn refine(&self, exponent: i32, bits: u32) -> Result<Float> {
        let (mut low, mut high) = (self.power_of_two(exponent), self.power_of_two(exponent + 1));
        let (mut below, mut above) = (self.at(&low)?, self.at(&high)?);
        let width = self.scope.float(2).pow(i64::from(exponent) - i64::from(bits) - 2);
        let (mut step, mut last) = (0_u32, None);
        while self.scope.float(&high - &low) > width {
            step += 1;
            let place = self.next_place(&low, &high, &below, &above, step);
            if place <= low || place >= high {
                break;
            }
            let value = self.at(&place)?;
            if value.is_zero() {
                return Ok(place);
            }
            let is_below = value.is_sign_negative();
            let stays = last == Some(is_below);
            last = Some(is_below);
            if is_below {
                (low, below) = (place, value);
                above /= if stays { 2 } else { 1 };
            } else {
                (high, above) = (place, value);
                below /= if stays { 2 } else { 1 };
            }
        }
        Ok((low + high) / 2)
    }

    fn next_place(&self, low: &Float, high: &Float, below: &Float, above: &Float, step: u32) -> Float {
        let middle = self.scope.float(low + high) / 2;
        if step.is_multiple_of(3) {
            return middle;
        }
        let width = self.scope.float(high - low);
        let place = self.scope.float(high - width * above / self.scope.float(above - below));
        if place > *low && place < *high { place } else { middle }
    }
}
