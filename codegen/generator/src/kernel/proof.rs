//! Proofs: the Rust text of a kernel equals its reference expressions, exactly.
//!
//! The text is read back, so that what is proved is what is compiled. On every way through the `if`s that it reads a
//! result must equal its reference, whichever way the conditions choose; an `if` whose sides are the same function is no
//! fork. Square roots are algebraic elements, literals the exact numbers that they are.

use super::error::KernelError;
use super::limit::within_limit;
use super::read_back::{ITERATE, Reader, TooManyWays, Way};
use super::{domain, domain_proof, written};
use crate::algebra::Algebra;
use crate::field::{Tower, TowerError};
use crate::stable::strategy;
use closedform_maxima::Definition;
use closedform_project::contract::KernelContract;
use closedform_project::expression::{Expr, lower};
use closedform_syntax::{Expr as Source, Kernel as SourceKernel, Output, Precision};
use thiserror::Error;

/// The most ways through a result that are looked at: `if`s that do not settle double them.
const WAYS: usize = 1 << 10;

/// Why a kernel is not proved.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProofError {
    /// The kernel computes something else.
    #[error("the Rust text of `{0}` is not equal to its reference expression `{1}`")]
    Different(String, String),
    /// The text has no canonical form.
    #[error("the Rust text of `{kernel}` {cause}")]
    NoForm {
        /// The kernel.
        kernel: String,
        /// Why.
        cause: TowerError,
    },
    /// The text has other inputs or results than the contract.
    #[error("the Rust text of `{kernel}` has the {what} `{found}`, and its contract `{expected}`")]
    Signature {
        /// The kernel.
        kernel: String,
        /// Inputs or results.
        what: &'static str,
        /// As the text has them.
        found: String,
        /// As the contract has them.
        expected: String,
    },
    /// More ways through a result than are looked at.
    #[error(
        "the Rust text of `{kernel}` is not proved equal to `{reference}`: the {choices} `if`s of different values that it \
         reads make more than {WAYS} ways; give its parts kernels of their own, or add the signs that decide them to the \
         domain"
    )]
    TooManyBranches {
        /// The kernel.
        kernel: String,
        /// The reference.
        reference: String,
        /// How many `if`s.
        choices: usize,
    },
    /// The text lets other inputs in.
    #[error("the Rust text of `{kernel}` does not decide its domain as the contract does: {cause}")]
    Domain {
        /// The kernel.
        kernel: String,
        /// What is not proved.
        cause: domain_proof::Gap,
    },
    /// The reference has no canonical form.
    #[error(transparent)]
    Reference(#[from] KernelError),
}

impl ProofError {
    /// Whether nothing was shown, because it takes more work than one formula may.
    #[must_use]
    pub fn is_beyond_limit(&self) -> bool {
        matches!(self, Self::Reference(KernelError::TooMuchWork(_)))
    }
}

/// Proves that a kernel equals its reference expressions on the domain of its contract.
///
/// # Errors
/// When it does not, or when either side has no canonical form.
pub fn prove(
    algebra: Algebra,
    source: &SourceKernel,
    contract: &KernelContract,
    references: &[Definition],
) -> Result<(), ProofError> {
    has_signature(source, contract, references)?;
    if source.meta.precision == Precision::Certified {
        return prove_as_written(source, contract, references);
    }
    within_limit(contract, || prove_equal(algebra, source, contract, references))
}

/// Step by step: of a kernel whose precision needs no stable form.
fn prove_as_written(
    source: &SourceKernel,
    contract: &KernelContract,
    references: &[Definition],
) -> Result<(), ProofError> {
    let failed = |cause| KernelError::Written { function: contract.name.clone(), cause };
    if written::same(source, contract, references).map_err(failed)? {
        return Ok(());
    }
    let names = references.iter().map(|reference| reference.name.clone()).collect::<Vec<_>>().join("`, `");
    Err(ProofError::Different(contract.name.clone(), names))
}

fn prove_equal(
    algebra: Algebra,
    source: &SourceKernel,
    contract: &KernelContract,
    references: &[Definition],
) -> Result<(), ProofError> {
    domain_proof::prove(algebra, source, contract)
        .map_err(|cause| ProofError::Domain { kernel: contract.name.clone(), cause })?;
    let mut reader = Reader::new(source, &contract.inputs);
    reader.settle(WAYS, |one, other| same_value(algebra, contract, one, other).unwrap_or(false));
    for (output, reference) in source.output.values().zip(references) {
        let expected = lower(&reference.body).map_err(KernelError::Lower)?;
        let proof = Proof { algebra, contract, reader: &reader, reference: &reference.name };
        if !proof.is_same(output, &expected)? {
            return Err(ProofError::Different(contract.name.clone(), reference.name.clone()));
        }
    }
    Ok(())
}

