//! Colours in an order that everybody sees, also those who are blind for colours and in black and white.

use crate::plot::theme::Theme;

/// What the colour of a path says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Colouring {
    /// The largest speed of each move.
    #[default]
    Speed,
    /// The speed that was asked for.
    Feed,
    /// The height of the tool.
    Height,
}

impl Colouring {
    pub(super) fn title(self) -> &'static str {
        match self {
            Self::Speed => "Largest speed (mm/s)",
            Self::Feed => "Feed (mm/s)",
            Self::Height => "Z (mm)",
        }
    }
}

/// How many are told apart.
pub(super) const STEPS: usize = 7;

/// On white from light to dark (after plasma of matplotlib), the largest value darkest.
const ON_LIGHT: [&str; STEPS] = ["#f4a03a", "#ea7b4b", "#d9586a", "#bd3786", "#9a179b", "#6a00a8", "#2c0594"];

/// On black from dark to light, the largest value lightest.
const ON_DARK: [&str; STEPS] = ["#7b5cc9", "#a05acb", "#c65bb4", "#e16a92", "#f28a6c", "#fbb150", "#f5e04e"];

/// From the least value to the largest one.
pub(super) fn of(theme: &Theme) -> [&'static str; STEPS] {
    if *theme == Theme::DARK { ON_DARK } else { ON_LIGHT }
}

/// The step of a value in a range.
pub(super) fn step(value: f64, (low, high): (f64, f64)) -> usize {
    let share = if high > low { (value - low) / (high - low) } else { 1.0 };
    // Not a number counts as the least.
    ((share * STEPS as f64) as usize).min(STEPS - 1)
}
