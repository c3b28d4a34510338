use closedform::kernel;

#[kernel(precision = "quadruple")]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
