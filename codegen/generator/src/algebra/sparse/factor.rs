//! Irreducible factors over the rationals: contents, then parts without repeated factors, then the factors of those.
//!
//! Knuth, section 4.6.2; von zur Gathen and Gerhard, section 14.6 (Yun) and chapter 15.

use super::arithmetic::Sparse;
use super::gcd::{gcd, split_content};
use super::recombine;
use crate::algebra::Var;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// The irreducible factors and their exponents, and a constant among them, whose product is the polynomial.
pub fn factors(polynomial: &Sparse) -> Vec<(Sparse, u32)> {
    let mut found = integral_factors(polynomial);
    let leading = |factor: &Sparse| factor.leading().map_or_else(BigRational::zero, |(_, leading)| leading.clone());
    let powers = found.iter().map(|(factor, exponent)| num_traits::pow(leading(factor), *exponent as usize));
    let constant = powers.fold(leading(polynomial), |constant, power| constant / power);
    found.push((polynomial.constant(&constant), 1));
    found
}

/// The factors that are no constants; the product is the polynomial but for one.
fn integral_factors(polynomial: &Sparse) -> Vec<(Sparse, u32)> {
    let mut found = Vec::new();
    let mut rest = polynomial.integral();
    for var in polynomial.variables() {
        let power = rest.terms.keys().map(|exponents| exponents[var.0]).min().unwrap_or(0);
        if power > 0 {
            found.push((rest.variable(var, 1), power.into()));
            rest = rest.quotient(&rest.variable(var, power)).expect("every term has this power of the variable");
        }
    }
    for var in rest.variables() {
        let (content, primitive) = split_content(&rest, var);
        found.extend(integral_factors(&content));
        rest = primitive;
    }
    if let Some(var) = least_variable(&rest) {
        for (part, exponent) in without_repeats(&rest, var) {
            found.extend(irreducibles(&part).into_iter().map(|factor| (factor, exponent)));
        }
    }
    found
}

/// The variable of least degree.
pub fn least_variable(polynomial: &Sparse) -> Option<Var> {
    polynomial.variables().into_iter().min_by_key(|&var| polynomial.degree(var))
}

/// The products of the factors of each exponent, of a polynomial that is primitive in the variable: Yun.
fn without_repeats(polynomial: &Sparse, var: Var) -> Vec<(Sparse, u32)> {
    let exact = |a: &Sparse, b: &Sparse| a.quotient(b).expect("a greatest common divisor divides");
    let slope = derivative(polynomial, var);
    let common = gcd(polynomial, &slope);
    let (mut rest, mut slope) = (exact(polynomial, &common), exact(&slope, &common));
    let mut parts = Vec::new();
    for exponent in 1.. {
        let difference = slope.minus(&derivative(&rest, var));
        let part = gcd(&rest, &difference);
        (rest, slope) = (exact(&rest, &part), exact(&difference, &part));
        if !part.is_constant() {
            parts.push((part, exponent));
        }
        if rest.is_constant() {
            break;
        }
    }
    parts
}

fn derivative(polynomial: &Sparse, var: Var) -> Sparse {
    let coefficients = polynomial.coefficients(var).into_iter().zip(0..).skip(1);
    let slopes: Vec<Sparse> =
        coefficients.map(|(c, power)| c.scaled(&BigRational::from_integer(power.into()))).collect();
    Sparse::of_coefficients(polynomial.size(), &slopes, var)
}

/// The factors of a polynomial without repeated ones that is primitive in each of its variables.
fn irreducibles(polynomial: &Sparse) -> Vec<Sparse> {
    let Some(var) = least_variable(polynomial) else { return Vec::new() };
    if let Some(dehomogenised) = without_homogeneity(polynomial) {
        return dehomogenised;
    }
    match polynomial.degree(var) {
        1 => vec![polynomial.clone()],
        2 => factors_of_quadratic(polynomial, var),
        _ if has_irreducible_image(polynomial, var) => vec![polynomial.clone()],
        _ => recombine::factors(polynomial),
    }
}

