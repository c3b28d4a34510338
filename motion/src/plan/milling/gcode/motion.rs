//! Moves of one block: straight ones, arcs, threads, probing, and the way home.

use super::action::Action;
use super::arc;
use super::block::Block;
use super::codes::{self, FeedMode, Motion};
use super::error::Problem;
use super::offsets::{AXES, Axes, LETTERS, turned};
use super::state::State;
use crate::plan::milling::{Feed, Move, Path};

/// Letters that give an arc or a curve, and do nothing in a straight move.
const OF_ARCS: &str = "IJK";

/// What the block moves, where it has coordinates, and the motion in force is neither a cycle nor a curve.
pub(super) fn go(
    state: &mut State,
    motion: Option<Motion>,
    asked: Option<Motion>,
    machine: bool,
    block: &mut Block,
    actions: &mut Vec<Action>,
) -> Result<(), Problem> {
    if let Some(Motion::Other(code)) = asked {
        return Err(Problem::Code { code: codes::name('G', code) });
    }
    let has_axes = LETTERS.iter().any(|letter| block.word(*letter).is_some()) || block.polar != [None; 2];
    let is_arc = matches!(motion, Some(Motion::Clockwise | Motion::CounterClockwise));
    // A circle may come back to where it starts without naming the point.
    let is_circle = is_arc && asked.is_some() && block.any(OF_ARCS).is_some();
    if !has_axes && !is_circle {
        // I, J, K alone, or P, Q, R without a cycle, move nothing.
        if let Some(letter) = block.any(OF_ARCS) {
            actions.push(Action::Tell(Problem::Unused { letter }));
        }
        return Ok(());
    }
    let motion = match motion {
        Some(motion) => motion,
        // Printers move before the first code of a motion too.
        None if state.dialect.prints() => Motion::Linear,
        None if state.modes.is_first => {
            actions.push(Action::Tell(Problem::FirstMotion));
            Motion::Rapid
        }
        None => return Err(Problem::NoMotion),
    };
    if let (false, Some(letter)) = (is_arc, block.any(OF_ARCS))
        && matches!(motion, Motion::Rapid | Motion::Linear)
    {
        actions.push(Action::Tell(Problem::Unused { letter }));
    }
    let (from, to) = (state.position, target(state, machine, block)?);
    // The tool is there afterwards, even if this move is passed over.
    state.position = to;
    match motion {
        Motion::Rapid => {
            let feed = rapid(state);
            actions.push(straight(state, &from, &to, feed));
        }
        Motion::Linear => {
            let feed = feed(state, &from, &to, actions)?;
            actions.push(straight(state, &from, &to, feed));
        }
        Motion::Clockwise | Motion::CounterClockwise if is_tilted(state) => {
            tilted(state, motion == Motion::Clockwise, (&from, &to), block, actions)?;
        }
        Motion::Clockwise | Motion::CounterClockwise => {
            let frame = arc::Frame {
                plane: state.modes.plane,
                unit: state.modes.unit,
                centre_from: if state.modes.absolute_centre { Some(origin(state)) } else { None },
                prints: state.dialect.prints(),
                turn: state.offsets.system().turn,
            };
            let (from3, to3) = (spatial(&from), spatial(&to));
            let (arc, apart) = arc::arc(block, &frame, from3, to3, motion == Motion::Clockwise)?;
            actions.extend(apart.map(|apart| Action::Tell(Problem::Spiral { apart })));
            let feed = feed(state, &from, &to, actions)?;
            actions.push(Action::Move(Move { path: Path::Arc(arc), ..base(state, &from, &to, feed) }));
        }
        Motion::Thread => {
            let feed = thread(state, block)?;
            actions.push(straight(state, &from, &to, feed));
        }
        Motion::RigidTap => {
            let feed = thread(state, block)?;
            actions.push(straight(state, &from, &to, feed));
            actions.push(Action::Rest);
            actions.push(straight(state, &to, &from, feed));
            state.position = from;
        }
        Motion::Probe => {
            let feed = feed(state, &from, &to, actions)?;
            let what = "probing counts the whole way, as if it found nothing before".to_owned();
            actions.extend([straight(state, &from, &to, feed), Action::Rest, Action::Tell(Problem::Stopped { what })]);
            // An error (G38.2, G38.4) is what probing without a touch would be, so it has touched at the end.
            let has_touched = !block.general.iter().any(|code| matches!(code, 383 | 385));
            actions.push(Action::Probed(has_touched));
        }
        Motion::Other(code) => return Err(Problem::Code { code: codes::name('G', code) }),
        Motion::Cubic | Motion::Quadratic | Motion::Nurbs | Motion::Cycle(_) => {}
    }
    Ok(())
}

