//! What each code means for the time: its group.

use super::block::Tenths;
use super::dialect::Dialect;

/// What a G code does to a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum General {
    /// Moves, and stays in force.
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
    /// G7, G8: X is a diameter or not.
    Diameter(bool),
    /// G10: offsets and tools.
    Table,
    /// G28, G30: to one of two home positions.
    Home(usize),
    /// G28.1, G30.1: here is one of two home positions.
    SetHome(usize),
    /// G92 and G52: the current point gets new coordinates.
    SetPosition,
    /// G52.
    LocalOffset,
    /// G92.1 forgets, G92.2 suspends, G92.3 restores the offset of G92.
    Shift(Shift),
    /// G43, G43.1, G43.2, G49.
    ToolLength(Length),
    /// G53: coordinates of the machine.
    Machine,
    /// G54 to G59.3.
    System(usize),
    /// G61, G61.1, G64: whether moves end at rest.
    ExactStop(bool),
    /// G9: this one does.
    StopOnce,
    /// G93, G94, G95.
    FeedMode(FeedMode),
    /// G96, G97: constant speed of the surface.
    ConstantSurface(bool),
    /// G98, G99: after a hole to where the cycle began, or to R.
    RetractToStart(bool),
    /// G80: no motion is in force.
    Cancel,
    /// G5.3: the curve is complete.
    EndCurve,
    /// G41, G42: a path that only the machine knows.
    Compensation,
    /// G65: a sub-program with arguments.
    Call,
    /// Nothing that takes time.
    Quiet,
    /// Takes a time that nobody knows.
    Untimed,
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
    /// G5.
    Cubic,
    /// G5.1.
    Quadratic,
    /// G5.2 and G6.2.
    Nurbs,
    /// G33, G32.
    Thread,
    /// G33.1, G84.2, G84.3.
    RigidTap,
    /// G38.2 to G38.5.
    Probe,
    /// G73, G74, G81 to G89.
    Cycle(u32),
    /// One that is not supported, and stays in force.
    Other(Tenths),
}

/// What becomes of the offset of G92.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shift {
    Forget,
    Suspend,
    Restore,
}

/// What a block says of the tool's length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Length {
    Table,
    Given,
    Added,
    None,
}

/// What F means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedMode {
    PerMinute,
    PerTurn,
    Inverse,
}

impl General {
    /// By its number in tenths.
    pub(super) fn of(code: Tenths, dialect: Dialect) -> Self {
        if dialect.prints() {
            return Self::of_printers(code);
        }
        match code {
            0 => Self::Motion(Motion::Rapid),
            10 => Self::Motion(Motion::Linear),
            20 => Self::Motion(Motion::Clockwise),
            30 => Self::Motion(Motion::CounterClockwise),
            50 => Self::Motion(Motion::Cubic),
            51 => Self::Motion(Motion::Quadratic),
            52 | 62 => Self::Motion(Motion::Nurbs),
            53 | 63 => Self::EndCurve,
            320 | 330 => Self::Motion(Motion::Thread),
            331 | 842 | 843 => Self::Motion(Motion::RigidTap),
            382..=385 => Self::Motion(Motion::Probe),
            // a skip signal ends it early, and is a probe
            310 => Self::Motion(Motion::Probe),
            730 | 740 | 810..=890 if code.is_multiple_of(10) => Self::Motion(Motion::Cycle(code / 10)),
            40 => Self::Dwell,
            70 => Self::Diameter(true),
            80 => Self::Diameter(false),
            100 => Self::Table,
            170 => Self::Plane(2),
            180 => Self::Plane(1),
            190 => Self::Plane(0),
            200 => Self::Inches(true),
            210 => Self::Inches(false),
            280 => Self::Home(0),
            300 => Self::Home(1),
            281 => Self::SetHome(0),
            301 => Self::SetHome(1),
            430 => Self::ToolLength(Length::Table),
            431 => Self::ToolLength(Length::Given),
            432 => Self::ToolLength(Length::Added),
            490 => Self::ToolLength(Length::None),
            410 | 411 | 420 | 421 => Self::Compensation,
            520 => Self::LocalOffset,
            530 => Self::Machine,
            540 | 550 | 560 | 570 | 580 | 590 => Self::System((code as usize - 540) / 10),
            591..=593 => Self::System(code as usize - 585),
            90 => Self::StopOnce,
            610 | 611 => Self::ExactStop(true),
            640 => Self::ExactStop(false),
            650 => Self::Call,
            800 => Self::Cancel,
            900 => Self::Absolute(true),
            910 => Self::Absolute(false),
            901 => Self::AbsoluteCentre(true),
            911 => Self::AbsoluteCentre(false),
            920 => Self::SetPosition,
            921 => Self::Shift(Shift::Forget),
            922 => Self::Shift(Shift::Suspend),
            923 => Self::Shift(Shift::Restore),
            930 => Self::FeedMode(FeedMode::Inverse),
            940 => Self::FeedMode(FeedMode::PerMinute),
            950 => Self::FeedMode(FeedMode::PerTurn),
            960 => Self::ConstantSurface(true),
            970 => Self::ConstantSurface(false),
            980 => Self::RetractToStart(true),
            990 => Self::RetractToStart(false),
            // polar, compensation, scaling, mirror, rotation off
            150 | 400 | 401 | 500 | 501 | 690 => Self::Quiet,
            700..=722 | 760 => Self::Motion(Motion::Other(code)),
            _ => Self::Unknown,
        }
    }

