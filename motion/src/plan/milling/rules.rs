//! Rules by which a controller looks ahead.

use crate::error::PlanError;

/// How fast a corner is passed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Corner {
    /// By junction deviation, in mm: on a circle that touches both legs and passes the corner at that distance the
    /// acceleration is at its limit (grbl; Marlin, where it has no classic jerk).
    Deviation(f64),
    /// By the speed of a right-angled corner, in mm/s (Klipper's square corner velocity).
    Square(f64),
    /// By the jump of speed that each axis X, Y, Z may make, in mm/s (Marlin's classic jerk).
    Jump([f64; 3]),
}

/// How an arc is driven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Arcs {
    /// As chords that are no farther from it than this, in mm; their corners limit the speed (grbl).
    Tolerance(f64),
    /// As chords of this length, in mm (Marlin, Klipper).
    Length(f64),
    /// As an arc: the acceleration across it limits the speed.
    Whole,
}

/// What a controller does to be fast without a stop at every point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// How fast a corner is passed.
    pub corner: Corner,
    /// How an arc is driven.
    pub arcs: Arcs,
    /// How many moves (of an arc, chords) are known beyond the one that is driven. At the end of the last of them the
    /// machine must be able to rest.
    pub ahead: usize,
    /// Whether moves shorter than 1 mm that turn little are taken for pieces of a curve: its radius, their length by the
    /// angle of the turn, limits the speed too (Marlin).
    pub follows_curves: bool,
    /// Limit of the jerk along the path, in mm/s³; infinite where the acceleration may jump.
    pub jerk: f64,
    /// Which part of the way of a short move between corners is cruised at least, from 0 to below 1 (Klipper).
    pub cruise_ratio: f64,
}

/// More moves than this no controller looks ahead.
const MOST_AHEAD: usize = 1 << 16;

impl Rules {
    /// grbl's with its default settings: junction deviation 0.01 mm, arc tolerance 0.002 mm, 16 blocks.
    pub const GRBL: Self = Self {
        corner: Corner::Deviation(0.01),
        arcs: Arcs::Tolerance(0.002),
        ahead: 16,
        follows_curves: false,
        jerk: f64::INFINITY,
        cruise_ratio: 0.0,
    };

    /// Marlin's with its default settings: junction deviation 0.013 mm, chords of 1 mm, 16 blocks.
    pub const MARLIN: Self = Self {
        corner: Corner::Deviation(0.013),
        arcs: Arcs::Length(1.0),
        ahead: 16,
        follows_curves: true,
        jerk: f64::INFINITY,
        cruise_ratio: 0.0,
    };

    /// Klipper's with its default settings: a square corner velocity of 5 mm/s, chords of 1 mm, a minimum cruise ratio of
    /// 0.5. It looks ahead in time, which is more moves than any needs to stop.
    pub const KLIPPER: Self = Self {
        corner: Corner::Square(5.0),
        arcs: Arcs::Length(1.0),
        ahead: 256,
        follows_curves: false,
        jerk: f64::INFINITY,
        cruise_ratio: 0.5,
    };

    /// Whether all of them can be kept.
    pub(super) fn check(&self) -> Result<(), PlanError> {
        let wrong = |name, value, remedy| Err(PlanError::Input { name, value, remedy });
        let corner = match self.corner {
            Corner::Deviation(value) | Corner::Square(value) => [value; 3],
            Corner::Jump(values) => values,
        };
        if let Some(value) = corner.into_iter().find(|value| !(*value >= 0.0 && value.is_finite())) {
            return wrong("the limit of corners", value, "make it 0 or positive, and finite");
        }
        if let Arcs::Tolerance(value) | Arcs::Length(value) = self.arcs
            && !(value > 0.0 && value.is_finite())
        {
            return wrong("the limit of chords", value, "make it positive and finite");
        }
        if !(1..=MOST_AHEAD).contains(&self.ahead) {
            return wrong("the number of moves ahead", self.ahead as f64, "make it 1 to 65536");
        }
        if self.jerk.is_nan() || self.jerk <= 0.0 {
            return wrong("the jerk limit", self.jerk, "make it positive, or infinite where there is none");
        }
        if !(self.cruise_ratio >= 0.0 && self.cruise_ratio < 1.0) {
            return wrong("the minimum cruise ratio", self.cruise_ratio, "make it 0 or more, and less than 1");
        }
        if self.cruise_ratio > 0.0 && self.jerk.is_finite() {
            let remedy = "make it 0 where the jerk is limited: no controller has both";
            return wrong("the minimum cruise ratio", self.cruise_ratio, remedy);
        }
        Ok(())
    }
}

impl Default for Rules {
    fn default() -> Self {
        Self::GRBL
    }
}
