//! What functions cost beside an addition in `f64`.

/// What a call costs on current 64-bit processors, in additions in `f64`, when nothing waits for it.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// In `f64`.
    pub double: u32,
    /// In double-double.
    pub double_double: u32,
    /// In balls of 256 bits.
    pub ball: u32,
}

impl Cost {
    /// Nothing.
    pub(super) const FREE: Self = Cost { double: 0, double_double: 0, ball: 0 };

    /// What an elementary function costs that takes so many additions in `f64`: the finer arithmetics take series.
    pub(super) const fn of_elementary(double: u32) -> Self {
        Cost { double, double_double: 20_000, ball: 20_000 }
    }

    /// A division in `f64`.
    pub const DIVISION: u32 = 8;
}
