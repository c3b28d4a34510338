use closedform::kernel;

#[kernel]
pub fn f(x: f64, y: f64) -> f64 {
    require!(-residual!(x * x - y) >= 0.0);
    x
}

#[kernel]
pub fn by_name(x: f64, y: f64) -> f64 {
    let remainder = residual!(x * x - y);
    let least = min(remainder, y);
    if least > 0.0 { x } else { y }
}

fn main() {}
