//! Kernels as values: what tools call that know no kernel by name.

use core::fmt;

#[cfg(feature = "mpfr")]
use closedform_arith::Mpfr;
use closedform_arith::table::Table;

use crate::error::{CallError, LengthError};
use crate::fast::{fast, with_bound};
use crate::info::Info;
use crate::program::Program;
use crate::shape::{checked, faithful, single, value_apart};

/// A kernel as a value, called by slices: `inputs` in the order of [`Info::inputs`], `results` in that of
/// [`Info::results`]. No call allocates or panics.
#[derive(Clone, Copy)]
pub struct Kernel {
    /// What is known of it.
    pub info: &'static Info,
    table: Option<&'static Table<'static>>,
    default: fn(&[f64], &mut [f64]) -> Result<(), LengthError>,
    faithful: fn(&[f64], &mut [f64]) -> Result<(), LengthError>,
    checked: fn(&[f64], &mut [f64]) -> Result<(), CallError>,
    fast: fn(&[f64], &mut [f64]) -> Result<(), LengthError>,
    with_bound: WithBound,
    batch: Batch,
    fast_batch: Batch,
    single: fn(&[f32], &mut [f32]) -> Result<(), LengthError>,
    #[cfg(feature = "mpfr")]
    mpfr: fn(&[Mpfr], &mut [Mpfr]) -> Result<(), LengthError>,
}

type WithBound = fn(&[f64], &mut [f64], &mut [f64]) -> Result<(), LengthError>;
type Columns<const N: usize, const M: usize> = fn([&[f64]; N], [&mut [f64]; M]) -> Result<(), LengthError>;
type Batch = fn(&[&[f64]], &mut [&mut [f64]]) -> Result<(), LengthError>;

impl Kernel {
    /// The kernel of the program `P`.
    pub const fn of<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>() -> Self {
        Kernel {
            info: P::INFO,
            table: P::TABLE,
            default: |inputs, results| by_slices(P::INFO, inputs, results, value_apart::<P, N, K, M>),
            faithful: |inputs, results| by_slices(P::INFO, inputs, results, faithful::<P, N, K, M>),
            checked: |inputs, results| store(P::INFO, checked::<P, N, K, M>(fixed(P::INFO, inputs)?)?, results),
            fast: |inputs, results| by_slices(P::INFO, inputs, results, fast::<P, N, K, M>),
            with_bound: |inputs, results, errors| {
                let (values, bounds) = with_bound::<P, N, K, M>(fixed(P::INFO, inputs)?);
                store::<_, LengthError, M>(P::INFO, values, results)?;
                store(P::INFO, bounds, errors)
            },
            batch: |inputs, results| by_columns(P::INFO, inputs, results, P::batch),
            fast_batch: |inputs, results| by_columns(P::INFO, inputs, results, P::fast_batch),
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

    /// The program as data, which one interpreter runs for all kernels; `None` where it is too large for that.
    pub fn table(&self) -> Option<&'static Table<'static>> {
        self.table
    }

    /// The results, or the condition that the inputs violate, or the result that `f64` cannot hold.
    pub fn checked(&self, inputs: &[f64], results: &mut [f64]) -> Result<(), CallError> {
        (self.checked)(inputs, results)
    }

    /// The results with a relative error of at most [`FAST_PROMISE`](crate::FAST_PROMISE), NaN outside the domain or where
    /// nothing decides.
    pub fn fast(&self, inputs: &[f64], results: &mut [f64]) -> Result<(), LengthError> {
        (self.fast)(inputs, results)
    }

    /// The results, and a bound of the absolute error of each, certified for these inputs.
    pub fn with_bound(&self, inputs: &[f64], results: &mut [f64], errors: &mut [f64]) -> Result<(), LengthError> {
        (self.with_bound)(inputs, results, errors)
    }

    /// The results of many points, bit for bit those of [`fast`](Self::fast).
    pub fn fast_batch(&self, inputs: &[&[f64]], results: &mut [&mut [f64]]) -> Result<(), LengthError> {
        (self.fast_batch)(inputs, results)
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

/// Calls `batch` with arrays of slices.
fn by_columns<const N: usize, const M: usize>(
    info: &'static Info,
    inputs: &[&[f64]],
    results: &mut [&mut [f64]],
    batch: Columns<N, M>,
) -> Result<(), LengthError> {
    let inputs = fixed(info, inputs)?;
    let results = fixed_mut(info, results)?;
    batch(*inputs, results.each_mut().map(|result| &mut **result))
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
