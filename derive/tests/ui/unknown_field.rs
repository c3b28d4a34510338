use closedform::kernel;

pub struct Pair {
    pub a: f64,
    pub b: f64,
}

#[kernel(bound(c = 4))]
pub fn f(x: f64) -> Pair {
    Pair { a: x, b: x }
}

fn main() {}
