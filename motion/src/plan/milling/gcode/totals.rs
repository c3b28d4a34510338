//! What a program adds up to: times and ways, by kind, tool and feature.

use std::collections::HashMap;

use super::dialect::Dialect;
use crate::plan::milling::Row;
use crate::plan::milling::sum::Sum;

/// More features than this share one name.
const MOST_FEATURES: usize = 1000;
/// The most letters of a name.
const LONGEST: usize = 60;

/// A file, timed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Summary {
    /// Which controller it was read for.
    pub dialect: Option<Dialect>,
    /// Lines of the file, to the end of the program.
    pub lines: u64,
    /// Moves, those without length too.
    pub moves: u64,
    /// Lines that were passed over, or that take a time that nobody knows: with any, the time is at least what is said.
    pub notices: u64,
    /// Of the whole program, in s.
    pub time: f64,
    /// Of the moves at feed (G1, G2, G3), in s.
    pub cutting_time: f64,
    /// Of the rapid moves (G0), in s.
    pub rapid_time: f64,
    /// Of the dwells (G4), in s.
    pub dwell_time: f64,
    /// Of tool changes, in s.
    pub tool_change_time: f64,
    /// Of the spindle to come to its speed, in s.
    pub spindle_time: f64,
    /// How many.
    pub tool_changes: u64,
    /// How often the spindle begins to turn.
    pub spindle_starts: u64,
    /// Of the way at feed, in mm.
    pub cutting_length: f64,
    /// Of the rapid way, in mm.
    pub rapid_length: f64,
    /// Numbers of tools, in order, and the times of their moves, in s.
    pub tools: Vec<(u32, f64)>,
    /// Comments that stand alone in a line name what comes after them; the times of those moves, in s, in order.
    pub features: Vec<(String, f64)>,
}

/// Sums that grow with the moves.
#[derive(Debug, Default)]
pub(super) struct Totals {
    pub(super) notices: u64,
    pub(super) tool_changes: u64,
    pub(super) spindle_starts: u64,
    pub(super) moves: u64,
    cutting_time: Sum,
    rapid_time: Sum,
    pub(super) dwell_time: Sum,
    cutting_length: Sum,
    rapid_length: Sum,
    tools: HashMap<u32, Sum>,
    last_tool: (u32, Sum),
    features: Vec<(String, Sum)>,
    names: HashMap<String, u32>,
}

impl Totals {
    /// Adds a move.
    pub(super) fn add(&mut self, row: &Row) {
        let (time, length) = match row.cut.feed.is_rapid() {
            true => (&mut self.rapid_time, &mut self.rapid_length),
            false => (&mut self.cutting_time, &mut self.cutting_length),
        };
        time.add(row.time);
        length.add(row.length);
        self.moves += 1;
        if row.cut.tool != self.last_tool.0 {
            let last = std::mem::take(&mut self.last_tool);
            self.tools.insert(last.0, last.1);
            self.last_tool = (row.cut.tool, self.tools.remove(&row.cut.tool).unwrap_or_default());
        }
        self.last_tool.1.add(row.time);
        if let Some((_, sum)) = self.features.get_mut(row.cut.feature as usize) {
            sum.add(row.time);
        }
    }

    /// The number of a feature; 0 is that of none.
    pub(super) fn feature(&mut self, name: &[u8]) -> u32 {
        if self.features.is_empty() {
            self.features.push((String::new(), Sum::default()));
        }
        let name: String =
            String::from_utf8_lossy(name).chars().filter(|letter| !letter.is_control()).take(LONGEST).collect();
        if let Some(known) = self.names.get(&name) {
            return *known;
        }
        if self.features.len() > MOST_FEATURES || name.is_empty() {
            return 0;
        }
        let number = self.features.len() as u32;
        self.names.insert(name.clone(), number);
        self.features.push((name, Sum::default()));
        number
    }

    /// All of them, at the end.
    pub(super) fn summary(mut self, time: f64, lines: u64, dialect: Dialect) -> Summary {
        self.tools.insert(self.last_tool.0, self.last_tool.1);
        let mut tools: Vec<(u32, f64)> = self.tools.iter().map(|(tool, time)| (*tool, time.value())).collect();
        tools.retain(|(_, time)| *time > 0.0);
        tools.sort_by_key(|(tool, _)| *tool);
        let features = self.features.into_iter().map(|(name, time)| (name, time.value()));
        Summary {
            dialect: Some(dialect),
            lines,
            moves: self.moves,
            notices: self.notices,
            time,
            cutting_time: self.cutting_time.value(),
            rapid_time: self.rapid_time.value(),
            dwell_time: self.dwell_time.value(),
            tool_changes: self.tool_changes,
            spindle_starts: self.spindle_starts,
            cutting_length: self.cutting_length.value(),
            rapid_length: self.rapid_length.value(),
            tools,
            features: features.filter(|(_, time)| *time > 0.0).collect(),
            ..Summary::default()
        }
    }
}
