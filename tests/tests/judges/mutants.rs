//! Kernels with a mistake each and forged certificates, and what judges need besides them.

use closedform::{Kernel, kernel};

use crate::right::Ramps;

/// Kernels that take v, a, x and return the time to reach x: each its own mistake.
macro_rules! mutants {
    ($($(#[$doc:meta])* $name:ident($v:ident, $a:ident, $x:ident), $certificate:tt { $($body:tt)* })*) => {$(
        $(#[$doc])*
        #[kernel(family = "sample", bound = 3, certificate = $certificate, result(worksheet = "reach", unit = "s"))]
        pub fn $name(
            #[input(unit = "m/s", typical(1e-3, 2.0))] $v: f64,
            #[input(unit = "m/s^2", typical(0.1, 50.0))] $a: f64,
            #[input(unit = "m", typical(1e-6, 1e-2))] $x: f64,
        ) -> f64 {
            $($body)*
        }
    )*};
}

/// Those that are another formula.
pub const WRONG: [&Kernel; 5] =
    [&sign::KERNEL, &coefficient::KERNEL, &operator::KERNEL, &zero::KERNEL, &offset::KERNEL];

/// Those that are the right formula, badly evaluated.
pub const INACCURATE: [&Kernel; 3] = [&branches_swapped::KERNEL, &one_branch::KERNEL, &plain_difference::KERNEL];

/// Those that take what they must not, refuse what they must take, or give the wrong reason.
pub const WRONG_DOMAIN: [&Kernel; 4] =
    [&edge_left_out::KERNEL, &edge_taken::KERNEL, &edge_rounded::KERNEL, &misnamed::KERNEL];

mutants! {
    /// A sign.
    sign(v, a, x), "1-79ed80d3d490aafa" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(compensated!(v * v + 2.0 * a * x));
        if v > 0.0 { 2.0 * x / (v - root) } else { (root - v) / a }
    }

    /// A coefficient, in its last digits.
    coefficient(v, a, x), "1-8efcd05853134c4a" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(compensated!(v * v + 2.000000000000004 * a * x));
        if v > 0.0 { 2.0 * x / (root + v) } else { (root - v) / a }
    }

    /// An operator.
    operator(v, a, x), "1-27a3336ab2fd1ac3" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(abs(compensated!(v * v - 2.0 * a * x)));
        if v > 0.0 { 2.0 * x / (root + v) } else { (root - v) / a }
    }

    /// One input alone, where v vanishes.
    zero(v, a, x), "1-e6793af99efcc78b" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(compensated!(v * v + 2.0 * a * x));
        if v > 0.0 { 2.0 * x / (root + v) } else if v < 0.0 { (root - v) / a } else { x / root }
    }

    /// A number without unit, far below what matters at common magnitudes.
    offset(v, a, x), "1-c878536a73d67d7b" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(compensated!(v * v + 2.0 * a * x));
        if v > 0.0 { 2.0 * x / (root + v) + 1e-25 } else { (root - v) / a }
    }

    /// Each branch where the other one belongs.
    branches_swapped(v, a, x), "1-99908a8bd496bcc8" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(compensated!(v * v + 2.0 * a * x));
        if v < 0.0 { 2.0 * x / (root + v) } else { (root - v) / a }
    }

    /// The formula as it stands.
    one_branch(v, a, x), "1-a9a2be66f542661b" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        (sqrt(compensated!(v * v + 2.0 * a * x)) - v) / a
    }

    /// A difference rounded in each step.
    plain_difference(v, a, x), "1-1cdc5487eb8af31e" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        let root = sqrt(abs(v * v + 2.0 * a * x));
        if v > 0.0 { 2.0 * x / (root + v) } else { (root - v) / a }
    }

    /// The edge belongs to the domain.
    edge_left_out(v, a, x), "1-9e498f89699b0c61" {
        require!(a > 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) > 0.0, "v^2+2*a*x >= 0");
        0.0 * v * a * x
    }

    /// The edge does not belong to the domain.
    edge_taken(v, a, x), "1-7a0c3054f4f141d3" {
        require!(a >= 0.0, "a > 0");
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
        0.0 * v * a * x
    }

    /// The condition is decided after rounding.
    edge_rounded(v, a, x), "1-d7cf9833c5ad7c45" {
        require!(a > 0.0, "a > 0");
        require!(v * v + 2.0 * a * x >= 0.0, "v^2+2*a*x >= 0");
        0.0 * v * a * x
    }

    /// The conditions bear each other's texts.
    misnamed(v, a, x), "1-81fe1d61290c3510" {
        require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "a > 0");
        require!(a > 0.0, "v^2+2*a*x >= 0");
        0.0 * v * a * x
    }
}

/// A wrong unit.
#[kernel(family = "sample", bound = 1, certificate = "1-5c7a85c6a6640a7c", result(worksheet = "travel", unit = "s"))]
pub fn unit(
    #[input(unit = "m/s", typical(1e-3, 2.0))] v: f64,
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> f64 {
    require!(a > 0.0, "a > 0");
    compensated!(v * t + 0.5 * a * t * t)
}

/// A sum rounded in each step.
#[kernel(family = "sample", bound = 1, certificate = "1-a5d16aeb683ab9e5", result(worksheet = "travel", unit = "m"))]
pub fn plain_sum(
    #[input(unit = "m/s", typical(1e-3, 2.0))] v: f64,
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> f64 {
    require!(a > 0.0, "a > 0");
    v * t + 0.5 * a * t * t
}

/// No bound.
#[kernel(family = "sample", result(worksheet = "reach", unit = "s"))]
pub fn unbounded(v: f64, a: f64, x: f64) -> f64 {
    (sqrt(v * v + 2.0 * a * x) - v) / a
}

/// Two ramps that do not lead to where they should, by what is wrong of them first.
pub const WRONG_MOVES: [(&Kernel, &str); 2] =
    [(&ramps_too_slow::KERNEL, "position after segment 1"), (&peak_too_high::KERNEL, "acceleration after segment 1")];

/// The velocity is the mean one of one ramp.
#[kernel(
    family = "sample",
    bound(v = 0.5, a = 2),
    certificate = "1-68192d47b20d2a15",
    results(v(worksheet = "ramps_v", unit = "m/s"), a(worksheet = "ramps_a", unit = "m/s^2"))
)]
pub fn ramps_too_slow(
    #[input(unit = "m", typical(1e-6, 1e-2))] x: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> Ramps {
    require!(x > 0.0, "x > 0");
    require!(t > 0.0, "t > 0");
    let v = x / t;
    Ramps { v: 0.5 * v, a: v / t }
}

/// The peak, in its last digits.
#[kernel(
    family = "sample",
    bound(v = 0.5, a = 2),
    certificate = "1-25b331a3d2ad5087",
    results(v(worksheet = "ramps_v", unit = "m/s"), a(worksheet = "ramps_a", unit = "m/s^2"))
)]
pub fn peak_too_high(
    #[input(unit = "m", typical(1e-6, 1e-2))] x: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> Ramps {
    require!(x > 0.0, "x > 0");
    require!(t > 0.0, "t > 0");
    let v = x / t;
    Ramps { v, a: 1.000000000000002 * v / t }
}