    /// Printers have fewer of them, and some of their own.
    fn of_printers(code: Tenths) -> Self {
        match code {
            0 => Self::Motion(Motion::Rapid),
            10 => Self::Motion(Motion::Linear),
            20 => Self::Motion(Motion::Clockwise),
            30 => Self::Motion(Motion::CounterClockwise),
            40 => Self::Dwell,
            50 => Self::Motion(Motion::Cubic),
            170 => Self::Plane(2),
            180 => Self::Plane(1),
            190 => Self::Plane(0),
            200 => Self::Inches(true),
            210 => Self::Inches(false),
            // to the home switches, levelling, probing, retraction by the firmware
            100 | 101 | 110 | 120..=139 | 260 | 270 | 280..=360 | 382..=385 | 420 | 750..=790 => Self::Untimed,
            530 => Self::Machine,
            540 | 550 | 560 | 570 | 580 | 590 => Self::System((code as usize - 540) / 10),
            591..=593 => Self::System(code as usize - 585),
            800 => Self::Cancel,
            900 => Self::Absolute(true),
            910 => Self::Absolute(false),
            920 => Self::SetPosition,
            921 => Self::Shift(Shift::Forget),
            150 | 210..=219 | 400 | 490 | 600 | 610 | 640 | 690 | 940 => Self::Quiet,
            _ => Self::Unknown,
        }
    }
}

/// What an M code does to the time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Miscellaneous {
    /// M2, M30: the program is at its end.
    End,
    /// M0, M1, M60: somebody has to press a button.
    Stop,
    /// M6.
    ToolChange,
    /// M3 to M5, M7 to M9, M19: the tool rests meanwhile; whether the spindle turns.
    Spindle(Option<bool>),
    /// M82, M83: E is absolute or not.
    Extruder(bool),
    /// M98: a sub-program.
    Call,
    /// M99: its end.
    Return,
    /// M70 to M73: what is in force is saved, or comes back.
    Modes(Modes),
    /// M201, M203, M204, M205 of printers: limits.
    Limit(u32),
    /// M400 of printers: rests.
    Rest,
    /// Takes a time that nobody knows.
    Untimed,
    /// Nothing that takes time.
    Quiet,
    /// Anything else.
    Unknown,
}

/// What M70 to M73 do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Modes {
    Save,
    Forget,
    Restore,
}

impl Miscellaneous {
    /// By its number in tenths.
    pub(super) fn of(code: Tenths, dialect: Dialect) -> Self {
        if dialect.prints() {
            return Self::of_printers(code / 10);
        }
        if !code.is_multiple_of(10) {
            return Self::Unknown;
        }
        match code / 10 {
            2 | 30 => Self::End,
            0 | 1 | 60 => Self::Stop,
            6 => Self::ToolChange,
            3 | 4 => Self::Spindle(Some(true)),
            5 => Self::Spindle(Some(false)),
            7..=9 | 13 | 14 | 19 => Self::Spindle(None),
            98 => Self::Call,
            99 => Self::Return,
            70 | 73 => Self::Modes(Modes::Save),
            71 => Self::Modes(Modes::Forget),
            72 => Self::Modes(Modes::Restore),
            // clamps, orientation, overrides, outputs
            10 | 11 | 15..=18 | 20..=29 | 31..=59 | 61..=65 | 67 | 68 => Self::Quiet,
            // inputs that are waited for
            66 => Self::Untimed,
            // files written for printers too
            82..=84 | 104..=108 | 110 | 117 | 118 | 140 => Self::Quiet,
            109 | 190 => Self::Untimed,
            // what the builder of the machine chose
            100..=999 => Self::Untimed,
            _ => Self::Unknown,
        }
    }

    fn of_printers(code: u32) -> Self {
        match code {
            2 => Self::End,
            // M30 erases a file there; at an end it means the end
            30 => Self::Quiet,
            0 | 1 | 25 | 226 | 600 => Self::Stop,
            3..=5 => Self::Spindle(None),
            82 => Self::Extruder(true),
            83 => Self::Extruder(false),
            201 | 203 | 204 | 205 => Self::Limit(code),
            400 => Self::Rest,
            // heating, cooling, fetching filament, finding the bed
            109 | 116 | 190 | 191 | 303 | 701 | 702 => Self::Untimed,
            _ => Self::Quiet,
        }
    }
}

/// A code as people write it.
pub(super) fn name(letter: char, code: Tenths) -> String {
    match code % 10 {
        0 => format!("{letter}{}", code / 10),
        minor => format!("{letter}{}.{minor}", code / 10),
    }
}
