use closedform::kernel;

#[kernel(family = 3)]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
