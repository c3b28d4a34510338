//! Numbers of programs.

/// Without an exponent, which controllers do not read, and without a sign of zero; it reads back to the same bits.
pub(super) fn plain(number: f64) -> String {
    format!("{}", number + 0.0)
}
