//! Kernels: closed forms of motion, generated from Maxima derivations and judged against them.
//!
//! Every kernel is a function of a family's module, and a module of the same name with its other shapes:
//!
//! ```
//! use closedform_kernels::turnaround::t_in;
//!
//! let seconds = t_in(0.002, 0.028, 2.0, 0.002);
//! assert!((seconds - 0.035_025_418_253_494_82).abs() < 1e-17);
//! assert!(t_in(0.002, 0.028, 2.0, 0.0).is_nan());
//! assert_eq!(t_in::INFO.inputs[3].maxima, "d2Step");
//! ```
//!
//! Nothing here allocates, panics or needs the standard library.

#![no_std]

#[rustfmt::skip]
mod generated;

pub use generated::*;
