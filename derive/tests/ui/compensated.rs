use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    compensated!(x * x - sqrt(x))
}

fn main() {}
