//! The state of a controller: what stays in force from line to line.

use std::collections::HashMap;

use super::codes::{FeedMode, Motion};
use super::dialect::Dialect;
use super::offsets::{AXES, Axes, LETTERS, Offsets};
use super::options::{DwellUnit, Reading};
use super::parameters::Controller;

/// Millimetres in an inch.
pub(super) const INCH: f64 = 25.4;

/// Feed of printers before the first F, in mm/s: Marlin's and Klipper's.
const PRINTER_FEED: f64 = 25.0;

/// What M70 saves and M72 brings back.
#[derive(Debug, Clone, Copy)]
pub(super) struct Modes {
    pub(super) motion: Option<Motion>,
    /// Whether there was none yet.
    pub(super) is_first: bool,
    /// The axis across the plane of arcs.
    pub(super) plane: usize,
    /// Millimetres in a unit.
    pub(super) unit: f64,
    pub(super) absolute: bool,
    pub(super) absolute_extruder: bool,
    pub(super) absolute_centre: bool,
    pub(super) is_diameter: bool,
    pub(super) feed_mode: FeedMode,
    /// In mm/s, or mm a turn.
    pub(super) feed: Option<f64>,
    /// The same for axes that turn, in degrees/s; what F says for inverse time.
    pub(super) plain_feed: f64,
    pub(super) exact_stop: bool,
    pub(super) retract_to_start: bool,
    pub(super) constant_surface: bool,
    pub(super) spindle: f64,
    pub(super) is_compensated: bool,
}

/// All of it.
#[derive(Debug)]
pub(super) struct State {
    pub(super) dialect: Dialect,
    /// Of the machine, in mm and degrees.
    pub(super) position: Axes,
    pub(super) offsets: Offsets,
    pub(super) modes: Modes,
    pub(super) saved: Vec<Modes>,
    pub(super) dwell: DwellUnit,
    pub(super) tool: u32,
    /// The tool that T has named.
    pub(super) next_tool: u32,
    pub(super) tools: HashMap<u32, Axes>,
    /// Of G28 and G30, and whether somebody has said where they are.
    pub(super) homes: [(Axes, bool); 2],
    pub(super) spindle_turns: bool,
    /// Of the comment that names what is milled.
    pub(super) feature: u32,
    pub(super) line: u64,
}

impl State {
    pub(super) fn new(reading: &Reading, dialect: Dialect) -> Self {
        let at = |point: [f64; 3]| {
            let mut axes = [0.0; AXES];
            axes[..3].copy_from_slice(&point);
            axes
        };
        let feed = reading.default_feed.or(dialect.prints().then_some(PRINTER_FEED));
        let dwell = reading.dwell.unwrap_or(match dialect.dwells_in_milliseconds() {
            true => DwellUnit::Milliseconds,
            false => DwellUnit::Seconds,
        });
        let home = (at(reading.home.unwrap_or(reading.start)), reading.home.is_some());
        Self {
            dialect,
            position: at(reading.start),
            offsets: Offsets::new(),
            modes: Modes {
                // Printers move at once; mills must be told how.
                motion: None,
                is_first: true,
                plane: 2,
                unit: 1.0,
                absolute: true,
                absolute_extruder: true,
                absolute_centre: false,
                is_diameter: false,
                feed_mode: FeedMode::PerMinute,
                feed,
                plain_feed: feed.unwrap_or(0.0),
                exact_stop: false,
                retract_to_start: true,
                constant_surface: false,
                spindle: 0.0,
                is_compensated: false,
            },
            saved: Vec::new(),
            dwell,
            tool: 0,
            next_tool: 0,
            tools: HashMap::new(),
            homes: [home; 2],
            spindle_turns: false,
            feature: 0,
            line: 0,
        }
    }

    /// Millimetres in a unit of an axis; degrees are degrees.
    pub(super) fn unit_of(&self, axis: usize) -> f64 {
        match axis {
            0 if self.modes.is_diameter => self.modes.unit / 2.0,
            3..=5 => 1.0,
            _ => self.modes.unit,
        }
    }

    /// Where the tool is in the program's coordinates, in mm and degrees.
    pub(super) fn program_position(&self) -> Axes {
        self.offsets.to_program(&self.position)
    }

