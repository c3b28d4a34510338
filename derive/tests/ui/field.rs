use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> Pair {
    Pair { 0: x }
}

fn main() {}
