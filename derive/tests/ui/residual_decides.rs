use closedform::kernel;

#[kernel]
pub fn f(x: f64, y: f64) -> f64 {
    require!(-residual!(x * x - y) >= 0.0);
    x
}

fn main() {}
