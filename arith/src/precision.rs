//! `Precision`: what the function of a kernel computes in.

/// What the function of a kernel computes in; `faithful` is the same for all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// `f64`, rounded at every step.
    #[default]
    Double,
    /// What `faithful` computes in: double-double, rounded once at the end, and integers with an endless exponent where
    /// that over- or underflows.
    DoubleDouble,
    /// Balls of 256, 1,024 or 4,096 bits, in which every call bounds its own error and takes more bits until its results
    /// are right: what keeps a promise that no proof covers. Slow.
    Certified,
}

impl Precision {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Double, Self::DoubleDouble, Self::Certified];

    /// How the attribute of a kernel names it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "double",
            Self::DoubleDouble => "double-double",
            Self::Certified => "certified",
        }
    }
}
