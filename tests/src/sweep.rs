//! The sweep: default and faithful results at very many points, against the kernel's own program in MPFR.
//!
//! `closedform check` proves that program equal to the reference, whose evaluation takes far longer.

use closedform::CallError;
use rug::Float;

use crate::check::Judge;
use crate::failure::{list, replay};
use crate::inputs::{Points, other_fraction};
use crate::random::Random;
use crate::ulp::{self, F64};

/// Bits of the first two evaluations; more where they disagree.
const PRECISIONS: (u32, u32) = (192, 256);

/// Bits at which the program is given up, and those at which it is believed to vanish: no compensated expression of
/// doubles has more.
const MOST_PRECISE: u32 = 1 << 16;
const VANISHES: u32 = 1 << 15;

/// Bits in which two evaluations must agree.
const BITS: u32 = 80;

/// Neighbours of a point that are tried before another one is taken.
const TRIES: usize = 8;

/// What came out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Swept {
    /// How many points were judged.
    pub points: usize,
    /// The worst default result, in units of its bound.
    pub default: f64,
    /// The worst faithful result, in ulp.
    pub faithful: f64,
}

/// Demands of `count` points, neighbours of those given, that default results keep their bounds and faithful ones are less
/// than one ulp off.
///
/// # Errors
///
/// The first point where they do not.
pub fn sweep(judge: &Judge, around: &Points, seed: u64, count: usize) -> Result<Swept, String> {
    let mut random = Random::new(seed, &format!("{} sweep", judge.kernel.info.name));
    let mut sweep = Sweep::new(judge, &around.origin);
    while sweep.swept.points < count && !around.list.is_empty() {
        let base = random.pick(&around.list);
        for _ in 0..TRIES {
            let near = random.one_in(2);
            let point: Vec<f64> = base.iter().map(|value| neighbour(*value, near, &mut random)).collect();
            if sweep.takes(&point)? {
                sweep.judge_at(&point)?;
                break;
            }
        }
    }
    Ok(sweep.swept)
}

/// The number itself, some units in its last place beside it, or, unless `near`, one of the same exponent.
fn neighbour(value: f64, near: bool, random: &mut Random) -> f64 {
    if value == 0.0 {
        return value;
    }
    match random.below(4) {
        0 => value,
        1 => f64::from_bits(value.to_bits().wrapping_add_signed(random.below(9) as i64 - 4)),
        _ if near => value,
        _ => other_fraction(value, random),
    }
}

struct Sweep<'a> {
    judge: &'a Judge,
    origin: &'a str,
    default: Vec<f64>,
    faithful: Vec<f64>,
    swept: Swept,
}

impl<'a> Sweep<'a> {
    fn new(judge: &'a Judge, origin: &'a str) -> Self {
        let results = vec![0.0; judge.kernel.info.results.len()];
        Sweep { judge, origin, default: results.clone(), faithful: results, swept: Swept::default() }
    }

    /// Whether the point is inside the domain and `f64` holds all results; then they are known.
    fn takes(&mut self, point: &[f64]) -> Result<bool, String> {
        match self.judge.kernel.checked(point, &mut self.default) {
            Err(CallError::Domain(_) | CallError::Range(_)) => return Ok(false),
            outcome => outcome.map_err(|error| error.to_string())?,
        }
        self.judge.kernel.faithful(point, &mut self.faithful).map_err(|error| error.to_string())?;
        Ok(true)
    }

    fn judge_at(&mut self, point: &[f64]) -> Result<(), String> {
        let exact = self.exact(point)?;
        for (result, exact) in exact.iter().enumerate() {
            let (default, faithful) = (self.default[result], self.faithful[result]);
            let errors = [default, faithful].map(|actual| ulp::distance(actual, exact, F64));
            let share = if errors[0] == 0.0 { 0.0 } else { errors[0] / self.judge.bound(result) };
            if share > 1.0 || errors[1] >= 1.0 {
                let name = self.judge.kernel.info.results[result].name;
                let what =
                    format!("`{name}` is {default:?}, faithful {faithful:?}, expected {exact:.20}: {errors:?} ulp");
                return Err(self.told(point, &what));
            }
            self.swept.default = self.swept.default.max(share);
            self.swept.faithful = self.swept.faithful.max(errors[1]);
        }
        self.swept.points += 1;
        Ok(())
    }

    /// The results of the program, once two evaluations agree.
    fn exact(&self, point: &[f64]) -> Result<Vec<Float>, String> {
        let (first, mut precision) = PRECISIONS;
        let mut rough = self.judge.program(point, first);
        while precision <= MOST_PRECISE {
            let fine = self.judge.program(point, precision);
            if rough.iter().zip(&fine).all(|(rough, fine)| agree(rough, fine)) {
                return Ok(fine);
            }
            rough = fine;
            precision *= 2;
        }
        Err(self.told(point, &format!("the program in MPFR does not settle: {rough:.20?}")))
    }

    fn told(&self, point: &[f64], what: &str) -> String {
        let info = self.judge.kernel.info;
        format!(
            "{}: {what}\n{}  from a neighbour of {}\n  {}",
            info.name,
            list(info, point),
            self.origin,
            replay(info, point)
        )
    }
}

fn agree(rough: &Float, fine: &Float) -> bool {
    let Some(exponent) = fine.get_exp() else { return fine.is_zero() && fine.prec() >= VANISHES };
    let difference = Float::with_val(BITS, rough - fine);
    difference.is_zero() || difference.get_exp().is_some_and(|off| off < exponent - BITS as i32)
}
