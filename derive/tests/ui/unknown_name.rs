use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let y = z;
    x + y
}

fn main() {}
