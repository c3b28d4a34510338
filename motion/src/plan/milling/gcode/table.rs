//! Offsets that a program sets: coordinate systems, tools, and what the current point is called.

use super::block::Block;
use super::codes::Length;
use super::error::Problem;
use super::offsets::{AXES, Axes, LETTERS};
use super::state::State;

/// G10.
pub(super) fn set(state: &mut State, block: &Block) -> Result<(), Problem> {
    let wrong = |why| Err(Problem::Cycle { code: "G10".to_owned(), why });
    let Some(what) = block.word('L') else { return wrong("needs L: give what it sets") };
    let number = block.word('P').unwrap_or(0.0).max(0.0) as usize;
    match what as u32 {
        2 | 20 => {
            let system = match number {
                0 => state.offsets.current,
                1..=9 => number - 1,
                _ => return wrong("names a coordinate system (P) that is none: give 1 to 9, or 0 for that in force"),
            };
            set_system(state, system, what as u32 == 20, block);
            Ok(())
        }
        // the tool table, from a position or from a number
        1 | 10..=13 => {
            let mut tool = state.tools.get(&(number as u32)).copied().unwrap_or_default();
            for (axis, letter) in LETTERS.into_iter().enumerate() {
                if let Some(value) = block.word(letter) {
                    let given = value * state.unit_of(axis);
                    let is_measured = matches!(what as u32, 10 | 11);
                    let here = state.position[axis] - state.offsets.sum(axis) + state.offsets.tool[axis];
                    tool[axis] = if is_measured { here - given } else { given };
                }
            }
            state.tools.insert(number as u32, tool);
            Ok(())
        }
        // what stands in the memory of the controller
        0 | 3 | 50 | 52 => Ok(()),
        _ => wrong("sets with this L what is not known: remove it"),
    }
}

fn set_system(state: &mut State, system: usize, from_position: bool, block: &Block) {
    let relative = !state.modes.absolute && !from_position;
    for (axis, letter) in LETTERS.into_iter().enumerate() {
        let Some(value) = block.word(letter) else { continue };
        let given = value * state.unit_of(axis);
        let other = state.offsets.sum(axis) - state.offsets.system().origin[axis];
        let origin = &mut state.offsets.systems[system].origin[axis];
        *origin = match (from_position, relative) {
            (true, _) => state.position[axis] - other - given,
            (false, true) => *origin + given,
            (false, false) => given,
        };
    }
    if let Some(turn) = block.word('R') {
        state.offsets.systems[system].turn = turn;
    }
}

/// G92, and G52.
pub(super) fn set_position(state: &mut State, is_local: bool, block: &Block) {
    let here = state.program_position();
    for (axis, letter) in LETTERS.into_iter().enumerate() {
        let Some(value) = block.word(letter) else { continue };
        let given = value * state.unit_of(axis);
        if is_local {
            state.offsets.local[axis] = given;
        } else {
            if !state.offsets.is_shifted {
                state.offsets.shift = [0.0; AXES];
            }
            state.offsets.is_shifted = true;
            state.offsets.shift[axis] += here[axis] - given;
        }
    }
}

/// G43, G43.1, G43.2, G49.
pub(super) fn tool_length(state: &mut State, length: Length, block: &mut Block) -> Result<(), Problem> {
    let of_table = |state: &State, number: u32| state.tools.get(&number).copied().unwrap_or_default();
    let number = block.remove('H').map(|number| number.max(0.0) as u32);
    match length {
        Length::None => state.offsets.tool = [0.0; AXES],
        Length::Table => state.offsets.tool = of_table(state, number.unwrap_or(state.tool)),
        Length::Given => state.offsets.tool = given(state, block),
        Length::Added => {
            let more = number.map_or_else(|| given(state, block), |number| of_table(state, number));
            for (sum, more) in state.offsets.tool.iter_mut().zip(more) {
                *sum += more;
            }
        }
    }
    Ok(())
}

fn given(state: &State, block: &mut Block) -> Axes {
    let mut axes = state.offsets.tool;
    for (axis, letter) in LETTERS.into_iter().enumerate() {
        if let Some(value) = block.remove(letter) {
            axes[axis] = value * state.unit_of(axis);
        }
    }
    axes
}
