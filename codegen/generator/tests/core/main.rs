//! The core by itself: exact algebra, signs, towers, nesting, steps, names, text and proofs, with the small ring.

mod graphs;
mod naming;
mod nesting;
mod printing;
mod proofs;
mod ring;
mod signs;
mod towers;
mod values;
