//! Colours, light and dark.

/// Colours of a picture. Those of the curves are told apart with every colour blindness (after Okabe and Ito), and in
/// black and white by their lightness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Theme {
    /// Behind everything.
    pub background: &'static str,
    /// Titles.
    pub text: &'static str,
    /// Numbers, notes and shared limits.
    pub muted: &'static str,
    /// Lines at the ticks.
    pub grid: &'static str,
    /// Around panels, at zero, and where segments meet.
    pub frame: &'static str,
    /// Of the axes, in order, and from the first again.
    pub curves: [&'static str; 4],
}

impl Theme {
    /// For paper and bright screens.
    pub const LIGHT: Self = Self {
        background: "#ffffff",
        text: "#16191d",
        muted: "#57606a",
        grid: "#e4e7eb",
        frame: "#a9b1bb",
        curves: ["#0072b2", "#d55e00", "#009e73", "#a64d79"],
    };

    /// For dark screens.
    pub const DARK: Self = Self {
        background: "#0d1117",
        text: "#e6edf3",
        muted: "#9aa5b1",
        grid: "#222933",
        frame: "#4b5563",
        curves: ["#56b4e9", "#f0a13c", "#3dd6a3", "#e59ac6"],
    };

    /// Of a curve, by its index.
    #[must_use]
    pub fn curve(&self, index: usize) -> &'static str {
        self.curves[index % self.curves.len()]
    }
}
