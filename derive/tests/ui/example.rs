use closedform::kernel;

#[kernel(example(path = "f", inputs(1), results(1.0)))]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
