use closedform::kernel;

#[kernel]
pub fn f() -> f64 {
    1.0
}

fn main() {}
