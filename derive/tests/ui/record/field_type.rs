use closedform::Record;

#[derive(Clone, Copy, Record)]
pub struct Pair {
    pub first: f64,
    pub second: f32,
}

fn main() {}
