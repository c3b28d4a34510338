//! The judges: what kernels are measured against, on which inputs, and how hard.
//!
//! Nothing here shares code with the generator: references are Maxima's own text evaluated in MPFR, golden values are
//! Maxima's own numbers, and domains are decided exactly. File formats, hexadecimal floats and the stream of random numbers
//! are the project's.

pub mod algebra;
pub mod as_written;
pub mod assembly;
pub mod bare;
pub mod bench;
pub mod bounds;
pub mod budget;
pub mod check;
pub mod claim;
pub mod climb;
pub mod complex;
pub mod contract;
pub mod coverage;
pub mod cycles;
pub mod domain;
pub mod errata;
pub mod failure;
pub mod fast;
pub mod golden;
pub mod harness;
pub mod inputs;
pub mod kept;
pub mod kernels;
pub mod laws;
pub mod layering;
pub mod links;
pub mod magnitudes;
pub mod parallel;
pub mod printing;
pub mod random;
pub mod rational;
pub mod reference;
pub mod scaling;
pub mod shapes;
pub mod strategy;
pub mod sweep;
pub mod tables;
pub mod tidy;
pub mod ulp;
pub mod worksheets;
pub mod workspace;
pub mod zeros;
