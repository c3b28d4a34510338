//! Expressions as polynomials in inputs and in values that are none: roots, quotients, choices.

use crate::polynomial::{Atom, Polynomial};
use closedform_syntax::{BinaryOp, Expr, Function, Kernel};
use num_rational::BigRational;
use num_traits::Zero;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// What an atom stands for.
#[derive(Clone, Debug)]
pub enum Meaning<'k> {
    /// An input.
    Input,
    /// The circle constant.
    Pi,
    /// A function of a polynomial.
    Call(Function, Polynomial),
    /// A quotient of polynomials.
    Quotient(Polynomial, Polynomial),
    /// A value that only its expression tells: a choice, a polynomial's root, or more terms than are worth expanding.
    Opaque(&'k Expr),
}

/// How many terms a form may have before its expression counts as an atom.
pub const TERMS: usize = 3000;

/// The forms of a kernel's expressions.
pub struct Forms<'k> {
    kernel: &'k Kernel,
    meanings: RefCell<Vec<Meaning<'k>>>,
    steps: RefCell<HashMap<usize, Rc<Polynomial>>>,
}

impl<'k> Forms<'k> {
    /// None yet.
    pub fn new(kernel: &'k Kernel) -> Self {
        let meanings = kernel.inputs.iter().map(|_| Meaning::Input).collect();
        Self { kernel, meanings: RefCell::new(meanings), steps: RefCell::default() }
    }

    /// What stands behind a name, if not an input.
    pub fn step(&self, slot: usize) -> Option<&'k Expr> {
        let position = slot.checked_sub(self.kernel.inputs.len())?;
        self.kernel.lets.get(position).map(|step| &step.value)
    }

    /// What stands behind an expression that is only a name.
    pub fn resolved(&self, expr: &'k Expr) -> &'k Expr {
        match expr {
            Expr::Name(name) => self.step(name.slot).map_or(expr, |step| self.resolved(step)),
            _ => expr,
        }
    }

    /// What an atom stands for.
    pub fn meaning(&self, atom: Atom) -> Meaning<'k> {
        self.meanings.borrow().get(atom.0).cloned().unwrap_or(Meaning::Input)
    }

    /// The form of an expression.
    pub fn of(&self, expr: &'k Expr) -> Rc<Polynomial> {
        if let Expr::Name(name) = expr {
            return self.of_name(name.slot);
        }
        let form = match expr {
            Expr::Literal { value, .. } => Polynomial::constant(number(*value)),
            Expr::Pi(_) => self.atom(Meaning::Pi),
            Expr::Neg(inner) => self.of(inner).negated(),
            Expr::Binary { op: BinaryOp::Div, left, right } => self.quotient(&self.of(left), &self.of(right)),
            Expr::Binary { op, left, right } => self.joined(*op, &self.of(left), &self.of(right)),
            Expr::Call(function, inner) => self.atom(Meaning::Call(*function, (*self.of(inner)).clone())),
            Expr::Compensated(expression) => (*self.of(&expression.value)).clone(),
            Expr::Residual(inner) => (*self.of(inner)).clone(),
            Expr::If { then, otherwise, .. } => self.choice(expr, then, otherwise),
            Expr::Extreme { .. } | Expr::PositiveRoot(_) | Expr::Name(_) => self.atom(Meaning::Opaque(expr)),
        };
        Rc::new(if form.size() > TERMS { self.atom(Meaning::Opaque(expr)) } else { form })
    }

    fn of_name(&self, slot: usize) -> Rc<Polynomial> {
        if let Some(known) = self.steps.borrow().get(&slot) {
            return Rc::clone(known);
        }
        let form = self.step(slot).map_or_else(|| Rc::new(Polynomial::atom(Atom(slot))), |step| self.of(step));
        self.steps.borrow_mut().insert(slot, Rc::clone(&form));
        form
    }

    fn joined(&self, op: BinaryOp, left: &Polynomial, right: &Polynomial) -> Polynomial {
        match op {
            BinaryOp::Add => left.plus(right),
            BinaryOp::Sub => left.minus(right),
            _ => self.reduced(&left.times(right)),
        }
    }

    fn quotient(&self, numerator: &Polynomial, denominator: &Polynomial) -> Polynomial {
        let divisor = denominator.as_constant().filter(|value| !value.is_zero());
        if let Some(divisor) = divisor {
            return numerator.scaled(&divisor.recip());
        }
        let ((a, numerator), (b, denominator)) = (numerator.monic(), denominator.monic());
        if numerator.is_zero() {
            return numerator;
        }
        self.atom(Meaning::Quotient(numerator, denominator)).scaled(&(a / b))
    }

    fn choice(&self, expr: &'k Expr, then: &'k Expr, otherwise: &'k Expr) -> Polynomial {
        let (one, other) = (self.of(then), self.of(otherwise));
        if one == other { (*one).clone() } else { self.atom(Meaning::Opaque(expr)) }
    }

    /// Powers of roots are powers of what stands under them.
    pub fn reduced(&self, polynomial: &Polynomial) -> Polynomial {
        let root = polynomial.atoms().into_iter().find_map(|atom| {
            let Meaning::Call(function, radicand) = self.meaning(atom) else { return None };
            let degree = function.degree().filter(|degree| polynomial.degree(atom) >= *degree)?;
            Some((atom, degree, radicand))
        });
        let Some((atom, degree, radicand)) = root else { return polynomial.clone() };
        let terms = polynomial.coefficients(atom).into_iter().zip(0..).map(|(coefficient, power)| {
            coefficient.times(&radicand.power(power / degree)).times(&Polynomial::atom(atom).power(power % degree))
        });
        self.reduced(&terms.fold(Polynomial::default(), |sum, term| sum.plus(&term)))
    }

    fn atom(&self, meaning: Meaning<'k>) -> Polynomial {
        let mut meanings = self.meanings.borrow_mut();
        let known = meanings.iter().position(|known| same(known, &meaning));
        let position = known.unwrap_or(meanings.len());
        if known.is_none() {
            meanings.push(meaning);
        }
        Polynomial::atom(Atom(position))
    }
}

fn same(a: &Meaning, b: &Meaning) -> bool {
    match (a, b) {
        (Meaning::Pi, Meaning::Pi) => true,
        (Meaning::Call(f, a), Meaning::Call(g, b)) => f == g && a == b,
        (Meaning::Quotient(a, b), Meaning::Quotient(c, d)) => a == c && b == d,
        (Meaning::Opaque(a), Meaning::Opaque(b)) => std::ptr::eq(*a, *b),
        _ => false,
    }
}

/// A literal as the number that it is.
pub fn number(value: f64) -> BigRational {
    BigRational::from_float(value).unwrap_or_else(BigRational::zero)
}
