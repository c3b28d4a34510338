//! Error-free transformations: sums and products of two numbers as what `f64` makes of them, and what that lost.

use crate::range;

/// Whether all processors of the target have a fused multiply-add, so that products take it. Elsewhere it is a slow function call that
/// no loop vectorises: there they split, except where a caller has seen that the processor has it.
pub const FUSED: bool = cfg!(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")));

/// The largest factor that can be split.
pub(crate) const LARGEST_FACTOR: f64 = range::power_of_two(range::FACTOR);

/// Between these magnitudes a product of numbers that can be split is error-free.
const PRODUCTS: (f64, f64) = (range::power_of_two(range::PRODUCT.0), range::power_of_two(range::PRODUCT.1));

/// `a + b` and what rounding it lost (Knuth's 2Sum).
#[inline(always)]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let high = a + b;
    let a_part = high - b;
    let b_part = high - a_part;
    (high, (a - a_part) + (b - b_part))
}

/// The same where `a` is zero or its exponent is not below that of `b` (Dekker's Fast2Sum).
#[inline(always)]
pub(crate) fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let high = a + b;
    (high, b - (high - a))
}

/// `a * b` and what rounding it lost (2Prod): with a fused multiply-add, or Dekker's product; the same bits where it
/// [is error-free](product_is_error_free).
#[inline(always)]
pub(crate) fn two_product<const FUSED: bool>(a: f64, b: f64) -> (f64, f64) {
    let high = a * b;
    (high, product_error::<FUSED>(a, b, high))
}

/// Whether the product of `a` and `b` is error-free however it is computed: operands can be split, no product of
/// their parts overflows, and the error does not underflow.
#[inline(always)]
pub(crate) fn product_is_error_free(a: f64, b: f64) -> bool {
    let product = (a * b).abs();
    let sized = ((product >= PRODUCTS.0) & (product <= PRODUCTS.1)) | (a == 0.0) | (b == 0.0);
    (a.abs() <= LARGEST_FACTOR) & (b.abs() <= LARGEST_FACTOR) & sized
}

/// What rounding `a * b` to `product` lost.
///
/// The two ways return the same bits unless the split overflows (an operand beyond 2^996) or the error underflows (a
/// product below 2^-969): [`product_is_error_free`] tells.
#[inline(always)]
fn product_error<const FUSED: bool>(a: f64, b: f64, product: f64) -> f64 {
    #[cfg(feature = "std")]
    if FUSED {
        return a.mul_add(b, -product);
    }
    dekker_error(a, b, product)
}

/// Dekker's product error, from operands split so that every partial product is exact.
#[inline(always)]
fn dekker_error(a: f64, b: f64, product: f64) -> f64 {
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

#[cfg(all(test, feature = "std"))]
mod tests {
    use crate::error_free::{dekker_error, product_is_error_free};

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
            assert!(agree || !product_is_error_free(a, b), "{a:e} * {b:e}");
            *(if agree { &mut same } else { &mut different }) += 1;
        }
        assert!(same > 10_000 && different > 10_000, "{same} {different}");
    }
}
