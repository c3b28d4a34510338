use closedform::kernel;

#[kernel(bound = 0.5, certificate = "1-0123456789abcdef")]
pub fn f(x: f64) -> f64 {
    x / 3.0
}

fn main() {}
