use closedform::kernel;

#[kernel(example(inputs(1.0)))]
pub fn f(x: f64) -> f64 {
    x
}

fn main() {}
