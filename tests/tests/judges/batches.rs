//! A program written without the macro, so that its batch can differ from single calls.

use closedform::{Info, Kernel, LengthError, Program, Real};

use crate::right;

/// The right distance, but in batches its last bit is wrong.
pub const OFF_BY_ONE_BIT: Kernel = Kernel::of::<OffByOneBit, 3, 1, 1>();

struct OffByOneBit;

impl Program<3, 1, 1> for OffByOneBit {
    const INFO: &'static Info = right::distance::KERNEL.info;

    fn evaluate<R: Real>(inputs: &[R; 3]) -> [R; 1] {
        right::distance::evaluate(inputs)
    }

    fn domain<R: Real>(_: &[R; 3]) -> [bool; 1] {
        [true]
    }

    fn batch(inputs: [&[f64]; 3], results: [&mut [f64]; 1]) -> Result<(), LengthError> {
        let [v, a, t] = inputs;
        let [travelled] = results;
        for (position, result) in travelled.iter_mut().enumerate() {
            *result = right::distance(v[position], a[position], t[position]).next_up();
        }
        Ok(())
    }

    fn fast_batch(inputs: [&[f64]; 3], results: [&mut [f64]; 1]) -> Result<(), LengthError> {
        Self::batch(inputs, results)
    }
}
