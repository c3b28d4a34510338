use closedform::kernel;

#[kernel]
pub fn f(x: f64) -> f64 {
    if x > 0.0 {
        let y = x;
        y
    } else {
        x
    }
}

fn main() {}
