use closedform::kernel;

#[kernel]
pub fn f(mut x: f64) -> f64 {
    1.0
}

fn main() {}
