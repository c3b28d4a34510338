use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    require!(x);
    x
}

fn main() {}
