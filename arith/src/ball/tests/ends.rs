//! What is read off balls and enclosures is right, wherever it is told.

use std::vec::Vec;

use rug::{Float, Integer};

use super::{BITS, Random};
use crate::ball::limbs::Limbs;
use crate::ball::radius::Radius;
use crate::ball::{Ball, Decisions, polynomial};
use crate::exact;
use crate::factored::Step;
use crate::operand::Operand;
use crate::rounded::{Fate, Rounded};
use crate::soft_float::SoftFloat;
use crate::terms::Terms;

/// Balls whose ends lie near where rounding turns, of all sizes that results have: those that `f64` has, those that it
/// has with few digits, and those beyond.
fn near_halves<const L: usize>(random: &mut Random) -> Vec<Float> {
    let integer = 1 + (random.next() >> (1 + random.below(60)));
    let exponent = match random.below(4) {
        0 => -1_074 - random.below(70) as i32,
        1 => 1_024 - 64 - random.below(3) as i32,
        _ => random.below(2_200) as i32 - 1_100,
    };
    let number = Float::with_val(BITS, integer) << exponent;
    // half of the last place of what f64 makes of it, or a power of two, and a little beside that
    let rounded = number.to_f64();
    let half = if rounded.is_finite() && random.below(2) == 0 {
        let (low, high) = (Float::with_val(BITS, rounded), Float::with_val(BITS, rounded.next_up().min(f64::MAX)));
        (low + high) / 2u32
    } else {
        number
    };
    let size = half.get_exp().unwrap_or(0);
    let little = Float::with_val(BITS, 1 + random.below(3)) << (size - 40 - random.below(64 * L as u64) as i32);
    let signed = if random.below(2) == 0 { -half.clone() } else { half.clone() };
    [signed.clone() + &little, signed.clone() - little, signed].into()
}

/// The words of a number, all of them.
fn limbs_of<const L: usize>(number: &Float) -> Option<Limbs<L>> {
    let exponent = number.get_exp()?;
    let integer = (number.clone().abs() << (64 * L as i32 - exponent)).to_integer()?;
    let exact = (Float::with_val(BITS, &integer) << (exponent - 64 * L as i32)) == number.clone().abs();
    let word = |at: usize| Integer::from(&integer >> (64 * at as u32)).to_u64_wrapping();
    let words: Vec<u64> = (0..L).rev().map(word).collect();
    let (limbs, _) = Limbs::from_fraction(exponent.into(), &words);
    exact.then(|| if number.is_sign_negative() { limbs.negated() } else { limbs })
}

#[test]
fn what_is_certified_is_the_nearest_and_its_error_is_bounded() {
    let decisions = Decisions::default();
    let mut random = Random(10);
    let (mut told, mut open, mut lost) = (0, 0, 0);
    for _ in 0..30_000 {
        for middle in near_halves::<8>(&mut random) {
            let Some(limbs) = limbs_of::<8>(&middle) else { continue };
            let radius = match random.below(3) {
                0 => Radius::ZERO,
                _ => Radius::new(1.0, limbs.exponent() - 30 - random.below(500) as i64),
            };
            let ball = Ball { middle: limbs, radius, ..Ball::<8>::new(0.0, &decisions) }.without_separation();
            let (value, power) = radius.parts();
            let reach = Float::with_val(BITS, value) << i32::try_from(power).unwrap();
            let ends =
                [Float::with_val(BITS, &middle - &reach), middle.clone(), Float::with_val(BITS, &middle + &reach)];
            for nearest in [false, true] {
                let Some(found) = ball.certified(nearest) else {
                    open += 1;
                    continue;
                };
                told += 1;
                let (value, fate) = (found.rounded.value, found.rounded.fate);
                lost += u32::from(fate != Fate::Kept);
                for end in &ends {
                    if nearest {
                        assert_eq!(value, end.to_f64(), "{end}");
                    }
                    let off = (Float::with_val(BITS, value) - end).abs();
                    assert!(off <= found.error, "{value:e} is off by {off}, not {:e}", found.error);
                    let exact = radius.is_zero() && off.is_zero();
                    let expected = Rounded::to_nearest(value, exact).fate;
                    assert_eq!(fate, expected, "{value:e}");
                }
            }
        }
    }
    assert!(told > 30_000 && open > 10_000 && lost > 10_000, "{told} told, {open} open, {lost} lost");
}

/// What an exact sum gives, and an enclosure of the same polynomial: the same bits, wherever an enclosure tells them.
#[test]
fn enclosures_tell_what_exact_sums_give() {
    let mut random = Random(9);
    let (mut told, mut zeros) = (0, 0);
    for round in 0..20_000 {
        // (a b - c d) (e f - g h), expanded and as it is written
        let spread = [1, 4, 60, 900][random.below(4) as usize];
        let mut number = || {
            let significand = 1.0 + random.word() as f64 / 2_f64.powi(64) * (1.0 - f64::EPSILON);
            significand * 2_f64.powi(random.below(spread) as i32 - spread as i32 / 2)
        };
        let mut values: [f64; 8] = core::array::from_fn(|_| number());
        match random.below(3) {
            // the first difference nearly vanishes, or vanishes
            0 => (values[2], values[3]) = (values[1], values[0]),
            1 => (values[2], values[3]) = (values[1].next_up(), values[0]),
            _ => {}
        }
        let of = |position: u8| Operand::of(values[usize::from(position)]);
        let compact = [4, 0, 1, 4, 5, 0x84, 0, 1, 6, 7, 0x84, 2, 3, 4, 5, 4, 2, 3, 6, 7];
        let operands = |first: u8| [0, 1, 2, 3].map(|after| Step::Operand(first + after));
        // c d - a b in reverse, times -e f - -g h: a wrong sign of any kind of step is left over
        let ([a, b, c, d], [e, f, g, h]) = (operands(0), operands(4));
        let reversed = [a, b, Step::Product, c, d, Step::Product, Step::Reversed];
        let negative = [e, f, Step::Product, Step::Negative, g, h, Step::Product, Step::Negative, Step::Difference];
        let steps = reversed.into_iter().chain(negative).chain([Step::Product]);
        let steps: Vec<u8> = steps.map(|step| step.byte().unwrap()).collect();
        let exact = exact::polynomial(&of, Terms::of(&compact)).unwrap();
        if let Some(found) = polynomial(&of, &steps) {
            told += 1;
            zeros += u32::from(found.is_zero());
            let bits = |soft: SoftFloat| std::format!("{soft:?}");
            assert_eq!(bits(found), bits(exact), "{round}: {values:?}");
        }
    }
    assert!(told > 19_900 && zeros > 1_000, "{told} told, {zeros} zeros");
}
