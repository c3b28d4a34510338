//! Kernels whose bounds are proved for a reason each, to be doctored until they are not.

use closedform::kernel;

/// The text of this file.
pub const TEXT: &str = include_str!("bounded.rs");

/// A difference of one sign under no root, divided by a sum of one sign.
#[kernel(
    family = "sample",
    result(worksheet = "quotient", unit = "m"),
    bound = 6.01,
    certificate = "1-d706195f27945076"
)]
pub fn quotient(
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
    #[input(unit = "m", typical(1e-6, 1e-2))] d: f64,
) -> f64 {
    require!(t >= 0.0, "t >= 0");
    require!(a > 0.0, "a > 0");
    require!(d > 0.0, "d > 0");
    require!(compensated!(6.0 * d - a * t * t) > 0.0, "6*d > a*t^2");
    let left = compensated!(6.0 * d - a * t * t);
    let root = sqrt(a * (a * t * t + 48.0 * d));
    2.0 * left / (root + 3.0 * a * t)
}

/// The length of an arrow whose parts may have any sign.
#[kernel(family = "sample", result(worksheet = "length", unit = "m"), bound = 2.0, certificate = "1-098e190dfe8d2b6d")]
pub fn length(
    #[input(unit = "m", typical(1e-6, 1e-2))] x: f64,
    #[input(unit = "m", typical(1e-6, 1e-2))] y: f64,
) -> f64 {
    sqrt(x * x + y * y)
}

/// A branch for each sign of a number.
#[kernel(
    family = "sample",
    result(worksheet = "signed", unit = "m/s"),
    bound = 4.0,
    certificate = "1-d7d454cee086c5b0"
)]
pub fn signed(
    #[input(unit = "m/s", typical(1e-3, 2.0))] u: f64,
    #[input(unit = "m^2/s^2", typical(1e-3, 2.0))] e: f64,
) -> f64 {
    require!(e > 0.0, "e > 0");
    let root = sqrt(u * u + 4.0 * e);
    if u >= 0.0 { root + u } else { 4.0 * e / (root - u) }
}

/// A branch for the equal signs of two numbers.
#[kernel(
    family = "sample",
    result(worksheet = "both_signed", unit = "m"),
    bound = 5.01,
    certificate = "1-fa929675b3bb7ad4"
)]
pub fn both_signed(
    #[input(unit = "1", typical(1e-3, 2.0))] p: f64,
    #[input(unit = "1", typical(1e-3, 2.0))] q: f64,
    #[input(unit = "1", typical(1e-3, 2.0))] r: f64,
) -> f64 {
    require!(compensated!(p * p - q * q * r) > 0.0, "p^2 > q^2*r");
    require!(r > 0.0, "r > 0");
    let root = sqrt(r);
    let rest = compensated!(p * p - q * q * r);
    if (p >= 0.0 && q >= 0.0) || (p <= 0.0 && q <= 0.0) { q * root + p } else { rest / (p - q * root) }
}

/// What is computed in double-double.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twice {
    /// A quotient.
    pub t: f64,
    /// A product and a quotient.
    pub k: f64,
}

/// A kernel in double-double whose compensated expressions may cancel.
#[kernel(
    family = "sample",
    precision = "double-double",
    results(t(worksheet = "twice_t", unit = "s"), k(worksheet = "twice_k", unit = "1")),
    bound(t = 0.51, k = 0.51),
    certificate = "1-c4f65e8ec72f1ea9"
)]
pub fn twice(
    #[input(unit = "s", typical(1e-4, 1e-1))] t_in: f64,
    #[input(unit = "s^2", typical(1e-7, 1e-1))] d: f64,
    #[input(unit = "1", typical(1e-3, 2.0))] k: f64,
) -> Twice {
    require!(t_in > 0.0, "tIn > 0");
    require!(k > 0.0, "k > 0");
    require!(compensated!(3.0 * d - t_in * t_in) >= 0.0, "3*d >= tIn^2");
    let left = compensated!(3.0 * d - t_in * t_in);
    let sum = sqrt(24.0 * d + t_in * t_in) + 5.0 * t_in;
    Twice { t: 4.0 * left / sum, k: t_in * k / sum }
}

/// Roundings that add up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roundings {
    /// One of them.
    pub v: f64,
    /// A root of a quotient.
    pub t: f64,
    /// A multiple of a root.
    pub s: f64,
}

/// A quotient and two roots.
#[kernel(
    family = "sample",
    results(
        v(worksheet = "roundings_v", unit = "m/s"),
        t(worksheet = "roundings_t", unit = "s"),
        s(worksheet = "roundings_s", unit = "s")
    ),
    bound(v = 0.5, t = 2.0, s = 1.5),
    certificate = "1-e4953cd5909dccf4"
)]
pub fn roundings(
    #[input(unit = "m", typical(1e-6, 1e-2))] x: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
) -> Roundings {
    require!(x > 0.0, "x > 0");
    require!(t > 0.0, "t > 0");
    require!(a > 0.0, "a > 0");
    let root = sqrt(x / a);
    Roundings { v: x / t, t: sqrt(6.0 * x / a), s: 2.0 * root }
}

/// The root of a polynomial whose coefficients are inputs, corrected once.
#[kernel(family = "sample", result(worksheet = "cubic", unit = "1"), bound = 0.51, certificate = "1-00905610008801cd")]
pub fn cubic(
    #[input(unit = "1", typical(1e-3, 1e3))] a: f64,
    #[input(unit = "1", typical(1e-3, 1e3))] b: f64,
    #[input(unit = "1", typical(1e-3, 1e3))] d: f64,
) -> f64 {
    require!(a > 0.0, "a > 0");
    require!(b > 0.0, "b > 0");
    require!(d > 0.0, "d > 0");
    let start = positive_root([-d, 0.0, b, a]);
    let remainder = residual!(start * start * (a * start + b) - d);
    start - start * (remainder / (a * start * start * start + 2.0 * d))
}

/// The root of a polynomial with a coefficient that may cancel.
#[kernel(
    family = "sample",
    result(worksheet = "cancelling_cubic", unit = "1"),
    bound = 0.51,
    certificate = "1-cc2b593707d1d49a"
)]
pub fn cancelling_cubic(
    #[input(unit = "1", typical(1e-3, 1e3))] a: f64,
    #[input(unit = "1", typical(1e-3, 1e3))] p: f64,
    #[input(unit = "1", typical(1e-3, 1e3))] q: f64,
    #[input(unit = "1", typical(1e-3, 1e3))] d: f64,
) -> f64 {
    require!(a > 0.0, "a > 0");
    require!(d > 0.0, "d > 0");
    let middle = compensated!(8.0 * p * p - 3.0 * q * q);
    let start = positive_root([-d, middle, a, a]);
    let remainder = compensated!(start * (start * (a * start + a) + (8.0 * p * p - 3.0 * q * q)) - d);
    start - start * (remainder / ((2.0 * a * start + a) * start * start + d))
}
