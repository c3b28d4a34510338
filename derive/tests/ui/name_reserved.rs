use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let sqrt = x;
    sqrt
}

fn main() {}
