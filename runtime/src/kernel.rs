//! Kernels as values: what tools call that know no kernel by name.

use core::fmt;

#[cfg(feature = "mpfr")]
use closedform_arith::Mpfr;
use closedform_arith::Real;

use crate::error::{CallError, LengthError};
use crate::info::Info;
use crate::shape::{checked, faithful, single, value};

/// The program of a kernel of `N` inputs, `K` conditions and `M` results; implemented by `#[kernel]`.
pub trait Program<const N: usize, const K: usize, const M: usize> {
    /// What is known of the kernel.
    const INFO: &'static Info;

    /// The results in any arithmetic, whether or not the inputs lie in the domain.
    fn evaluate<R: Real>(inputs: &[R; N]) -> [R; M];

    /// Whether each condition of the domain holds, in any arithmetic.
    fn domain<R: Real>(inputs: &[R; N]) -> [bool; K];

    /// The results in `f64` for slices of equal length.
    fn batch(inputs: [&[f64]; N], results: [&mut [f64]; M]) -> Result<(), LengthError>;
}

/// A kernel as a value, called by slices: `inputs` in the order of [`Info::inputs`], `results` in that of
/// [`Info::results`]. No call allocates or panics.
#[derive(Clone, Copy)]
pub struct Kernel {
    /// What is known of it.
    pub info: &'static Info,
    default: fn(&[f64], &mut [f64]) -> Result<(), LengthError>,
    faithful: fn(&[f64], &mut [f64]) -> Result<(), LengthError>,
    checked: fn(&[f64], &mut [f64]) -> Result<(), CallError>,
    batch: Batch,
    single: fn(&[f32], &mut [f32]) -> Result<(), LengthError>,
    #[cfg(feature = "mpfr")]
    mpfr: fn(&[Mpfr], &mut [Mpfr]) -> Result<(), LengthError>,
}

type Batch = fn(&[&[f64]], &mut [&mut [f64]]) -> Result<(), LengthError>;

impl Kernel {
    /// The kernel of the program `P`.
    pub const fn of<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>() -> Self {
        Kernel {
            info: P::INFO,
            default: |inputs, results| by_slices(P::INFO, inputs, results, value::<P, N, K, M>),
            faithful: |inputs, results| by_slices(P::INFO, inputs, results, faithful::<P, N, K, M>),
            checked: |inputs, results| store(P::INFO, checked::<P, N, K, M>(fixed(P::INFO, inputs)?)?, results),
            batch: |inputs, results| {
                let inputs = fixed(P::INFO, inputs)?;
                let results = fixed_mut(P::INFO, results)?;
                P::batch(*inputs, results.each_mut().map(|result| &mut **result))
            },
            single: |inputs, results| by_slices(P::INFO, inputs, results, single::<P, N, K, M>),
            #[cfg(feature = "mpfr")]
            mpfr: |inputs, results| by_slices(P::INFO, inputs, results, P::evaluate::<Mpfr>),
        }
    }

    /// The results, each NaN outside the domain.
    pub fn eval(&self, inputs: &[f64], results: &mut [f64]) -> Result<(), LengthError> {
        (self.default)(inputs, results)
    }

    /// The results computed in double-double and rounded once, NaN outside the domain: with an error of less than one
    /// ulp where [`ResultInfo::bound_ulp`](crate::ResultInfo::bound_ulp) is known, which takes a proof.
    pub fn faithful(&self, inputs: &[f64], results: &mut [f64]) -> Result<(), LengthError> {
        (self.faithful)(inputs, results)
    }

    /// The results, or the condition that the inputs violate, or the result that `f64` cannot hold.
    pub fn checked(&self, inputs: &[f64], results: &mut [f64]) -> Result<(), CallError> {
        (self.checked)(inputs, results)
    }

    /// The results of many points, one slice an input and one a result, bit for bit those of [`eval`](Self::eval).
    pub fn batch(&self, inputs: &[&[f64]], results: &mut [&mut [f64]]) -> Result<(), LengthError> {
        (self.batch)(inputs, results)
    }

    /// The results in single precision: evaluated in `f64` and rounded once.
    pub fn f32(&self, inputs: &[f32], results: &mut [f32]) -> Result<(), LengthError> {
        (self.single)(inputs, results)
    }

    /// The results of the same program in MPFR, whether or not the inputs lie in the domain.
    #[cfg(feature = "mpfr")]
    pub fn mpfr(&self, inputs: &[Mpfr], results: &mut [Mpfr]) -> Result<(), LengthError> {
        (self.mpfr)(inputs, results)
    }
}

impl fmt::Debug for Kernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Kernel").field(&self.info.name).finish()
    }
}

/// Calls `evaluate` with slices in place of arrays.
fn by_slices<T, const N: usize, const M: usize>(
    info: &'static Info,
    inputs: &[T],
    results: &mut [T],
    evaluate: fn(&[T; N]) -> [T; M],
) -> Result<(), LengthError> {
    store(info, evaluate(fixed(info, inputs)?), results)
}

/// Moves `values` to `results`.
fn store<T, E: From<LengthError>, const M: usize>(
    info: &'static Info,
    values: [T; M],
    results: &mut [T],
) -> Result<(), E> {
    *fixed_mut(info, results)? = values;
    Ok(())
}

/// The inputs, if they are `N`.
fn fixed<'a, T, const N: usize>(info: &'static Info, inputs: &'a [T]) -> Result<&'a [T; N], LengthError> {
    let found = inputs.len();
    inputs.try_into().map_err(|_| LengthError { kernel: info.name, name: "inputs", expected: N, found })
}

/// The results, if they are `M`.
fn fixed_mut<'a, T, const M: usize>(info: &'static Info, results: &'a mut [T]) -> Result<&'a mut [T; M], LengthError> {
    let found = results.len();
    results.try_into().map_err(|_| LengthError { kernel: info.name, name: "results", expected: M, found })
}