/// The factors of a homogeneous polynomial in several variables, by those of what it is with 1 in place of one of them.
fn without_homogeneity(polynomial: &Sparse) -> Option<Vec<Sparse>> {
    let total = |exponents: &[u16]| exponents.iter().sum::<u16>();
    let degree = polynomial.leading().map(|(exponents, _)| total(exponents))?;
    if polynomial.variables().len() < 2 || polynomial.terms.keys().any(|exponents| total(exponents) != degree) {
        return None;
    }
    let var = polynomial.variables().into_iter().max_by_key(|&var| polynomial.degree(var))?;
    let homogeneous = |factor: Sparse| {
        let degree = factor.terms.keys().map(|exponents| total(exponents)).max().unwrap_or(0);
        let mut made = Sparse::zero(factor.size());
        for (exponents, coefficient) in factor.terms {
            let mut exponents = exponents;
            exponents[var.0] = degree - total(&exponents);
            made.insert(exponents, coefficient);
        }
        made
    };
    Some(irreducibles(&polynomial.at(var, &BigInt::from(1))).into_iter().map(homogeneous).collect())
}

/// The factors of `a*v^2 + b*v + c`, which are two where its discriminant is a square.
fn factors_of_quadratic(polynomial: &Sparse, var: Var) -> Vec<Sparse> {
    let [c, b, a] = &polynomial.coefficients(var)[..] else { return vec![polynomial.clone()] };
    let discriminant = b.times(b).minus(&a.times(c).times(&a.integer(4)));
    let Some(root) = square_root(&discriminant) else { return vec![polynomial.clone()] };
    let multiple = a.times(&a.integer(2)).times(&a.variable(var, 1)).plus(b).minus(&root);
    let factor = split_content(&multiple, var).1;
    let other = polynomial.quotient(&factor).expect("a root has its linear factor");
    vec![factor, other.integral()]
}

/// The polynomial whose square this is, by its terms from the leading one.
fn square_root(square: &Sparse) -> Option<Sparse> {
    let (exponents, coefficient) = square.leading()?;
    let halves: Option<Vec<u16>> =
        exponents.iter().map(|exponent| (exponent % 2 == 0).then_some(exponent / 2)).collect();
    let leading = Sparse::term(&root_of_rational(coefficient)?, &halves?);
    let highest: Vec<u16> = (0..square.size()).map(|var| square.degree(Var(var)) / 2).collect();
    let mut root = leading.clone();
    loop {
        let rest = square.minus(&root.times(&root));
        let Some((exponents, coefficient)) = rest.leading() else { return Some(root) };
        let next =
            Sparse::term(coefficient, exponents).quotient(&leading.scaled(&BigRational::from_integer(2.into())))?;
        // the terms fall, and there are only so many below the highest exponents
        let (next_exponents, _) = next.leading()?;
        if next_exponents.iter().zip(&highest).any(|(exponent, highest)| exponent > highest) {
            return None;
        }
        root = root.plus(&next);
    }
}

fn root_of_rational(value: &BigRational) -> Option<BigRational> {
    let root = |value: &BigInt| Some(value.sqrt()).filter(|root| &(root * root) == value);
    if value.is_negative() {
        return None;
    }
    Some(BigRational::new(root(value.numer())?, root(value.denom())?))
}

/// How many images are tried before the polynomial is taken for one that has factors.
const IMAGES: i64 = 6;

/// Whether a polynomial is irreducible with some numbers in place of all variables but one: then it is so itself, where its
/// degree stays, since it is primitive (Hilbert has shown that there are such numbers).
fn has_irreducible_image(polynomial: &Sparse, var: Var) -> bool {
    let others: Vec<Var> = polynomial.variables().into_iter().filter(|&other| other != var).collect();
    let image = |attempt: i64| {
        let number = |place: usize| BigInt::from(attempt + 2) + BigInt::from(3 * place as i64 * (attempt - 2));
        others.iter().enumerate().fold(polynomial.clone(), |image, (place, &other)| image.at(other, &number(place)))
    };
    let images = if others.is_empty() { 0 } else { IMAGES };
    (0..images)
        .map(image)
        .any(|image| image.degree(var) == polynomial.degree(var) && recombine::factors(&image.integral()).len() == 1)
}
