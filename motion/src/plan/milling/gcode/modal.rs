//! What a block does: modes first, then what takes time, in the order of RS274/NGC.

use super::action::Action;
use super::block::Block;
use super::codes::{self, FeedMode, General, Length, Miscellaneous, Modes as Saving, Motion, Shift};
use super::curve::Curve;
use super::cycle::Cycle;
use super::dialect::Dialect;
use super::error::Problem;
use super::motion;
use super::offsets::{AXES, LETTERS};
use super::options::{DwellUnit, Reading};
use super::state::{INCH, State};
use super::table;

/// How a block ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// The next one comes.
    Next,
    /// The program is at its end (M2, M30).
    Program,
    /// A sub-program begins (M98), or one with arguments (G65).
    Call { arguments: bool },
    /// A sub-program ends (M99).
    Return,
}

/// The state, and what stays of cycles and curves.
#[derive(Debug)]
pub(super) struct Modal {
    pub(super) state: State,
    cycle: Cycle,
    curve: Curve,
}

/// What the G codes of one block ask for, apart from what stays in force.
#[derive(Default)]
struct Asked {
    motion: Option<Motion>,
    dwell: bool,
    set_position: Option<General>,
    table: bool,
    home: Option<usize>,
    set_home: Option<usize>,
    length: Option<Length>,
    machine: bool,
    stop_once: bool,
    call: bool,
    end_curve: bool,
    /// Its words belong to a code whose moves nobody knows.
    is_untimed: bool,
}

impl Modal {
    pub(super) fn new(reading: &Reading, dialect: Dialect) -> Self {
        Self { state: State::new(reading, dialect), cycle: Cycle::default(), curve: Curve::default() }
    }

    /// What a block does. With a problem, what is in force has changed, but nothing moves.
    pub(super) fn execute(&mut self, block: &mut Block, actions: &mut Vec<Action>) -> Result<End, Problem> {
        let asked = self.set_modes(block, actions)?;
        self.set_feed(block)?;
        self.extruder(block)?;
        let end = self.miscellaneous(block, actions)?;
        if let Some(length) = asked.length {
            table::tool_length(&mut self.state, length, block)?;
        }
        if asked.dwell {
            let time = self.dwell(block)?;
            actions.push(Action::Dwell(time));
        }
        if asked.is_untimed {
            return Ok(end);
        }
        if asked.call {
            return Ok(End::Call { arguments: true });
        }
        if asked.end_curve {
            return self.end_curve(actions).map(|()| end);
        }
        // The number and the count of a sub-program are no words of a move.
        let call = matches!(end, End::Call { .. }).then(|| (block.remove('P'), block.remove('L')));
        self.go(&asked, block, actions)?;
        if let Some((number, count)) = call {
            block.put('P', number);
            block.put('L', count);
        }
        Ok(end)
    }

    /// E of mills belongs to outputs (M66 to M68) and threads, and is no axis.
    fn extruder(&self, block: &mut Block) -> Result<(), Problem> {
        let dialect = self.state.dialect;
        if dialect.prints() || block.word('E').is_none() {
            return Ok(());
        }
        let is_output = block.miscellaneous.iter().any(|code| (660..=680).contains(code));
        block.remove('E');
        match is_output || block.general.contains(&760) {
            true => Ok(()),
            false => Err(Problem::Dialect { what: "the word E".to_owned(), dialect: dialect.name() }),
        }
    }

    fn set_modes(&mut self, block: &Block, actions: &mut Vec<Action>) -> Result<Asked, Problem> {
        let (mut asked, mut problem) = (Asked::default(), None);
        for code in &block.general {
            let general = match (*code, block.any("PQD")) {
                // Without the words of a turning cycle these are the units, as Mach and Siemens have them.
                (700, None) => General::Inches(true),
                (710, None) => General::Inches(false),
                _ => General::of(*code, self.state.dialect),
            };
            if let Err(wrong) = self.set_mode(general, &mut asked) {
                problem.get_or_insert(wrong);
            }
            let name = || codes::name('G', *code);
            match general {
                General::Unknown => _ = problem.get_or_insert(Problem::Code { code: name() }),
                General::Untimed => {
                    actions.extend([Action::Rest, untimed(&name())]);
                    asked.is_untimed = true;
                    if *code == 280 {
                        self.home_switches(block);
                    }
                }
                General::Compensation if !self.state.modes.is_compensated => {
                    self.state.modes.is_compensated = true;
                    let what = format!("{}: the path is timed without the compensation of the cutter", name());
                    actions.push(Action::Tell(Problem::Stopped { what }));
                }
                _ => {}
            }
        }
        // G80 beside a motion, as in the first lines of many programs, cancels the one before.
        self.state.modes.motion = asked.motion.or(self.state.modes.motion);
        problem.map_or(Ok(asked), Err)
    }

