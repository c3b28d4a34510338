use closedform::kernel;

#[kernel]
pub fn f(
    x0: f64, x1: f64, x2: f64, x3: f64, x4: f64, x5: f64, x6: f64, x7: f64, x8: f64, x9: f64, x10: f64, x11: f64, x12: f64, x13: f64, x14: f64, x15: f64,
    y: f64,
) -> f64 {
    x0
}

fn main() {}
