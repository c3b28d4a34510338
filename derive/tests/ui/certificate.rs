use closedform::kernel;

#[kernel(bound = 0.5, certificate = "trust me")]
pub fn f(x: f64) -> f64 {
    x / 3.0
}

fn main() {}