    fn set_mode(&mut self, general: General, asked: &mut Asked) -> Result<(), Problem> {
        let modes = &mut self.state.modes;
        match general {
            General::Motion(motion) => {
                modes.motion = Some(motion);
                modes.is_first = false;
                if asked.motion.replace(motion).is_some_and(|before| before != motion) {
                    return Err(Problem::Twice { what: "a motion code (G0 to G3)".to_owned() });
                }
            }
            General::Dwell => asked.dwell = true,
            General::Plane(axis) => modes.plane = axis,
            General::Inches(inches) => modes.unit = if inches { INCH } else { 1.0 },
            General::Absolute(absolute) => (modes.absolute, modes.absolute_extruder) = (absolute, absolute),
            General::AbsoluteCentre(absolute) => modes.absolute_centre = absolute,
            General::Diameter(diameter) => modes.is_diameter = diameter,
            General::Table => asked.table = true,
            General::Home(home) => asked.home = Some(home),
            General::SetHome(home) => asked.set_home = Some(home),
            General::SetPosition | General::LocalOffset => asked.set_position = Some(general),
            General::Shift(shift) => self.shift(shift),
            General::ToolLength(length) => asked.length = Some(length),
            General::Machine => asked.machine = true,
            General::System(system) => self.state.offsets.current = system,
            General::ExactStop(exact) => modes.exact_stop = exact,
            General::StopOnce => asked.stop_once = true,
            General::FeedMode(mode) => modes.feed_mode = mode,
            General::ConstantSurface(constant) => modes.constant_surface = constant,
            General::RetractToStart(start) => modes.retract_to_start = start,
            General::Cancel => (modes.motion, modes.is_first) = (None, false),
            General::EndCurve => asked.end_curve = true,
            General::Call => asked.call = true,
            General::Compensation | General::Quiet | General::Untimed | General::Unknown => {}
        }
        Ok(())
    }

    /// To its switches a printer goes in a time that nobody knows; the axes that it names, or all, are at 0 then.
    fn home_switches(&mut self, block: &Block) {
        let named = |axis: &usize| block.word(LETTERS[*axis]).is_some();
        let is_any = (0..3).any(|axis| named(&axis));
        for axis in (0..3).filter(|axis| !is_any || named(axis)) {
            self.state.position[axis] = self.state.offsets.sum(axis);
        }
    }

    fn shift(&mut self, shift: Shift) {
        let offsets = &mut self.state.offsets;
        match shift {
            Shift::Forget => (offsets.shift, offsets.is_shifted) = ([0.0; AXES], false),
            Shift::Suspend => offsets.is_shifted = false,
            Shift::Restore => offsets.is_shifted = true,
        }
    }

    /// F and S, and T.
    fn set_feed(&mut self, block: &Block) -> Result<(), Problem> {
        let modes = &mut self.state.modes;
        if let Some(speed) = block.word('S') {
            modes.spindle = speed.abs();
        }
        if let Some(tool) = block.word('T') {
            self.state.next_tool = tool.clamp(0.0, 1e9) as u32;
            if self.state.dialect.prints() {
                self.state.tool = self.state.next_tool;
            }
        }
        let Some(value) = block.word('F') else { return Ok(()) };
        // F0 stands in many files beside a rapid move, and is wrong when something cuts with it.
        if value < 0.0 || value == 0.0 && modes.motion.is_some_and(|motion| motion != Motion::Rapid) {
            return Err(Problem::Feed { value });
        }
        if value == 0.0 {
            modes.feed = None;
            return Ok(());
        }
        let (unit, minute) = (modes.unit, 60.0);
        (modes.feed, modes.plain_feed) = match modes.feed_mode {
            FeedMode::PerMinute => (Some(value * unit / minute), value / minute),
            FeedMode::PerTurn => (Some(value * unit), value),
            FeedMode::Inverse => (Some(value), value),
        };
        Ok(())
    }

