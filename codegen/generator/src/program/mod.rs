//! Programs: straight-line computations as a graph of steps, with what is known of each step's sign and error.

mod constant;
mod cost;
mod graph;
mod naming;
mod op;
mod reach;

pub use constant::{beyond_literals, is_exact, is_power_of_two, leading_bits};
pub use cost::{Cost, cost};
pub use graph::Graph;
pub use naming::{Let, Program, name_steps};
pub use op::{CompensatedExpr, Condition, Node, Op};
pub use reach::{reached, rules_reached};
