use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    let y = x;
    require!(x > 0.0);
    y
}

fn main() {}
