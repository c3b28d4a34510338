use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> Option<f64> {
    x
}

fn main() {}
