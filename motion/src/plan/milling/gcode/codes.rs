//! What each code means for the time: its group.

use super::block::Tenths;

/// What a G code does to a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum General {
    /// G0 to G3.
    Motion(Motion),
    /// G4.
    Dwell,
    /// G17, G18, G19: the axis across the plane.
    Plane(usize),
    /// G20, G21: inches or not.
    Inches(bool),
    /// G90, G91: absolute or not.
    Absolute(bool),
    /// G90.1, G91.1: arc centres absolute or not.
    AbsoluteCentre(bool),
    /// G92: the current point gets new coordinates.
    SetPosition,
    /// Nothing that takes time.
    Quiet,
    /// G93, G95: feeds that are no speeds.
    FeedMode,
    /// G80: no motion is in force.
    Cancel,
    /// A motion that is not supported, and stays in force.
    OtherMotion,
    /// Anything else.
    Unknown,
}

/// How a block with coordinates moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    /// G0.
    Rapid,
    /// G1.
    Linear,
    /// G2.
    Clockwise,
    /// G3.
    CounterClockwise,
}

impl General {
    /// By its number in tenths.
    pub(super) fn of(code: Tenths) -> Self {
        match code {
            0 => Self::Motion(Motion::Rapid),
            10 => Self::Motion(Motion::Linear),
            20 => Self::Motion(Motion::Clockwise),
            30 => Self::Motion(Motion::CounterClockwise),
            40 => Self::Dwell,
            170 => Self::Plane(2),
            180 => Self::Plane(1),
            190 => Self::Plane(0),
            200 => Self::Inches(true),
            210 => Self::Inches(false),
            800 => Self::Cancel,
            900 => Self::Absolute(true),
            910 => Self::Absolute(false),
            901 => Self::AbsoluteCentre(true),
            911 => Self::AbsoluteCentre(false),
            920 => Self::SetPosition,
            930 | 950 => Self::FeedMode,
            // exact stop; polar, compensation, offset, scaling, rotation off; tool length and work offsets; path modes;
            // feed per minute, spindle modes, retract modes
            90 | 150 | 400 | 430 | 490 | 500 | 540..=593 | 610 | 611 | 640 | 690 | 940 | 960 | 970 | 980 | 990 => {
                Self::Quiet
            }
            // splines, threads, probing, drilling and boring cycles
            50..=53 | 330..=331 | 382..=385 | 730 | 740 | 760 | 810 | 820..=829 | 830..=890 => Self::OtherMotion,
            _ => Self::Unknown,
        }
    }
}

/// Whether an M code ends the program.
pub(super) fn ends(code: Tenths) -> bool {
    matches!(code, 20 | 300)
}

/// Whether an M code moves nothing: stops, spindle, tool, coolant, clamps, overrides, inputs and outputs, and what
/// printers add for heaters, fans, motors and extruders. Not subprograms (M96 to M99), and not what a machine's builder
/// chose.
pub(super) fn is_quiet(code: Tenths) -> bool {
    code.is_multiple_of(10)
        && matches!(
            code / 10,
            0..=11 | 13 | 14 | 17..=19 | 30 | 48..=53 | 60 | 62..=68 | 70..=73 | 82..=84 | 104..=110 | 117 | 140 | 190
        )
}

/// A code as people write it.
pub(super) fn name(letter: char, code: Tenths) -> String {
    match code % 10 {
        0 => format!("{letter}{}", code / 10),
        minor => format!("{letter}{}.{minor}", code / 10),
    }
}
