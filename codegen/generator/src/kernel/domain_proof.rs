//! Proofs: the Rust text of a kernel lets in what its contract does, exactly.
//!
//! Each `require!` is read back and must hold where the condition of the same text does, given those before it; a
//! condition that is not required must hold wherever the others do, and so must one that is required besides.

use super::error::KernelError;
use super::formula::Formula;
use super::known::{Effort, Known};
use super::read_back::Reader;
use crate::algebra::Algebra;
use crate::field::{Sign, Tower};
use closedform_project::contract::KernelContract;
use closedform_project::expression::Expr;
use closedform_syntax::{BinaryOp, Condition, Expr as Source, Kernel as SourceKernel, Require};
use thiserror::Error;

/// What of a domain is not proved.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Gap {
    /// A condition of the contract that the text does not ask for.
    #[error("`{0}` is not required, and does not follow from what is")]
    Missing(String),
    /// A condition that is another one than its text says.
    #[error("what is required as `{0}` is another condition")]
    Different(String),
    /// A condition that the contract does not have.
    #[error("`{0}` is required, which is no condition of the contract and does not follow from them")]
    Extra(String),
    /// A condition without a canonical form.
    #[error(transparent)]
    NoForm(#[from] KernelError),
}

/// Proves that the conditions of a text and of a contract hold at the same inputs.
///
/// # Errors
/// When that is not shown.
pub fn prove(algebra: Algebra, source: &SourceKernel, contract: &KernelContract) -> Result<(), Gap> {
    let proof = Proof { tower: Tower::new(algebra, &contract.inputs), reader: Reader::new(source, &contract.inputs) };
    proof.prove(source, contract)
}

struct Proof<'k> {
    tower: Tower,
    reader: Reader<'k>,
}

impl<'k> Proof<'k> {
    fn prove(mut self, source: &'k SourceKernel, contract: &KernelContract) -> Result<(), Gap> {
        let mut known = Known::new(&self.tower);
        let mut open: Vec<&Require> = source.requires.iter().collect();
        for stated in contract.domain.stated() {
            let text = &stated.text;
            let promised = Formula::of(&mut self.tower, &stated.condition, text)?;
            match open.iter().position(|require| require.text == *text) {
                Some(position) => {
                    let required = self.required(&open.remove(position).condition, text)?;
                    if !(known.implies(&promised, &required) && known.implies(&required, &promised)) {
                        return Err(Gap::Different(text.clone()));
                    }
                }
                None => {
                    let effort = if stated.natural { Effort::Search } else { Effort::Quick };
                    if !known.shows(&promised, effort) {
                        return Err(Gap::Missing(text.clone()));
                    }
                }
            }
            known.learn(&promised);
        }
        for require in open {
            if !known.shows(&self.required(&require.condition, &require.text)?, Effort::Quick) {
                return Err(Gap::Extra(require.text.clone()));
            }
        }
        Ok(())
    }

    fn required(&mut self, condition: &'k Condition, text: &str) -> Result<Formula, Gap> {
        self.turned(condition, true, text)
    }

    /// That a condition of the text holds, or that it does not.
    fn turned(&mut self, condition: &'k Condition, holds: bool, text: &str) -> Result<Formula, Gap> {
        match (condition, holds) {
            (Condition::Not(inner), _) => self.turned(inner, !holds, text),
            (Condition::And(left, right), true) | (Condition::Or(left, right), false) => {
                Ok(Formula::And(vec![self.turned(left, holds, text)?, self.turned(right, holds, text)?]))
            }
            (Condition::Or(left, right), true) | (Condition::And(left, right), false) => {
                Ok(Formula::Or(vec![self.turned(left, holds, text)?, self.turned(right, holds, text)?]))
            }
            (Condition::Compare { op, left, right }, _) => {
                let difference = self.difference([left, right]).ok_or_else(|| Gap::Different(text.to_owned()))?;
                let sign = Sign::of_relation(if holds { *op } else { op.negated() });
                Ok(Formula::literal(&mut self.tower, &difference, sign, text)?)
            }
        }
    }

    /// The difference of the sides of a comparison, if both are polynomials in the inputs: anything else may have no value.
    fn difference(&self, sides: [&'k Source; 2]) -> Option<Expr> {
        let way = self.reader.ways(&sides, 1).ok()?.pop()?;
        let [left, right] = <[Expr; 2]>::try_from(way.values).ok()?;
        sides.into_iter().all(is_polynomial).then(|| left.minus(right))
    }
}

fn is_polynomial(side: &Source) -> bool {
    !side.any(&mut |part| match part {
        Source::Literal { .. } | Source::Name(_) | Source::Neg(_) | Source::Compensated(_) => false,
        Source::Binary { op: BinaryOp::Div, right, .. } => !matches!(**right, Source::Literal { .. }),
        Source::Binary { .. } => false,
        _ => true,
    })
}
