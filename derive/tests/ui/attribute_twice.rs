use closedform::kernel;

#[kernel(bound = 4, bound = 6)]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
