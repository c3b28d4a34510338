//! Functions whose values are integers, at numbers that are rounded.

use rug::Float;

use super::notes::Notes;

/// The function of this name.
pub(super) fn named(name: &str) -> Option<fn(Float) -> Float> {
    Some(match name {
        "floor" | "entier" => Float::floor,
        "ceiling" => Float::ceil,
        "round" => Float::round_even,
        "truncate" => Float::trunc,
        _ => return None,
    })
}

/// Its value. Where it is asked for, a number that half of the bits do not tell from a multiple of 1/2 is taken for that, and
/// this is noted: what is nearer at every precision is that number.
pub(super) fn value(notes: &Notes, function: fn(Float) -> Float, argument: Float) -> Float {
    if !notes.takes_near_for_equal {
        return function(argument);
    }
    let told = argument.get_exp().unwrap_or(0).max(0) - (argument.prec() / 2).cast_signed();
    if told > -2 {
        notes.lost_fraction.set(true);
        return function(argument);
    }
    let place = (argument.clone() * 2u32).round() / 2u32;
    let distance = Float::with_val(argument.prec(), &argument - &place);
    let is_near = distance.get_exp().is_none_or(|exponent| exponent <= told);
    if is_near {
        notes.is_near_step.set(true);
    }
    function(if is_near { place } else { argument })
}
