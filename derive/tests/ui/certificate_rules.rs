use closedform::kernel;

#[kernel(bound = 0.5, certificate = "0-0123456789abcdef")]
pub fn f(x: f64) -> f64 {
    x / 3.0
}

fn main() {}
