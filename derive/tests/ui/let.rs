use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let y: f64 = x;
    y
}

fn main() {}
