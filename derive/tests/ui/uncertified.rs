use closedform::kernel;

#[kernel(family = "mine", bound = 0.5)]
pub fn f(x: f64) -> f64 {
    x / 3.0
}

fn main() {
    f::faithful(f(1.0));
}
