use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    compensated!(1.0 - x / 3.0)
}

fn main() {}
