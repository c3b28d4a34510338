//! Derivatives of exact expressions.

use super::lower::lower;
use super::tree::Expr;
use closedform_maxima::parse_expression;
use closedform_syntax::Function;

impl Expr {
    /// The derivative by a variable; `None` where a function without one, a choice or a polynomial root depends on it.
    #[must_use]
    pub fn derivative(&self, by: &str) -> Option<Self> {
        if !self.symbols().contains(by) {
            return Some(Self::integer(0));
        }
        match self {
            Self::Rational(_) | Self::Pi => Some(Self::integer(0)),
            Self::Symbol(name) => Some(Self::integer(i64::from(name == by))),
            Self::Sum(items) => items.iter().map(|item| item.derivative(by)).collect::<Option<_>>().map(Self::Sum),
            Self::Product(items) => derivative_of_product(items, by),
            Self::Power(base, exponent) => Some(Self::Product(vec![
                Self::integer(i64::from(*exponent)),
                Self::Power(base.clone(), exponent - 1),
                base.derivative(by)?,
            ])),
            Self::Call(function, argument) => {
                let outer = derivative_of_function(*function)?.with_symbols(&[("x", argument), ("y", self)]);
                Some(argument.derivative(by)?.times(outer))
            }
            Self::Extreme { .. } | Self::Choice(..) | Self::PositiveRoot { .. } => None,
        }
    }
}

/// The derivative of a function of `x`, whose value is `y`. Its text in the kernel language is also one of Maxima's.
fn derivative_of_function(function: Function) -> Option<Expr> {
    let text = parse_expression(function.properties().derivative?).ok()?;
    lower(&text).ok()
}

fn derivative_of_product(items: &[Expr], by: &str) -> Option<Expr> {
    let mut terms = Vec::new();
    for (index, item) in items.iter().enumerate() {
        let mut factors = items.to_vec();
        factors[index] = item.derivative(by)?;
        terms.push(Expr::Product(factors));
    }
    Some(Expr::Sum(terms))
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;

    /// The value of an expression of rational operations at x = `at`.
    fn value(expr: &Expr, at: &BigRational) -> BigRational {
        match expr {
            Expr::Rational(number) => number.clone(),
            Expr::Symbol(_) => at.clone(),
            Expr::Sum(items) => items.iter().map(|item| value(item, at)).sum(),
            Expr::Product(items) => items.iter().map(|item| value(item, at)).product(),
            Expr::Power(base, exponent) => value(base, at).pow(*exponent),
            _ => panic!("{expr:?} has no rational value"),
        }
    }

    #[test]
    fn derivatives_are_exact() {
        let x = || Expr::symbol("x");
        // x^3/(x + 1), whose derivative at 2 is (2*8 + 3*4)/9
        let quotient = Expr::Power(Box::new(x()), 3).over(x().plus(Expr::integer(1)));
        let two = BigRational::from_integer(2.into());
        let slope = value(&quotient.derivative("x").unwrap(), &two);
        assert_eq!(slope, BigRational::new(28.into(), 9.into()));
        assert!(quotient.derivative("y").unwrap().is_zero());
        assert_eq!(Expr::call(Function::Abs, x()).derivative("x"), None);
    }

    #[test]
    fn every_derivative_of_the_table_is_read_and_is_that_of_a_power() {
        for function in Function::ALL.into_iter().filter(|function| function.properties().derivative.is_some()) {
            // with f = x^p, f' is p f/x; all at an argument whose value is known
            let Some((p, q)) = function.properties().exponent else { continue };
            let y = BigRational::from_integer(5.into());
            let x = y.pow((q / p) as i32);
            let number = |value: &BigRational| Expr::Rational(value.clone());
            let slope = derivative_of_function(function).unwrap();
            let slope = value(&slope.with_symbols(&[("x", &number(&x)), ("y", &number(&y))]), &y);
            assert_eq!(slope, y / x * BigRational::new(p.into(), q.into()), "{function:?}");
            let whole = Expr::call(function, Expr::symbol("x").times(Expr::integer(3))).derivative("x").unwrap();
            assert!(whole.symbols().contains("x"));
        }
    }
}
