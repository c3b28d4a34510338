use closedform::kernel;

#[kernel]
pub fn f(#[input(units = "m")] x: f64) -> f64 {
    x
}

fn main() {}