    /// A parameter of an axis, 0 for X: where it is, in units of the program.
    fn coordinate(&self, axes: &Axes, axis: u32) -> Option<f64> {
        let axis = axis as usize;
        (axis < AXES - 1).then(|| axes[axis] / self.unit_of(axis))
    }
}

impl Controller for State {
    fn number(&self, number: u32) -> Option<f64> {
        match number {
            5161..=5169 => self.coordinate(&self.homes[0].0, number - 5161),
            5181..=5189 => self.coordinate(&self.homes[1].0, number - 5181),
            5210 => Some(f64::from(u8::from(self.offsets.is_shifted))),
            5211..=5219 => self.coordinate(&self.offsets.shift, number - 5211),
            5220 => Some(self.offsets.current as f64 + 1.0),
            5221..=5400 if (number - 5221) % 20 < 9 => {
                let system = self.offsets.systems.get(((number - 5221) / 20) as usize)?;
                self.coordinate(&system.origin, (number - 5221) % 20)
            }
            5400 => Some(f64::from(self.tool)),
            5401..=5409 => self.coordinate(&self.offsets.tool, number - 5401),
            5420..=5428 => self.coordinate(&self.program_position(), number - 5420),
            // of Fanuc: the end of the block before, of the machine, and of the work piece
            5001..=5009 => self.coordinate(&self.program_position(), number - 5001),
            5021..=5029 => self.coordinate(&self.position, number - 5021),
            5041..=5049 => self.coordinate(&self.program_position(), number - 5041),
            _ => None,
        }
    }

    fn name(&self, name: &str) -> Option<f64> {
        let truth = |truth: bool| Some(f64::from(u8::from(truth)));
        let (machine, letter) = match name.strip_prefix("abs_") {
            Some(letter) => (true, letter),
            None => (false, name),
        };
        if let Some(axis) = LETTERS.iter().position(|known| letter.eq_ignore_ascii_case(&known.to_string())) {
            let axes = if machine { self.position } else { self.program_position() };
            return self.coordinate(&axes, axis as u32);
        }
        let modes = &self.modes;
        match name {
            "metric" => truth(modes.unit == 1.0),
            "imperial" => truth(modes.unit != 1.0),
            "absolute" => truth(modes.absolute),
            "incremental" => truth(!modes.absolute),
            "feed" => Some(modes.plain_feed * 60.0),
            "rpm" => Some(modes.spindle),
            "line" => Some(self.line as f64),
            "current_tool" | "tool_in_spindle" => Some(f64::from(self.tool)),
            "selected_tool" => Some(f64::from(self.next_tool)),
            "spindle_on" => truth(self.spindle_turns),
            "spindle_cw" => truth(self.spindle_turns),
            "coord_system" => Some(540.0 + 10.0 * self.offsets.current.min(5) as f64),
            "plane" => Some([190.0, 180.0, 170.0][modes.plane]),
            "motion_mode" => Some(match modes.motion {
                Some(Motion::Linear) => 10.0,
                Some(Motion::Clockwise) => 20.0,
                Some(Motion::CounterClockwise) => 30.0,
                Some(Motion::Cycle(code)) => 10.0 * f64::from(code),
                Some(_) => 0.0,
                None => 800.0,
            }),
            "ijk_absolute_mode" => truth(modes.absolute_centre),
            "lathe_diameter_mode" => truth(modes.is_diameter),
            "lathe_radius_mode" => truth(!modes.is_diameter),
            "inverse_time" => truth(modes.feed_mode == FeedMode::Inverse),
            "units_per_minute" => truth(modes.feed_mode == FeedMode::PerMinute),
            "units_per_rev" => truth(modes.feed_mode == FeedMode::PerTurn),
            "retract_old_z" => truth(modes.retract_to_start),
            "retract_r_plane" => truth(!modes.retract_to_start),
            "spindle_rpm_mode" => truth(!modes.constant_surface),
            "spindle_css_mode" => truth(modes.constant_surface),
            "cutter_comp" | "tool_offset" | "mist" | "flood" | "task" | "call_level" | "value" | "value_returned"
            | "speed_override" | "feed_override" | "adaptive_feed" | "feed_hold" | "current_pocket"
            | "selected_pocket" | "remap_level" => Some(0.0),
            "vmajor" => Some(2.9),
            "vminor" => Some(0.0),
            _ => None,
        }
    }
}
