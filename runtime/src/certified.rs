//! The call that certifies itself: computed in balls of more and more words, until every condition is decided and every
//! result is right.

use crate::ball::{Ball, Settling};
use crate::kernel::Program;

/// Results and domain, each result off by 0.51 ulp at most, NaN where the formula has no value; results are NaN where a
/// condition does not hold. `None` where 4,096 bits do not decide.
#[inline(never)]
pub(crate) fn certified<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Option<([f64; M], [bool; K])> {
    tier::<P, N, K, M, 4>(inputs).or_else(|| tier::<P, N, K, M, 16>(inputs)).or_else(|| tier::<P, N, K, M, 64>(inputs))
}

/// The same in floats of `L` words; `None` where they are too few.
#[inline(never)]
fn tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const L: usize>(
    inputs: &[f64; N],
) -> Option<([f64; M], [bool; K])> {
    let settling = Settling::default();
    let numbers = inputs.map(|input| Ball::<L>::new(input, &settling));
    let domain = P::domain(&numbers);
    let mut results = [f64::NAN; M];
    if !settling.is_unsettled() && domain.iter().all(|holds| *holds) {
        for (result, ball) in results.iter_mut().zip(P::evaluate(&numbers)) {
            *result = ball.accepted()?;
        }
    }
    (!settling.is_unsettled()).then_some((results, domain))
}