/// Inputs and results are as many as the contract's, in its order, under its names.
fn has_signature(
    source: &SourceKernel,
    contract: &KernelContract,
    references: &[Definition],
) -> Result<(), ProofError> {
    let inputs = source.inputs.iter().map(|input| input.maxima.clone().unwrap_or_else(|| input.name.to_string()));
    let worksheets = source.meta.results.iter().map(|result| result.worksheet.clone().unwrap_or_default());
    let promised = contract.results.iter().map(|result| result.worksheet.clone());
    same_names(contract, "inputs", inputs, contract.inputs.iter().cloned())?;
    same_names(contract, "results", worksheets, promised.clone())?;
    same_names(contract, "references", references.iter().map(|reference| reference.name.clone()), promised)?;
    match &source.output {
        Output::Value(_) => same_names(contract, "results", ["a number"], ["a number"].repeat(references.len())),
        Output::Struct { fields, .. } => {
            let fields = fields.iter().map(|(name, _)| name.to_string());
            same_names(contract, "fields", fields, contract.results.iter().map(|result| result.name.clone()))
        }
    }
}

fn same_names<F: Into<String>, E: Into<String>>(
    contract: &KernelContract,
    what: &'static str,
    found: impl IntoIterator<Item = F>,
    expected: impl IntoIterator<Item = E>,
) -> Result<(), ProofError> {
    let found = found.into_iter().map(Into::into).collect::<Vec<String>>().join(", ");
    let expected = expected.into_iter().map(Into::into).collect::<Vec<String>>().join(", ");
    if found == expected {
        return Ok(());
    }
    Err(ProofError::Signature { kernel: contract.name.clone(), what, found, expected })
}

/// The tower over the inputs, with what the domain says of signs.
fn tower(algebra: Algebra, contract: &KernelContract) -> Result<Tower, KernelError> {
    let mut builder = strategy::builder(Tower::new(algebra, &contract.inputs));
    domain::learn_all(&mut builder, &contract.domain)?;
    Ok(builder.tower)
}

/// Whether two expressions have the same canonical form.
fn same_value(algebra: Algebra, contract: &KernelContract, one: &Expr, other: &Expr) -> Result<bool, ProofError> {
    let mut tower = tower(algebra, contract)?;
    let no_form = |cause| ProofError::NoForm { kernel: contract.name.clone(), cause };
    let (one, other) = (tower.canonical(one).map_err(no_form)?, tower.canonical(other).map_err(no_form)?);
    Ok(one == other)
}

/// The proof of one result.
struct Proof<'a, 'k> {
    algebra: Algebra,
    contract: &'a KernelContract,
    reader: &'a Reader<'k>,
    /// The name of its reference.
    reference: &'a str,
}

impl<'k> Proof<'_, 'k> {
    /// Whether an expression of the text is this one; of a choice of extremes, whether the items are, one by one.
    fn is_same(&self, output: &'k Source, expected: &Expr) -> Result<bool, ProofError> {
        let Expr::Extreme { largest, items: expected } = expected else {
            return self.every_way(output, |way| match expected {
                Expr::PositiveRoot { polynomial, unknown } => self.is_root(way, polynomial, unknown),
                expected => same_value(self.algebra, self.contract, expected, &way.values[0]),
            });
        };
        let Source::Extreme { largest: found, items } = self.reader.resolved(output) else { return Ok(false) };
        let mut same = found == largest && items.len() == expected.len();
        for (item, expected) in items.iter().zip(expected) {
            same = same && self.is_same(item, expected)?;
        }
        Ok(same)
    }

    fn every_way(
        &self,
        output: &'k Source,
        holds: impl Fn(&Way) -> Result<bool, ProofError>,
    ) -> Result<bool, ProofError> {
        let ways =
            self.reader.ways(&[output], WAYS).map_err(|TooManyWays { choices }| ProofError::TooManyBranches {
                kernel: self.contract.name.clone(),
                reference: self.reference.to_owned(),
                choices,
            })?;
        ways.iter().try_fold(true, |same, way| Ok(same && holds(way)?))
    }

    /// The iterate's polynomial is the reference's, and the result leaves a root of it where it is.
    fn is_root(&self, way: &Way, polynomial: &Expr, unknown: &str) -> Result<bool, ProofError> {
        let [iterated] = &way.roots[..] else { return Ok(false) };
        let mut tower = tower(self.algebra, self.contract)?;
        let no_form = |cause| ProofError::NoForm { kernel: self.contract.name.clone(), cause };
        let (expected, var) = tower.polynomial_in(polynomial, unknown).map_err(no_form)?;
        tower.name_unknown(ITERATE, var);
        let iterated = tower.canonical(iterated).map_err(no_form)?;
        let same = iterated.numerator.primitive().1 == expected.primitive().1;
        let moved = Expr::symbol(ITERATE).minus(way.values[0].clone());
        let moved = tower.canonical(&moved).map_err(no_form)?;
        Ok(same && moved.numerator.divided_by(&expected).is_some())
    }
}