/// Where the program's origin is, in the machine.
fn origin(state: &State) -> [f64; 3] {
    spatial(&state.offsets.to_machine(&[0.0; AXES]))
}

/// X, Y and Z.
pub(super) fn spatial(axes: &Axes) -> [f64; 3] {
    [axes[0], axes[1], axes[2]]
}

/// Where the block's coordinates point to, in the machine.
pub(super) fn target(state: &State, machine: bool, block: &Block) -> Result<Axes, Problem> {
    let modes = &state.modes;
    let mut program = if machine { state.position } else { state.program_position() };
    let mut to = state.position;
    let mut is_named = [false; AXES];
    for axis in 0..AXES {
        let Some(value) = block.word(LETTERS[axis]) else { continue };
        let absolute = if axis == AXES - 1 { modes.absolute_extruder } else { modes.absolute };
        let given = value * state.unit_of(axis);
        program[axis] = if absolute || machine { given } else { program[axis] + given };
        is_named[axis] = true;
    }
    if let [distance, angle] = block.polar
        && (distance.is_some() || angle.is_some())
    {
        polar(&mut program, distance.map(|distance| distance * modes.unit), angle, modes.absolute);
        (is_named[0], is_named[1]) = (true, true);
    }
    if is_named[0] || is_named[1] {
        let is_turned = !machine && state.offsets.system().turn != 0.0;
        (is_named[0], is_named[1]) = (is_named[0] || is_turned, is_named[1] || is_turned);
    }
    let there = if machine { program } else { state.offsets.to_machine(&program) };
    for axis in (0..AXES).filter(|axis| is_named[*axis]) {
        // A relative move is as long as it says, wherever the origin is.
        let relative = !machine
            && state.offsets.system().turn == 0.0
            && block.polar == [None; 2]
            && !if axis == AXES - 1 { modes.absolute_extruder } else { modes.absolute };
        to[axis] = match block.word(LETTERS[axis]) {
            Some(value) if relative => state.position[axis] + value * state.unit_of(axis),
            _ => there[axis],
        };
    }
    match to.iter().all(|coordinate| coordinate.is_finite()) {
        true => Ok(to),
        false => Err(Problem::Expression { why: "is beyond the range of 64-bit numbers: correct it".to_owned() }),
    }
}

/// Distance and angle from the origin; what is not given stays.
fn polar(point: &mut Axes, distance: Option<f64>, angle: Option<f64>, absolute: bool) {
    let (radius, direction) = (point[0].hypot(point[1]), point[1].atan2(point[0]).to_degrees());
    let (radius, direction) = match absolute {
        true => (distance.unwrap_or(radius), angle.unwrap_or(direction)),
        false => (radius + distance.unwrap_or(0.0), direction + angle.unwrap_or(0.0)),
    };
    let mut there = [0.0; AXES];
    there[0] = radius;
    turned(&mut there, direction);
    (point[0], point[1]) = (there[0], there[1]);
}

/// Whether the plane of arcs is none of two axes of the machine.
fn is_tilted(state: &State) -> bool {
    state.offsets.system().turn != 0.0 && state.modes.plane != 2
}

/// Chords of an arc in such a plane are no farther from it than this, in mm.
const NEAR: f64 = 0.002;

/// An arc across a coordinate system that is turned about Z: chords, each turned.
fn tilted(
    state: &State,
    clockwise: bool,
    (from, to): (&Axes, &Axes),
    block: &Block,
    actions: &mut Vec<Action>,
) -> Result<(), Problem> {
    let (begin, end) = (state.offsets.to_program(from), state.offsets.to_program(to));
    let frame = arc::Frame {
        plane: state.modes.plane,
        unit: state.modes.unit,
        centre_from: state.modes.absolute_centre.then_some([0.0; 3]),
        prints: state.dialect.prints(),
        turn: 0.0,
    };
    let (arc, _) = arc::arc(block, &frame, spatial(&begin), spatial(&end), clockwise)?;
    let feed = feed(state, from, to, actions)?;
    let (mut here, count) = (*from, arc.chords_within(NEAR));
    for index in 1..=count {
        let share = f64::from(index) / f64::from(count);
        let mut there = std::array::from_fn(|axis| begin[axis] + share * (end[axis] - begin[axis]));
        there[..3].copy_from_slice(&arc.at(spatial(&begin), spatial(&end), share));
        let there = if index == count { *to } else { state.offsets.to_machine(&there) };
        actions.push(straight(state, &here, &there, feed));
        here = there;
    }
    Ok(())
}

