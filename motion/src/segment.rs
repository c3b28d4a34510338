//! A segment: a stretch of one axis along one polynomial, as the player on a controller has it.

pub use closedform_player::{Sample, Segment, State};
