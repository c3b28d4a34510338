use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    x.powi(2)
}

fn main() {}
