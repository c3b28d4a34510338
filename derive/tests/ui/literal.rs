use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let y = "two";
    x * y
}

fn main() {}
