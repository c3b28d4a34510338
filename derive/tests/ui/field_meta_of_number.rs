use closedform::kernel;

#[kernel(bound(f = 4))]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
