//! Programs of kernels: what expansions of `#[kernel]` implement, and shapes of calls are generic in.

use closedform_arith::table::Table;
use closedform_arith::{Real, Signs};

use crate::error::LengthError;
use crate::info::Info;

/// The program of a kernel of `N` inputs, `K` conditions and `M` results; implemented by `#[kernel]`.
pub trait Program<const N: usize, const K: usize, const M: usize> {
    /// What is known of the kernel.
    const INFO: &'static Info;

    /// What is known of the inputs before `fast` looks at them.
    const FAST: Fast<N> = Fast { ordinary: 0, signs: [Signs::ANY; N] };

    /// The program as data, for the interpreter of the finest tier; `None` where it is too large for that.
    const TABLE: Option<&'static Table<'static>> = None;

    /// The results in any arithmetic, whether or not the inputs lie in the domain.
    fn evaluate<R: Real>(inputs: &[R; N]) -> [R; M];

    /// Whether each condition of the domain holds, in any arithmetic.
    fn domain<R: Real>(inputs: &[R; N]) -> [bool; K];

    /// `of` of each input. `#[kernel]` writes all of them out: where compilers made a loop or a call of it, loops over rows would not be
    /// vectorised.
    #[inline(always)]
    fn each_input<T, U>(inputs: [T; N], of: impl FnMut(T) -> U) -> [U; N] {
        inputs.map(of)
    }

    /// `of` of each result, in the same way.
    #[inline(always)]
    fn each_result<T, U>(results: [T; M], of: impl FnMut(T) -> U) -> [U; M] {
        results.map(of)
    }

    /// The results in `f64` for slices of equal length.
    fn batch(inputs: [&[f64]; N], results: [&mut [f64]; M]) -> Result<(), LengthError>;

    /// What [`fast`](crate::Kernel::fast) returns, for slices of equal length.
    fn fast_batch(inputs: [&[f64]; N], results: [&mut [f64]; M]) -> Result<(), LengthError>;
}

/// The positions of inputs or results.
#[inline(always)]
pub(crate) const fn positions<const N: usize>() -> [usize; N] {
    let (mut positions, mut at) = ([0; N], 0);
    while at < N {
        positions[at] = at;
        at += 1;
    }
    positions
}

/// What is known of the inputs of a program before `fast` looks at them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fast<const N: usize> {
    /// The k of: where every input is 0 or of a magnitude from 2^-k to 2^k, no step of a program in `f64` over- or underflows.
    /// 0 where no k is known: then each step is looked at.
    pub ordinary: u32,
    /// The signs that inputs have in the domain. Its conditions tell them, of inputs alone.
    pub signs: [Signs; N],
}
