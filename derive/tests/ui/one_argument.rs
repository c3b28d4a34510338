use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    sqrt(x, x)
}

fn main() {}
