use closedform::kernel;

#[kernel(bound = -1)]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
