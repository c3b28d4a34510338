//! Whether two expressions are the same real function: as quotients of polynomials in inputs, roots and opaque values.

use crate::case::Case;
use crate::count::Counter;
use crate::forms::{Forms, Meaning, TERMS};
use crate::polynomial::{Atom, Polynomial};
use crate::sign::Sign;
use closedform_syntax::Expr;

/// Whether two expressions have the same form, or a difference that vanishes once it is cleared of quotients, none of
/// which divides by zero where the case holds.
///
/// Roots count as independent of each other but for their squares, so that some functions that are the same are not
/// shown to be.
pub fn same_function<'k>(counter: &Counter<'k>, one: &'k Expr, other: &'k Expr, case: &Case) -> bool {
    let difference = counter.forms.of(one).minus(&counter.forms.of(other));
    let Some((numerator, divisors)) = cleared(&counter.forms, difference) else { return false };
    let divides = |divisor: &Polynomial| counter.sign_of_form(divisor, case).is(Sign::NONZERO);
    numerator.is_zero() && divisors.iter().all(divides)
}

/// A polynomial times what clears it of quotients, and all that those divide by; `None` where it grows too large.
fn cleared(forms: &Forms, mut polynomial: Polynomial) -> Option<(Polynomial, Vec<Polynomial>)> {
    let mut divisors = Vec::new();
    // what a quotient is made of came before it: where the last one goes first, none comes back
    while let Some((atom, numerator, denominator)) = last_quotient(forms, &polynomial) {
        polynomial = without(forms, &polynomial, atom, [&numerator, &denominator])?;
        divisors.push(denominator);
    }
    Some((polynomial, divisors))
}

fn last_quotient(forms: &Forms, polynomial: &Polynomial) -> Option<(Atom, Polynomial, Polynomial)> {
    polynomial.atoms().into_iter().rev().find_map(|atom| match forms.meaning(atom) {
        Meaning::Quotient(numerator, denominator) => Some((atom, numerator, denominator)),
        _ => None,
    })
}

/// The polynomial with a quotient for an atom, times the power of the denominator that this asks for.
fn without(forms: &Forms, polynomial: &Polynomial, atom: Atom, quotient: [&Polynomial; 2]) -> Option<Polynomial> {
    let [numerator, denominator] = quotient;
    let degree = polynomial.degree(atom) as usize;
    let mut sum = Polynomial::default();
    for (power, coefficient) in polynomial.coefficients(atom).into_iter().enumerate() {
        let factors = [vec![numerator; power], vec![denominator; degree - power]].concat();
        sum = sum.plus(&factors.into_iter().try_fold(coefficient, |term, factor| product(forms, &term, factor))?);
    }
    Some(sum)
}

/// The product, if it is not too large.
fn product(forms: &Forms, a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    (a.size() * b.size() <= TERMS).then(|| forms.reduced(&a.times(b)))
}
