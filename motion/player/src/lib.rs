//! Plays a planned move on a controller: what an axis does at a time, without allocation and without `std`.
//!
//! A plan is a slice of [`Segment`]s, and the times at which they start and the last one ends. On the machine that plans
//! them `closedform-motion` says both; on the controller they may be constants. The results have the same bits on both.
//!
//! ```
//! use closedform_player::{Player, Segment, State};
//!
//! // a step of 1 m in 2 s, with 1 m/s²
//! const MIDDLE: State = State { position: 0.5, velocity: 1.0, acceleration: 0.0 };
//! let segments = [
//!     Segment::between(State { acceleration: 1.0, ..State::rest(0.0) }, State { acceleration: 1.0, ..MIDDLE }, 1.0),
//!     Segment::between(State { acceleration: -1.0, ..MIDDLE }, State { acceleration: -1.0, ..State::rest(1.0) }, 1.0),
//! ];
//! let player = Player::new(&segments, &[0.0, 1.0, 2.0]).expect("one time more than segments");
//! assert_eq!(player.at(0.5).position, 0.125);
//! assert_eq!(player.at(9.0).position, 1.0);
//! ```

#![no_std]
#![forbid(unsafe_code)]

mod player;
mod segment;

pub use player::{Cursor, Player};
pub use segment::{Sample, Segment, State};
