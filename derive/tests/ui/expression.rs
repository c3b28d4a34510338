use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let y = [x, x];
    x
}

fn main() {}
