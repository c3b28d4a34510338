use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    sin(x)
}

fn main() {}
