use closedform::kernel;

#[kernel(certificate = "1-0123456789abcdef")]
pub fn f(x: f64) -> f64 {
    x / 3.0
}

fn main() {}
