use closedform::kernel;

pub struct Pair {
    pub a: f64,
    pub b: f64,
}

#[kernel]
pub fn f(x: f64) -> Pair {
    Pair { a: x, .. }
}

fn main() {}
