use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    compensated!(x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x - 1.0)
}

fn main() {}
