use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let x = 2.0 * x;
    x
}

fn main() {}
