//! Kernels written by hand that keep what they promise.

use closedform::{Kernel, kernel};

/// What a worksheet would define.
pub const REFERENCES: &str = "\
reach(v,a,x):=(sqrt(v^2+2*a*x)-v)/a$
travel(v,a,t):=v*t+a*t^2/2$
ramp_d(a,t):=a*t^2/6$
ramp_v(a,t):=a*t/2$
ramps_v(x,t):=x/t$
ramps_a(x,t):=x/t^2$
";

/// What Maxima would print.
pub const GOLDEN: &str = "\
reach\tv=0x1.8p+1 a=0x1p+0 x=0x1p+3\t2.000000000000000000000000000000000000000
reach\tv=0x0p+0 a=0x1p+0 x=0x1p+0\t1.414213562373095048801688724209698078570
reach\tv=-0x1p+0 a=0x1p-1 x=0x1p+0\t4.828427124746190097603377448419396157139
travel\tv=-0x1p+0 a=0x1p+1 t=0x1p+0\t0
travel\tv=0x1p-1 a=0x1p+1 t=0x1.8p+0\t3.000000000000000000000000000000000000000
ramp_d\ta=0x1p+0 t=0x1p+0\t1.666666666666666666666666666666666666667e-1
ramp_v\ta=0x1p+0 t=0x1p+0\t5.000000000000000000000000000000000000000e-1
ramps_v\tx=0x1p+0 t=0x1p+1\t5.000000000000000000000000000000000000000e-1
ramps_a\tx=0x1p+0 t=0x1p+1\t2.500000000000000000000000000000000000000e-1
";

/// All of them.
pub const ALL: [&Kernel; 4] = [&time_to_reach::KERNEL, &distance::KERNEL, &ramp::KERNEL, &ramps::KERNEL];

/// Time to reach x from the velocity v with the acceleration a.
#[kernel(family = "sample", bound = 3, certificate = "1-47102bb14b8a40c6", result(worksheet = "reach", unit = "s"))]
pub fn time_to_reach(
    #[input(unit = "m/s", typical(1e-3, 2.0))] v: f64,
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
    #[input(unit = "m", typical(1e-6, 1e-2))] x: f64,
) -> f64 {
    require!(a > 0.0, "a > 0");
    require!(compensated!(v * v + 2.0 * a * x) >= 0.0, "v^2+2*a*x >= 0");
    let root = sqrt(compensated!(v * v + 2.0 * a * x));
    if v > 0.0 { 2.0 * x / (root + v) } else { (root - v) / a }
}

/// Distance travelled from the velocity v with the acceleration a in the time t.
#[kernel(family = "sample", bound = 1, certificate = "1-5c7a85c6a6640a7c", result(worksheet = "travel", unit = "m"))]
pub fn distance(
    #[input(unit = "m/s", typical(1e-3, 2.0))] v: f64,
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> f64 {
    require!(a > 0.0, "a > 0");
    compensated!(v * t + 0.5 * a * t * t)
}

/// What a ramp travels, and the velocity after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// Distance.
    pub d: f64,
    /// Velocity.
    pub v: f64,
}

/// Distance and velocity of a ramp from rest.
#[kernel(
    family = "sample",
    bound(d = 2.5, v = 0.5),
    certificate = "1-63563b8b0e13991f",
    results(d(worksheet = "ramp_d", unit = "m"), v(worksheet = "ramp_v", unit = "m/s"))
)]
pub fn ramp(
    #[input(unit = "m/s^2", typical(0.1, 50.0))] a: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> Ramp {
    require!(a > 0.0, "a > 0");
    require!(t >= 0.0, "t >= 0");
    Ramp { d: a * t * t / 6.0, v: 0.5 * a * t }
}

/// Velocity after two ramps of the acceleration, and its peak between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramps {
    /// Velocity at the end.
    pub v: f64,
    /// Acceleration in the middle.
    pub a: f64,
}

/// Two ramps that travel x from rest, to the peak of the acceleration and back to none, in the time t each.
#[kernel(
    family = "sample",
    bound(v = 0.5, a = 2),
    certificate = "1-c89076c25c0c28ae",
    results(v(worksheet = "ramps_v", unit = "m/s"), a(worksheet = "ramps_a", unit = "m/s^2"))
)]
pub fn ramps(
    #[input(unit = "m", typical(1e-6, 1e-2))] x: f64,
    #[input(unit = "s", typical(1e-4, 1e-1))] t: f64,
) -> Ramps {
    require!(x > 0.0, "x > 0");
    require!(t > 0.0, "t > 0");
    let v = x / t;
    Ramps { v, a: v / t }
}