    fn miscellaneous(&mut self, block: &mut Block, actions: &mut Vec<Action>) -> Result<End, Problem> {
        let mut end = End::Next;
        for index in 0..block.miscellaneous.len() {
            let code = block.miscellaneous[index];
            let name = || codes::name('M', code);
            match Miscellaneous::of(code, self.state.dialect) {
                Miscellaneous::End => end = End::Program,
                Miscellaneous::Stop => {
                    actions.push(Action::Rest);
                    actions.push(untimed(&name()));
                }
                Miscellaneous::ToolChange => {
                    self.state.tool = self.state.next_tool;
                    actions.extend([Action::Rest, Action::ToolChange]);
                }
                Miscellaneous::Spindle(turns) => {
                    actions.push(Action::Rest);
                    let before = self.state.spindle_turns;
                    self.state.spindle_turns = turns.unwrap_or(before);
                    if turns == Some(true) && !before {
                        actions.push(Action::SpindleStart);
                    }
                }
                Miscellaneous::Extruder(absolute) => self.state.modes.absolute_extruder = absolute,
                Miscellaneous::Call => end = End::Call { arguments: false },
                Miscellaneous::Return => end = End::Return,
                Miscellaneous::Modes(saving) => self.save(saving),
                Miscellaneous::Limit(code) => actions.push(Action::Limit { code, words: Box::new(*block.words()) }),
                Miscellaneous::Rest => actions.push(Action::Rest),
                Miscellaneous::Untimed => actions.extend([Action::Rest, untimed(&name())]),
                Miscellaneous::Quiet => {}
                Miscellaneous::Unknown => return Err(Problem::Code { code: name() }),
            }
        }
        Ok(end)
    }

    fn save(&mut self, saving: Saving) {
        match saving {
            Saving::Save => {
                self.state.saved.truncate(99);
                self.state.saved.push(self.state.modes);
            }
            Saving::Forget => _ = self.state.saved.pop(),
            Saving::Restore => {
                if let Some(saved) = self.state.saved.pop() {
                    self.state.modes = saved;
                }
            }
        }
    }

    /// P; or S, or X of Fanuc, which are seconds.
    fn dwell(&mut self, block: &mut Block) -> Result<f64, Problem> {
        let by_p = match self.state.dwell {
            DwellUnit::Seconds => 1.0,
            DwellUnit::Milliseconds if self.state.dialect == Dialect::Fanuc && block.has_point => 1.0,
            DwellUnit::Milliseconds => 1e-3,
        };
        let time = match (block.remove('P'), block.word('S')) {
            (Some(time), _) => time * by_p,
            (None, Some(time)) => time,
            (None, None) => block.remove('X').or_else(|| block.remove('U')).ok_or(Problem::Dwell)?,
        };
        if time >= 0.0 { Ok(time) } else { Err(Problem::Dwell) }
    }

    /// What moves, or says where something is.
    fn go(&mut self, asked: &Asked, block: &mut Block, actions: &mut Vec<Action>) -> Result<(), Problem> {
        let state = &mut self.state;
        if asked.table {
            return table::set(state, block);
        }
        if let Some(general) = asked.set_position {
            table::set_position(state, general == General::LocalOffset, block);
            return Ok(());
        }
        if let Some(home) = asked.set_home {
            state.homes[home] = (state.position, true);
            return Ok(());
        }
        if let Some(home) = asked.home {
            return motion::home(state, home, block, actions);
        }
        let begun = actions.len();
        match state.modes.motion {
            Some(Motion::Cycle(code)) => {
                if has_axes(block) || asked.motion.is_some() {
                    self.cycle.drill(state, code, asked.motion.is_some(), block, actions)?;
                }
            }
            Some(Motion::Nurbs) if block.any("XYZ").is_some() || asked.motion.is_some() => {
                self.curve.nurbs(state, asked.motion.is_some(), block)?;
            }
            Some(Motion::Cubic | Motion::Quadratic) if block.any("XYZIJPQ").is_some() => {
                let is_cubic = state.modes.motion == Some(Motion::Cubic);
                self.curve.spline(state, is_cubic, block, actions)?;
            }
            motion => motion::go(state, motion, asked.motion, asked.machine, block, actions)?,
        }
        if asked.stop_once || state.modes.exact_stop {
            for action in &mut actions[begun..] {
                if let Action::Move(cut) = action {
                    cut.stops = true;
                }
            }
        }
        Ok(())
    }

    /// A curve of points without its end (G5.3) ends where another motion comes.
    fn end_curve(&mut self, actions: &mut Vec<Action>) -> Result<(), Problem> {
        self.curve.finish(&mut self.state, actions)
    }
}

fn has_axes(block: &Block) -> bool {
    LETTERS.iter().any(|letter| block.word(*letter).is_some())
}

fn untimed(code: &str) -> Action {
    Action::Tell(Problem::Stopped { what: format!("{code} takes a time that nobody knows: it counts 0 s") })
}
