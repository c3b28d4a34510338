use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    require!(x > 0.0, x);
    x
}

fn main() {}
