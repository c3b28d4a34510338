//! Sources as the generator writes them, for tests.

use std::fs;

use tempfile::TempDir;

use super::Catalogue;

/// Two kernels; `slope` is less accurate than it says where `b` is not a power of two.
pub const LINE: &str = r#"// Generated.
//! Lines.

use closedform::kernel;

/// Where a parabola ends.
///
/// # Domain
#[kernel(
    family = "line",
    maxima = "rootFn(aMax,b):=sqrt(aMax^2+b)-aMax",
    latex = "\\sqrt{a^2+b}-a",
    source = "1.1 %o2",
    rules("conjugate"),
    bound = 3.5,
    result(worksheet = "rootFn", unit = "s"),
)]
pub fn root(
    #[input(maxima = "aMax", unit = "s", typical(0.001, 1000.0))] a_max: f64,
    #[input(maxima = "b", unit = "s^2", typical(0.001, 1000.0))] b: f64,
) -> f64 {
    require!(a_max >= 0.0, "aMax >= 0");
    require!(b > 0.0, "b > 0");
    require!(b < 1000000.0 || a_max < b, "b < 1000000 or aMax < b");
    b / (sqrt(a_max * a_max + b) + a_max)
}

/// A difference without its digits.
#[kernel(
    family = "line",
    maxima = "slopeFn(x,b):=x+b-x",
    rules(),
    bound = 0.5,
    result(worksheet = "slopeFn", unit = "1"),
)]
pub fn slope(
    #[input(maxima = "x", unit = "1", typical(1.0, 1000.0))] x: f64,
    #[input(maxima = "b", unit = "1", typical(1.0, 1000.0))] b: f64,
) -> f64 {
    require!(x > 0.0, "x > 0");
    require!(b > 0.0, "b > 0");
    x + b - x
}
"#;

/// A kernel of two results.
pub const PLANE: &str = r#"/// What [`slope`](fn@slope) returns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// `cFn`
    pub c: f64,
    /// `dFn`
    pub d: f64,
}

/// Twice and half.
#[kernel(
    family = "plane",
    maxima = "cFn(x):=2*x\ndFn(x):=x/3",
    rules("factored"),
    bound(c = 0.0, d = 0.5),
    results(
        c(worksheet = "cFn", unit = "m"),
        d(worksheet = "dFn", unit = "m"),
    ),
)]
pub fn slope(
    #[input(maxima = "x", unit = "m", typical(1.0, 10.0))] x: f64,
) -> Slope {
    Slope {
        c: 2.0 * x,
        d: x / 3.0,
    }
}
"#;

/// A folder with both sources, and their catalogue.
pub fn catalogue() -> (TempDir, Catalogue) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in [("line.rs", LINE), ("plane.rs", PLANE), ("mod.rs", "pub mod line;")] {
        fs::write(folder.path().join(name), text).expect("a file");
    }
    let catalogue = Catalogue::load(folder.path()).expect("kernels");
    (folder, catalogue)
}
