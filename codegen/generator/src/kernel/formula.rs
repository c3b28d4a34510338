//! Formulas about signs of polynomials: what conditions say where their sides have values.

use super::error::KernelError;
use crate::algebra::Polynomial;
use crate::field::{Sign, Tower};
use closedform_project::domain::{Comparison, Condition};
use closedform_project::expression::Expr;

/// The most clauses that a formula is split into; one of more is not shown to imply anything.
const CLAUSES: usize = 256;

/// That a polynomial is of a sign.
#[derive(Clone, Debug)]
pub struct Literal {
    /// The polynomial.
    pub polynomial: Polynomial,
    /// Its possible signs.
    pub sign: Sign,
}

/// Literals, joined.
#[derive(Clone, Debug)]
pub enum Formula {
    /// One literal.
    Literal(Literal),
    /// All hold.
    And(Vec<Formula>),
    /// One holds at least.
    Or(Vec<Formula>),
}

impl Literal {
    /// A text that equal literals share.
    pub fn key(&self) -> String {
        format!("{:?} is {:?}", self.polynomial.terms(), self.sign)
    }
}

impl Formula {
    /// A text that equal formulas share.
    pub fn key(&self) -> String {
        let joined = |name: &str, parts: &[Self]| {
            format!("{name}({})", parts.iter().map(Self::key).collect::<Vec<_>>().join(", "))
        };
        match self {
            Self::Literal(literal) => literal.key(),
            Self::And(parts) => joined("and", parts),
            Self::Or(parts) => joined("or", parts),
        }
    }

    /// A condition of a contract: a comparison holds where its divisors are not zero and its difference is of the sign.
    ///
    /// # Errors
    /// When a side of a comparison is no rational function of the inputs.
    pub fn of(tower: &mut Tower, condition: &Condition, text: &str) -> Result<Self, KernelError> {
        let mut all = |parts: &[Condition]| -> Result<Vec<Self>, KernelError> {
            parts.iter().map(|part| Self::of(tower, part, text)).collect()
        };
        match condition {
            Condition::And(parts) => Ok(Self::And(all(parts)?)),
            Condition::Or(parts) => Ok(Self::Or(all(parts)?)),
            Condition::Compare(comparison) => {
                let comparisons = comparison.divisors().iter().chain([comparison]);
                let parts = comparisons.map(|comparison| Self::compared(tower, comparison, text));
                Ok(Self::And(parts.collect::<Result<_, _>>()?))
            }
        }
    }

    fn compared(tower: &mut Tower, comparison: &Comparison, text: &str) -> Result<Self, KernelError> {
        Self::literal(tower, &comparison.difference(), Sign::of_relation(comparison.relation), text)
    }

    /// That an expression, where it has a value, is of a sign.
    ///
    /// # Errors
    /// When it has no canonical form.
    pub fn literal(tower: &mut Tower, expr: &Expr, sign: Sign, text: &str) -> Result<Self, KernelError> {
        let element = tower.canonical(expr);
        let element = element.map_err(|cause| KernelError::Domain { condition: text.to_owned(), cause })?;
        Ok(Self::Literal(Literal { polynomial: element.numerator.times(&element.denominator), sign }))
    }

    /// The formula that holds where this one does not.
    pub fn complement(&self) -> Self {
        let each = |parts: &[Self]| parts.iter().map(Self::complement).collect();
        match self {
            Self::Literal(Literal { polynomial, sign }) => {
                Self::Literal(Literal { polynomial: polynomial.clone(), sign: sign.complement() })
            }
            Self::And(parts) => Self::Or(each(parts)),
            Self::Or(parts) => Self::And(each(parts)),
        }
    }

    /// Lists of literals of which one holds where the formula does; `None` if there are too many.
    pub fn clauses(&self) -> Option<Vec<Vec<Literal>>> {
        match self {
            Self::Literal(literal) => Some(vec![vec![literal.clone()]]),
            Self::Or(parts) => {
                let clauses: Vec<_> = parts.iter().map(Self::clauses).collect::<Option<Vec<_>>>()?.concat();
                (clauses.len() <= CLAUSES).then_some(clauses)
            }
            Self::And(parts) => parts.iter().try_fold(vec![Vec::new()], |clauses: Vec<Vec<Literal>>, part| {
                let more = part.clauses()?;
                let joined =
                    clauses.iter().flat_map(|one| more.iter().map(move |other| [&one[..], &other[..]].concat()));
                (clauses.len() * more.len() <= CLAUSES).then(|| joined.collect())
            }),
        }
    }
}
