//! What is known of a kernel besides its code.

use closedform_arith::{Operations, Precision};

/// What is known of a kernel besides its code: where it comes from, what it takes and promises.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Info {
    /// `family::name`, or the name alone where no family is given.
    pub name: &'static str,
    /// The worksheet it belongs to; empty where none is given.
    pub family: &'static str,
    /// The first paragraph of its documentation.
    pub summary: &'static str,
    /// The closed form as Maxima text; empty where none is given.
    pub maxima: &'static str,
    /// The closed form as LaTeX; empty where none is given.
    pub latex: &'static str,
    /// Where the formula is derived; empty where no source is given.
    pub source: &'static str,
    /// The inputs, in order.
    pub inputs: &'static [Input],
    /// The conditions that inputs must meet, in order, besides that every input is finite.
    pub domain: &'static [&'static str],
    /// The results, in order.
    pub results: &'static [ResultInfo],
    /// The rewrites that keep its digits.
    pub rules: &'static [&'static str],
    /// What the function computes in.
    pub precision: Precision,
    /// What one evaluation costs, the check of the domain left out.
    pub operations: Operations,
    /// The k of: where every input is 0 or of a magnitude from 2^-k to 2^k, no step of a kernel in `f64` over- or
    /// underflows, and no product inside a compensated expression loses its error. Other inputs get results as good, but
    /// each step is looked at, which takes longer. 0 where no k is large enough, and where the function finds the root of
    /// a polynomial.
    pub ordinary: u32,
}

/// An input of a kernel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Its name in Rust.
    pub name: &'static str,
    /// Its name in the worksheet; that in Rust where none is given.
    pub maxima: &'static str,
    /// Its unit; empty where none is given.
    pub unit: &'static str,
    /// The range of magnitudes to expect, for samplers.
    pub typical: (f64, f64),
}

/// A result of a kernel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResultInfo {
    /// Its field in the returned struct, or the name of a kernel that returns a number.
    pub name: &'static str,
    /// The function of the worksheet that defines it; empty where none is given.
    pub worksheet: &'static str,
    /// Its unit; empty where none is given.
    pub unit: &'static str,
    /// The error in ulp that it never exceeds, where one is proved.
    pub bound_ulp: Option<f64>,
}
