use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    x as f64 + 1.0
}

fn main() {}
