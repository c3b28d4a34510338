use closedform::kernel;

#[kernel(result(worksheat = "fFn"))]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
