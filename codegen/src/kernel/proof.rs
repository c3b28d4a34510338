//! Proofs: the Rust text of a kernel equals its reference expressions, exactly.
//!
//! The text is read back, so that what is proved is what is compiled. Every branch of the program must equal the
//! reference; square roots are algebraic elements, literals the exact numbers that they are.

use super::{KernelError, WORK, domain, written};
use crate::algebra::{TooMuchWork, limited};
use crate::expression::{Expr, lower};
use crate::field::{Tower, TowerError};
use crate::stable::builder::Builder;
use crate::worksheet::contract::KernelContract;
use closedform_maxima::Definition;
use closedform_syntax::{BinaryOp, Expr as Source, Kernel as SourceKernel, Precision};
use num_rational::BigRational;
use thiserror::Error;

/// Why a kernel is not proved.
#[derive(Debug, Error)]
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
    /// The reference has no canonical form.
    #[error(transparent)]
    Reference(#[from] KernelError),
}

/// The name under which the iterate of a polynomial root is known in expressions.
const ITERATE: &str = "%iterate";

/// Proves that a kernel equals its reference expressions.
///
/// # Errors
/// When it does not, or when either side has no canonical form.
pub fn prove(source: &SourceKernel, contract: &KernelContract, references: &[Definition]) -> Result<(), ProofError> {
    if source.meta.precision == Precision::Certified {
        return prove_as_written(source, contract, references);
    }
    limited(WORK, || prove_equal(source, contract, references))
        .unwrap_or_else(|TooMuchWork| Err(KernelError::TooMuchWork(contract.name.clone()).into()))
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
    let name = |references: &[Definition]| references.iter().map(|r| r.name.clone()).collect::<Vec<_>>().join("`, `");
    Err(ProofError::Different(contract.name.clone(), name(references)))
}

fn prove_equal(source: &SourceKernel, contract: &KernelContract, references: &[Definition]) -> Result<(), ProofError> {
    let choices = count_choices(source);
    for choice in 0..1_usize << choices.min(10) {
        let mut reader = Reader { inputs: &contract.inputs, choice, next: 0, roots: Vec::new(), slots: Vec::new() };
        let outputs = reader.outputs(source);
        for (output, reference) in outputs.iter().zip(references) {
            let equal = match lower(&reference.body).map_err(KernelError::Lower)? {
                Expr::PositiveRoot { polynomial, unknown } => {
                    same_root(contract, output, &reader.roots, (&polynomial, &unknown))
                }
                expression => same_value(contract, output, &expression),
            };
            let kernel = source.name.to_string();
            if !equal? {
                return Err(ProofError::Different(kernel, reference.name.clone()));
            }
        }
    }
    Ok(())
}

fn tower(contract: &KernelContract) -> Result<Tower, KernelError> {
    let mut builder = Builder::new(Tower::new(&contract.inputs));
    domain::learn_all(&mut builder, &contract.domain)?;
    Ok(builder.tower)
}

fn same_value(contract: &KernelContract, output: &Expr, reference: &Expr) -> Result<bool, ProofError> {
    if let Expr::Extreme { largest, items } = reference {
        return same_extreme(contract, output, *largest, items);
    }
    let mut tower = tower(contract)?;
    let no_form = |cause| ProofError::NoForm { kernel: contract.name.clone(), cause };
    let expected = tower.canonical(reference).map_err(no_form)?;
    let actual = tower.canonical(output).map_err(no_form)?;
    Ok(expected == actual)
}

/// The same choice, of values that are the same one by one.
fn same_extreme(
    contract: &KernelContract,
    output: &Expr,
    largest: bool,
    expected: &[Expr],
) -> Result<bool, ProofError> {
    let Expr::Extreme { largest: found, items } = output else { return Ok(false) };
    let mut same = *found == largest && items.len() == expected.len();
    for (item, expected) in items.iter().zip(expected) {
        same = same && same_value(contract, item, expected)?;
    }
    Ok(same)
}

