//! The segments of a plan as constants: a module of Rust for `closedform-player`, or a header of C with the same numbers.
//!
//! Every number reads back to the same bits, so a player of the constants says what the plan says.

use std::io::Write;
use std::path::Path;

use super::error::ExportError;
use super::scaling::{self, Scaling};
use crate::file::write_whole;
use crate::motion::{Axis, Motion};
use crate::segment::{Segment, State};

/// In which language constants are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Language {
    /// Statics for `closedform_player::Player::new`.
    Rust,
    /// A header with arrays.
    C,
}

/// What a header says of itself, and how a segment is evaluated.
const C_HEAD: &str = "/* The segments of a plan. A segment has constant snap, and its jerk at time 0.
 * At a time t from its start, up to half its duration:
 *   acceleration = a + t * (jerk + t * (snap / 2))
 *   velocity = v + t * (a + t * (jerk / 2 + t * (snap / 6)))
 *   position = x + t * (v + t * (a / 2 + t * (jerk / 6 + t * (snap / 24))))
 * from x, v, a = start; in the second half from end, with t - duration for t, and jerk + snap * duration for jerk. */
#ifndef CLOSEDFORM_SEGMENT
#define CLOSEDFORM_SEGMENT
struct closedform_state { double position, velocity, acceleration; };
struct closedform_segment {
    double duration;
    struct closedform_state start, end;
    double jerk, snap;
};
#endif
";

/// Writes the segments of all axes into a file, whole or not at all; how many there are.
///
/// # Errors
///
/// Not as many scalings as axes; two axes whose names are one in a program; more segments than the buffer holds; the file
/// system.
pub fn save_constants(
    path: &Path,
    language: Language,
    scalings: &[Scaling],
    most: Option<u64>,
    motion: &Motion,
) -> Result<u64, ExportError> {
    write_whole(path, |out| write_constants(out, language, scalings, most, motion))
}

/// The same to any place.
///
/// # Errors
///
/// As of [`save_constants`].
pub fn write_constants(
    out: &mut impl Write,
    language: Language,
    scalings: &[Scaling],
    most: Option<u64>,
    motion: &Motion,
) -> Result<u64, ExportError> {
    let axes = motion.axes();
    let scalings = scaling::of_axes(scalings, axes.len())?;
    let names: Vec<String> = axes.iter().map(|axis| identifier(&axis.name)).collect();
    if let Some(name) = names.iter().enumerate().find(|(index, name)| names[..*index].contains(name)) {
        return Err(ExportError::Names { name: name.1.clone() });
    }
    let count: u64 = axes.iter().map(|axis| axis.profile.segments().len() as u64).sum();
    if let Some(most) = most.filter(|most| count > *most) {
        return Err(ExportError::Many { most });
    }
    match language {
        Language::Rust => {
            writeln!(out, "// The segments of a plan, and when each starts and the last one ends.")?;
            writeln!(out, "use closedform_player::{{Segment, State}};")?;
        }
        Language::C => write!(out, "{C_HEAD}")?,
    }
    for ((axis, scaling), name) in axes.iter().zip(&scalings).zip(&names) {
        table(out, language, axis, scaling, name)?;
    }
    out.flush()?;
    Ok(count)
}

fn table(
    out: &mut impl Write,
    language: Language,
    axis: &Axis,
    scaling: &Scaling,
    name: &str,
) -> Result<(), ExportError> {
    let (segments, times) = (axis.profile.segments(), axis.profile.times());
    let (lower, counts) = (name.to_lowercase(), [segments.len(), times.len()]);
    let times = times.iter().map(|time| format!("{time:?}")).collect::<Vec<_>>().join(", ");
    let lines = segments.iter().map(|segment| segment_text(language, segment, scaling));
    let lines: String = lines.map(|line| format!("    {line},\n")).collect();
    match language {
        Language::Rust => {
            writeln!(out, "pub static {name}_SEGMENTS: [Segment; {}] = [\n{lines}];", counts[0])?;
            writeln!(out, "pub static {name}_TIMES: [f64; {}] = [{times}];", counts[1])?;
        }
        Language::C => {
            writeln!(out, "static const struct closedform_segment {lower}_segments[{}] = {{\n{lines}}};", counts[0])?;
            writeln!(out, "static const double {lower}_times[{}] = {{{times}}};", counts[1])?;
        }
    }
    Ok(())
}

fn segment_text(language: Language, segment: &Segment, scaling: &Scaling) -> String {
    let Segment { duration, start, end, jerk, snap } = *segment;
    let (jerk, snap) = (jerk * scaling.counts, snap * scaling.counts);
    let [start, end] = [start, end].map(|state| state_text(language, &state, scaling));
    match language {
        Language::Rust => {
            format!("Segment {{ duration: {duration:?}, start: {start}, end: {end}, jerk: {jerk:?}, snap: {snap:?} }}")
        }
        Language::C => format!("{{{duration:?}, {start}, {end}, {jerk:?}, {snap:?}}}"),
    }
}

fn state_text(language: Language, state: &State, scaling: &Scaling) -> String {
    let (x, v, a) =
        (scaling.position(state.position), scaling.velocity(state.velocity), state.acceleration * scaling.counts);
    match language {
        Language::Rust => format!("State {{ position: {x:?}, velocity: {v:?}, acceleration: {a:?} }}"),
        Language::C => format!("{{{x:?}, {v:?}, {a:?}}}"),
    }
}

/// A name as programs have it.
fn identifier(name: &str) -> String {
    let known = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    let name: String = name.chars().map(known).collect();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("AXIS_{name}") }
}
