//! Bisection among the floats, by their places in order: where a condition changes.

/// Neighbours between `near` and `far`, of which one is as `near` and the other as `far`, if those differ; nothing where
/// the condition cannot be decided.
pub fn bisect(near: f64, far: f64, mut holds: impl FnMut(f64) -> Option<bool>) -> Option<[f64; 2]> {
    let side = holds(near)?;
    if holds(far)? == side {
        return None;
    }
    let (mut near, mut far) = (rank(near), rank(far));
    while near.abs_diff(far) > 1 {
        let middle = near.midpoint(far);
        let end = if holds(unrank(middle))? == side { &mut near } else { &mut far };
        *end = middle;
    }
    Some([unrank(near), unrank(far)])
}

/// The place of a float among all floats, in order.
pub fn rank(value: f64) -> i64 {
    let bits = value.to_bits() as i64;
    if bits < 0 { i64::MIN - bits } else { bits }
}

/// The float at a place.
pub fn unrank(rank: i64) -> f64 {
    f64::from_bits(if rank < 0 { i64::MIN - rank } else { rank } as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rank_orders_the_floats() {
        for value in [0.0, 1.5, -1.5, f64::MAX, -f64::MIN_POSITIVE] {
            assert_eq!(unrank(rank(value)), value);
            assert_eq!(unrank(rank(value) + 1), value.next_up());
        }
    }

    #[test]
    fn neighbours_are_found_from_both_sides() {
        let positive = |value: f64| (!value.is_nan()).then_some(value > 1.0);
        assert_eq!(bisect(-3.0, 1e30, positive), Some([1.0, 1.0_f64.next_up()]));
        assert_eq!(bisect(1e30, -3.0, positive), Some([1.0_f64.next_up(), 1.0]));
        assert_eq!(bisect(2.0, 1e30, positive), None);
        assert_eq!(bisect(2.0, f64::NAN, positive), None);
    }
}
