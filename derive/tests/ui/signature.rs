use closedform::kernel;

#[kernel]
pub async fn f(x: f64) -> f64 {
    x
}

fn main() {}
