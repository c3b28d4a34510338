//! Programs: straight-line computations as a graph of steps, with what is known of each step's sign and error.

mod cost;
mod graph;
mod naming;
mod reach;

pub use cost::{Cost, cost};
pub use graph::{Condition, Graph, Node, Op, Wide, beyond_literals, is_exact, is_power_of_two, leading_bits};
pub use naming::{Let, Program, name_steps};
pub use reach::{reached, rules_reached};
