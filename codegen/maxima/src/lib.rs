//! The Maxima language: parse with spans, print, evaluate in MPFR and in doubles.
//!
//! ```
//! use closedform_maxima::{parse_expression, print, to_latex};
//!
//! let speed = parse_expression("sqrt(v0^2 + 2*a2Max*d)").unwrap();
//! assert_eq!(print(&speed), "sqrt(v0^2+2*a2Max*d)");
//! assert_eq!(to_latex(&speed), r"\sqrt{v_{0}^{2}+2\,a_{2,\mathrm{Max}}\,d}");
//! ```
//!
//! Binding powers are Maxima's own (5.46), so `-a^2` is `-(a^2)` and `a+b:c` is `a+(b:c)`.

pub mod ast;
mod definition;
mod double;
mod double_rust;
mod error;
#[cfg(feature = "mpfr")]
pub mod evaluate;
pub mod exact;
mod grammar;
mod latex;
mod lex;
mod mention;
mod operator;
mod parse;
mod print;
mod token;

pub use ast::{BinaryOperator, Expr, ExprKind, Statement, Terminator, UnaryOperator};
pub use closedform_arith::Relation;
pub use definition::{Definition, Worksheet, defined_twice, definition, definitions, readable_worksheet, worksheet};
pub use double::{DoubleOperations, double_operations, evaluate_double};
pub use double_rust::double_rust;
pub use error::{DIGIT_LIMIT, Error, Errors};
#[cfg(feature = "mpfr")]
pub use evaluate::{EvalError, evaluate, evaluate_stable};
pub use latex::to_latex;
pub use mention::{Mention, mentions};
pub use operator::declares_operator;
pub use parse::{HEIGHT_LIMIT, NESTING_LIMIT, parse_expression, parse_statements, parse_what_can_be};
pub use print::{print, print_statement};
