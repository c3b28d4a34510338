//! Error bounds of kernels, derived from their Rust text alone and held against those they state.
//!
//! [`check`] takes a kernel as `closedform-syntax` reads it, shows for every sum that its terms have one sign on the
//! domain, or are exact, and counts roundings. It shares no code with the generator.
//!
//! **What is proved.** With u = 2^-53, a value of count k is the exact one times a factor between (1-u)^k and
//! (1-u)^-k, for all inputs of the domain: the runtime leaves what over- or underflows in `f64` to a finer arithmetic.
//! This is Stewart's and Higham's relative error counter, and it has no terms of higher order to neglect: a rounding adds
//! 1, products and quotients add the counts of their operands, a square root halves it, and a sum of terms of one sign has
//! the larger one. What remains is to read it as a relative error: it is at most k u/(1 - k u), k units for all that can
//! be printed. The number that a kernel states is that in ulp, of which k units are at most k.
//!
//! So is the domain decided: no comparison in a `require!` may be turned by rounding; nor may one in an `if`, unless its
//! two sides are shown to be the same real function. And so is every value defined: no divisor is zero on the domain,
//! nothing negative stands under a root, every `positive_root` is there.
//!
//! A proved bound is stated with a certificate ([`Keys`]), which the macro asks for: a hash of the kernel and of
//! [`closedform_syntax::RULES`]. Who changes a rule so that fewer bounds are proved raises that number.
//!
//! A kernel in double-double is counted alike: its steps add next to nothing, and rounding its result adds 1.
//!
//! **What is taken on trust.** The numbers in [`trusted`]: what the runtime promises of `compensated!`, `residual!`,
//! `positive_root` and steps in double-double, which its own tests judge.

mod assert;
mod case;
mod check;
mod correction;
mod count;
mod defined;
mod equal;
mod forms;
mod keys;
mod place;
mod polynomial;
mod proof;
mod refusal;
mod room;
mod sign;
mod stated;
mod text;
pub mod trusted;

pub use assert::assert_file_bounded;
pub use check::{Derived, ResultBound, check, check_text, derive};
pub use keys::Keys;
pub use place::{Place, place};
pub use polynomial::{Atom, Polynomial};
pub use proof::{BoundError, bound_proof, certified_bound_proof};
pub use refusal::{Reason, Refusal, TextError, Undefined};
pub use room::with_room;
pub use sign::{Facts, Sign};
pub use stated::{Edit, edited, enter, take_out, with_certificates};
