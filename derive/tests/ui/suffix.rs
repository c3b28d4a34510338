use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    2.0f64 * x
}

fn main() {}