/// A move from point to point, as the state has it.
pub(super) fn base(state: &State, from: &Axes, to: &Axes, feed: Feed) -> Move {
    let others = std::array::from_fn(|axis| to[axis + 3] - from[axis + 3]);
    Move {
        line: state.line,
        others,
        tool: state.tool,
        feature: state.feature,
        ..Move::straight(spatial(from), spatial(to), feed)
    }
}

pub(super) fn straight(state: &State, from: &Axes, to: &Axes, feed: Feed) -> Action {
    Action::Move(base(state, from, to, feed))
}

/// Rapid moves: printers obey F there too.
pub(super) fn rapid(state: &State) -> Feed {
    match state.modes.feed {
        Some(feed) if state.dialect.prints() => Feed::RapidAt(feed),
        _ => Feed::Rapid,
    }
}

/// The feed that is in force: along X, Y, Z; of turning axes, where only they move, in degrees.
pub(super) fn feed(state: &State, from: &Axes, to: &Axes, actions: &mut Vec<Action>) -> Result<Feed, Problem> {
    let modes = &state.modes;
    let Some(feed) = modes.feed else {
        // One may be in force from before: the fastest is the least time.
        actions.push(Action::Tell(Problem::NoFeed));
        return Ok(Feed::Unknown);
    };
    let moves = |axes: std::ops::Range<usize>| axes.into_iter().any(|axis| from[axis] != to[axis]);
    match modes.feed_mode {
        FeedMode::Inverse => Ok(Feed::Within(60.0 / feed)),
        FeedMode::PerMinute if moves(3..6) && !moves(0..3) && !moves(6..AXES) => Ok(Feed::Speed(modes.plain_feed)),
        FeedMode::PerMinute => Ok(Feed::Speed(feed)),
        FeedMode::PerTurn => Ok(Feed::Speed(feed * turns(state, from)?)),
    }
}

/// Turns of the spindle a second. With constant speed of the surface, S is that speed, in m or feet a minute, and X says
/// how large the work piece is there.
fn turns(state: &State, at: &Axes) -> Result<f64, Problem> {
    let modes = &state.modes;
    if modes.spindle <= 0.0 {
        return Err(Problem::NoSpindle);
    }
    if !modes.constant_surface {
        return Ok(modes.spindle / 60.0);
    }
    let speed = modes.spindle * if modes.unit == 1.0 { 1000.0 } else { 304.8 } / 60.0;
    // Near the axis the spindle would turn without bound: a thousandth of a millimetre is as near as it comes.
    let radius = (at[0] - state.offsets.sum(0)).abs().max(1e-3);
    Ok(speed / (std::f64::consts::TAU * radius))
}

/// A thread: K a turn.
fn thread(state: &State, block: &Block) -> Result<Feed, Problem> {
    let pitch = block.word('K').or(block.word('F')).map(|pitch| pitch.abs() * state.modes.unit);
    match pitch {
        Some(pitch) if pitch > 0.0 && state.modes.spindle > 0.0 => Ok(Feed::Speed(pitch * state.modes.spindle / 60.0)),
        Some(pitch) if pitch > 0.0 => Err(Problem::NoSpindle),
        _ => Err(Problem::Cycle { code: "the thread".to_owned(), why: "needs its pitch: give K" }),
    }
}

/// G28, G30: over the point that the block names to the home position of the axes that it names, or of all.
pub(super) fn home(state: &mut State, home: usize, block: &Block, actions: &mut Vec<Action>) -> Result<(), Problem> {
    let (there, is_given) = state.homes[home];
    let named: Vec<usize> = (0..AXES).filter(|axis| block.word(LETTERS[*axis]).is_some()).collect();
    let feed = rapid(state);
    let mut to = state.position;
    if !named.is_empty() {
        let over = target(state, false, block)?;
        actions.push(straight(state, &state.position, &over, feed));
        to = over;
    }
    let from = to;
    for axis in 0..AXES {
        if named.is_empty() || named.contains(&axis) {
            to[axis] = there[axis];
        }
    }
    state.position = to;
    actions.push(straight(state, &from, &to, feed));
    if !is_given {
        let what = "where home is, no file says: it counts as where the tool was at the begin; give home".to_owned();
        actions.push(Action::Tell(Problem::Stopped { what }));
    }
    Ok(())
}
