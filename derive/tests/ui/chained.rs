use closedform::kernel;

#[kernel]
pub fn f(a: f64) -> f64 {
    require!(0.0 < a < 1.0);
    a
}

fn main() {}
