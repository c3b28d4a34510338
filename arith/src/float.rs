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
