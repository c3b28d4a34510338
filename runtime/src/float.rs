//! The one door to float functions that `core` lacks.

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!(
    "closedform needs IEEE 754 arithmetic: the x87 unit of this target rounds twice, which breaks every error-free sum and \
     product. Build for a target with SSE2, such as i686-unknown-linux-gnu, or with `-C target-feature=+sse2`"
);

/// The square root, correctly rounded.
#[inline(always)]
pub(crate) fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}

/// What rounding `a * b` to `product` lost.
///
/// The two ways return the same bits unless the split overflows (an operand beyond 2^996) or the error underflows (a
/// product below 2^-969): `Wide::error_free` tells.
#[inline(always)]
pub(crate) fn product_error(a: f64, b: f64, product: f64) -> f64 {
    #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
    return a.mul_add(b, -product);
    // Without the instruction a fused multiply-add is a slow function call that no loop vectorises: split instead.
    #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
    return dekker_error(a, b, product);
}

/// Dekker's product error, from operands split so that every partial product is exact.
#[cfg_attr(
    all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")),
    allow(dead_code, reason = "the fused instruction replaces it; tests compare both")
)]
#[inline(always)]
pub(crate) fn dekker_error(a: f64, b: f64, product: f64) -> f64 {
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    al * bl - (((product - ah * bh) - al * bh) - ah * bl)
}

/// Veltkamp's split into two halves of at most 26 bits each.
#[inline(always)]
fn split(x: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * x; // 2^27 + 1
    let high = scaled - (scaled - x);
    (high, x - high)
}

/// The significand as an integer, and the exponent of its unit; of a finite number.
pub(crate) fn significand(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    let significand = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    (significand, exponent.max(1) - 1075)
}

/// The exponent of the leading bit; of a number that is neither zero, infinite nor NaN.
pub(crate) fn exponent(x: f64) -> i32 {
    libm::ilogb(x)
}

/// `x * 2^n`, exact unless it over- or underflows.
pub(crate) fn scale(x: f64, n: i32) -> f64 {
    libm::scalbn(x, n)
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::dekker_error;
    use crate::wide::Wide;

    #[test]
    fn the_split_finds_what_a_fused_multiply_add_finds() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        for _ in 0..100_000 {
            let [a, b] = [1, 2].map(|_| {
                bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                f64::from_bits(bits >> 12 | 0x3ff0_0000_0000_0000)
                    * f64::from_bits(0x3e00_0000_0000_0000 + (bits & (0x3ff << 52)) / 2)
            });
            let product = a * b;
            assert_eq!(dekker_error(a, b, product), a.mul_add(b, -product), "{a:e} * {b:e}");
        }
    }

    #[test]
    fn both_ways_agree_wherever_a_product_is_error_free() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = || {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            bits ^ bits >> 29
        };
        let mut number = |field: u64| f64::from_bits(random() & !(0x7ff << 52) | field << 52);
        // the exponents of zero, subnormal numbers, and the edges of factors and products among them
        let fields = || [0, 1, 2, 53, 54, 55, 1021, 1022, 1023, 1500, 2018, 2019, 2020, 2045, 2046].into_iter();
        let pairs = fields().flat_map(|a| (0..2047).flat_map(move |b| (0..4).map(move |_| (a, b))));
        let (mut same, mut different) = (0, 0);
        for (a, b) in pairs {
            let (a, b) = (number(a), number(b));
            let product = a * b;
            let agree = dekker_error(a, b, product) == a.mul_add(b, -product);
            assert!(agree || !Wide::error_free(a, b), "{a:e} * {b:e}");
            *(if agree { &mut same } else { &mut different }) += 1;
        }
        assert!(same > 10_000 && different > 10_000, "{same} {different}");
    }
}
