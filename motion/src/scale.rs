//! Powers of two: numbers are brought near 1, so that nothing overflows on the way, and no digit is touched.

/// The exponent of a finite number, floor(log2(|x|)); that of the smallest number for 0.
pub(crate) fn exponent(x: f64) -> i32 {
    const HIDDEN: u64 = 1 << 52;
    match (x.to_bits() / HIDDEN) & 0x7ff {
        0 if x == 0.0 => -1074,
        0 => exponent(x * power_of_two(64)) - 64,
        biased => biased as i32 - 1023,
    }
}

/// `x*2^power`, rounded at most once where the result is subnormal.
pub(crate) fn scale(x: f64, power: i32) -> f64 {
    let first = power.clamp(-1022, 1023);
    let second = (power - first).clamp(-1022, 1023);
    x * power_of_two(first) * power_of_two(second)
}

/// For powers from -1022 to 1023.
fn power_of_two(power: i32) -> f64 {
    f64::from_bits(((1023 + power) as u64) << 52)
}

/// The largest magnitude of finite numbers; 0 of none.
pub(crate) fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |most, number| number.abs().max(most))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_its_exponent_times_a_number_from_one_to_two() {
        for x in [1.0, -1.5, 2.0, 0.1, f64::MAX, f64::MIN_POSITIVE, 5e-324, -3e-310, 1e308, 1e-200] {
            let near = scale(x, -exponent(x));
            assert!((1.0..2.0).contains(&near.abs()), "{x}: {near}");
            assert_eq!(scale(near, exponent(x)), x);
        }
        assert_eq!(scale(3.0, -5000), 0.0);
        assert_eq!(scale(3.0, 5000), f64::INFINITY);
        assert_eq!(scale(0.0, exponent(0.0)), 0.0);
    }
}
