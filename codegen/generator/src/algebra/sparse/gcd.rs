//! Greatest common divisors by primitive remainder sequences.
//!
//! They are taken in one variable, and contents are those of the coefficients in the others: Knuth, algorithm 4.6.1E; von
//! zur Gathen and Gerhard, section 6.12.

use super::arithmetic::Sparse;
use super::univariate::Field;
use crate::algebra::Var;
use num_bigint::BigInt;

/// A greatest common divisor, with coprime integers for coefficients.
pub fn gcd(a: &Sparse, b: &Sparse) -> Sparse {
    let (a, b) = (a.integral(), b.integral());
    if a.is_zero() || b.is_zero() {
        return a.plus(&b);
    }
    if a.quotient(&b).is_some() {
        return b;
    }
    if b.quotient(&a).is_some() {
        return a;
    }
    if let Some(var) = a.variables().into_iter().find(|&var| b.degree(var) == 0) {
        return gcd(&content(&a, var), &b);
    }
    if let Some(var) = b.variables().into_iter().find(|&var| a.degree(var) == 0) {
        return gcd(&a, &content(&b, var));
    }
    // what is left has the same variables; no common factor contains one in which an image shows none
    let open = a.variables().into_iter().filter(|&var| !is_free_of(&a, &b, var));
    match open.min_by_key(|&var| a.degree(var).max(b.degree(var))) {
        Some(var) => by_remainders(&a, &b, var),
        None => a.integer(1),
    }
}

/// The greatest common divisor of the coefficients of the powers of a variable.
pub fn content(polynomial: &Sparse, var: Var) -> Sparse {
    let one = polynomial.integer(1);
    let mut common = Sparse::zero(polynomial.size());
    let mut coefficients = polynomial.coefficients(var);
    coefficients.sort_by_key(Sparse::count);
    for coefficient in coefficients.iter().filter(|coefficient| !coefficient.is_zero()) {
        common = gcd(&common, coefficient);
        if common == one {
            break;
        }
    }
    common
}

/// The polynomial without its content in a variable, and that.
pub fn split_content(polynomial: &Sparse, var: Var) -> (Sparse, Sparse) {
    let content = content(polynomial, var);
    let primitive = polynomial.quotient(&content).expect("a polynomial is a multiple of its content");
    (content, primitive.integral())
}

fn by_remainders(a: &Sparse, b: &Sparse, var: Var) -> Sparse {
    let ((content_of_a, mut a), (content_of_b, mut b)) = (split_content(a, var), split_content(b, var));
    if a.degree(var) < b.degree(var) {
        std::mem::swap(&mut a, &mut b);
    }
    while b.degree(var) > 0 {
        let rest = pseudo_remainder(&a, &b, var);
        (a, b) = (b, if rest.is_zero() { rest } else { split_content(&rest, var).1 });
    }
    let common = gcd(&content_of_a, &content_of_b);
    if b.is_zero() { common.times(&a).integral() } else { common }
}

/// The remainder of a multiple of `a` by a power of the leading coefficient of `b`: Knuth, algorithm 4.6.1R.
fn pseudo_remainder(a: &Sparse, b: &Sparse, var: Var) -> Sparse {
    let (mut rest, divisor) = (a.coefficients(var), b.coefficients(var));
    let Some((leading, lower)) = divisor.split_last() else { return a.clone() };
    while rest.len() > lower.len() {
        let Some(highest) = rest.pop() else { break };
        let shift = rest.len() - lower.len();
        rest.iter_mut().for_each(|coefficient| *coefficient = coefficient.times(leading));
        for (place, coefficient) in rest[shift..].iter_mut().zip(lower) {
            *place = place.minus(&highest.times(coefficient));
        }
        while rest.last().is_some_and(Sparse::is_zero) {
            rest.pop();
        }
    }
    Sparse::of_coefficients(a.size(), &rest, var)
}

/// Whether an image modulo a prime, with numbers in place of the other variables, shows that no common factor contains
/// the variable: a factor keeps its degree where the leading coefficient does not vanish.
fn is_free_of(a: &Sparse, b: &Sparse, var: Var) -> bool {
    let field = Field::smallest();
    let image = |polynomial: &Sparse| field.polynomial(&polynomial.coefficients(var), image_of_variable);
    let (image_of_a, image_of_b) = (image(a), image(b));
    image_of_a.len() == usize::from(a.degree(var)) + 1 && field.gcd(&image_of_a, &image_of_b).len() == 1
}

/// A number in place of a variable: any will do, and small ones are more often zeros.
fn image_of_variable(var: Var) -> BigInt {
    BigInt::from(1_000_003_u64) * (var.0 as u64 * var.0 as u64 + 7_919)
}