/// The iterate's polynomial is the reference's, and the result leaves a root of it where it is.
fn same_root(
    contract: &KernelContract,
    output: &Expr,
    roots: &[Expr],
    (polynomial, unknown): (&Expr, &str),
) -> Result<bool, ProofError> {
    let [iterated] = roots else { return Ok(false) };
    let mut tower = tower(contract)?;
    let no_form = |cause| ProofError::NoForm { kernel: contract.name.clone(), cause };
    let (expected, var) = tower.polynomial_in(polynomial, unknown).map_err(no_form)?;
    tower.name_unknown(ITERATE, var);
    let iterated = tower.canonical(iterated).map_err(no_form)?;
    let same = iterated.numerator.primitive().1 == expected.primitive().1;
    let moved = Expr::symbol(ITERATE).minus(output.clone());
    let moved = tower.canonical(&moved).map_err(no_form)?;
    Ok(same && moved.numerator.divided_by(&expected).is_some())
}

fn count_choices(source: &SourceKernel) -> usize {
    let values = source.lets.iter().map(|step| &step.value).chain(source.output.values());
    values.map(choices_in).sum()
}

fn choices_in(expr: &Source) -> usize {
    match expr {
        Source::Literal { .. } | Source::Name(_) | Source::Pi(_) => 0,
        Source::Neg(a) | Source::Sqrt(a) | Source::Abs(a) | Source::Residual(a) => choices_in(a),
        Source::Compensated(_) => 0,
        Source::Binary { left, right, .. } => choices_in(left) + choices_in(right),
        Source::If { then, otherwise, .. } => 1 + choices_in(then) + choices_in(otherwise),
        Source::Extreme { items: list, .. } | Source::PositiveRoot(list) => list.iter().map(choices_in).sum(),
    }
}

/// Reads one straight line through a kernel: bit k of `choice` decides its k-th `if`.
struct Reader<'a> {
    inputs: &'a [String],
    choice: usize,
    next: usize,
    /// The polynomials of polynomial roots, in the iterate.
    roots: Vec<Expr>,
    slots: Vec<Expr>,
}

impl Reader<'_> {
    fn outputs(&mut self, source: &SourceKernel) -> Vec<Expr> {
        self.slots = self.inputs.iter().map(|name| Expr::symbol(name)).collect();
        for step in &source.lets {
            let value = self.value(&step.value);
            self.slots.push(value);
        }
        source.output.values().map(|value| self.value(value)).collect()
    }

    fn value(&mut self, expr: &Source) -> Expr {
        match expr {
            Source::Literal { value, .. } => {
                Expr::Rational(BigRational::from_float(*value).unwrap_or_else(|| BigRational::from_integer(0.into())))
            }
            Source::Name(name) => self.slots[name.slot].clone(),
            Source::Pi(_) => Expr::Pi,
            Source::Neg(a) => self.value(a).negated(),
            Source::Sqrt(a) => Expr::Sqrt(Box::new(self.value(a))),
            Source::Abs(a) => Expr::Abs(Box::new(self.value(a))),
            Source::Compensated(slice) => self.value(&slice.value),
            Source::Residual(a) => self.value(a),
            Source::Binary { op, left, right } => {
                let (left, right) = (self.value(left), self.value(right));
                match op {
                    BinaryOp::Add => left.plus(right),
                    BinaryOp::Sub => left.minus(right),
                    BinaryOp::Mul => left.times(right),
                    BinaryOp::Div => left.over(right),
                }
            }
            Source::If { then, otherwise, .. } => {
                let take = self.choice >> self.next & 1 == 0;
                self.next += 1;
                let (then, otherwise) = (self.value(then), self.value(otherwise));
                if take { then } else { otherwise }
            }
            Source::Extreme { largest, items } => {
                Expr::Extreme { largest: *largest, items: items.iter().map(|item| self.value(item)).collect() }
            }
            Source::PositiveRoot(coefficients) => {
                let terms = coefficients.iter().enumerate().map(|(power, coefficient)| {
                    let coefficient = self.value(coefficient);
                    coefficient.times(Expr::Power(Box::new(Expr::symbol(ITERATE)), power as i32))
                });
                let polynomial = Expr::Sum(terms.collect());
                self.roots.push(polynomial);
                Expr::symbol(ITERATE)
            }
        }
    }
}
