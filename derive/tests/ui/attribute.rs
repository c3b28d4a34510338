use closedform::kernel;

#[kernel(famly = "turnaround")]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
