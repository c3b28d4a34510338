use closedform::kernel;

#[kernel]
pub fn f(#[input(typical(2.0, 1.0))] x: f64) -> f64 {
    x
}

fn main() {}
