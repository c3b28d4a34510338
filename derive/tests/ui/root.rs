use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    positive_root([x])
}

fn main() {}
