use closedform::kernel;

#[kernel(rules = "conjugate")]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
