//! The catalogue of messages, and the collector that lets one run report them all.

use closedform_arith::Function;
use quote::ToTokens;
use syn::Result;

pub const ATTRIBUTE: &str = "unknown key; `#[kernel(..)]` knows family, maxima, latex, source, rules, precision, \
                             bound, certificate, result, results and example";
pub const ATTRIBUTE_TWICE: &str = "this key is written twice; keep one";
pub const TEXT: &str = "write this key as `key = \"text\"`";
pub const PRECISION: &str = "write the precision as `precision = \"double\"`, which is meant without it, `\"double-double\"` or `\"certified\"`";
pub const RULES: &str = "write the rules as `rules(\"one\", \"another\")`";
pub const BOUND: &str =
    "write the bound as `bound = 4`, or for a struct `bound(field = 4, other = 6)`: ulp, not below zero";
pub const UNCERTIFIED: &str = "this bound carries no certificate: run `closedform bound FILE.rs --write`, which proves \
                               bounds and enters them with their certificates, or state none";
pub const CERTIFICATE: &str = "no certificate: remove it and run `closedform bound FILE.rs --write`, which proves bounds and \
                               enters them with their certificates";
pub const CERTIFICATE_STALE: &str = "the kernel has changed since its bound was proved: run `closedform bound FILE.rs \
                                     --write`, or remove bound and certificate";
pub const CERTIFICATE_RULES: &str = "this bound was proved by the rules of another version: run `closedform bound FILE.rs \
                                     --write`, or remove bound and certificate";
pub const CERTIFICATE_ALONE: &str = "a certificate of no bound: remove it, or run `closedform bound FILE.rs --write`, which \
                                     enters both";
pub const RESULT: &str = "write a result as `result(worksheet = \"..\", unit = \"..\")`";
pub const RESULTS: &str = "write the results as `results(field(worksheet = \"..\", unit = \"..\"), other(..))`";
pub const EXAMPLE: &str = "write an example as `example(path = \"family::name\", inputs(1.0, 2.0), results(3.0))`: float \
                           literals, and no results where none are known";
pub const EXAMPLE_PATH: &str = "write the path from the crate's root to the kernel, as in `path = \"family::name\"`";
pub const EXAMPLE_INPUTS: &str = "an example has one number for each input of the kernel";
pub const EXAMPLE_RESULTS: &str = "an example has one number for each result of the kernel, in order, or no results";
pub const FIELD_META_OF_NUMBER: &str =
    "this kernel returns a number, not a struct: write `result(..)` and `bound = ..`";
pub const NUMBER_META_OF_STRUCT: &str = "this kernel returns a struct: name the field, as in `results(field(..))` and \
                                         `bound(field = ..)`";
pub const UNKNOWN_FIELD: &str = "the returned struct literal has no such field";

pub const SIGNATURE: &str = "a kernel is a plain function: remove this";
pub const NO_INPUTS: &str = "a kernel needs at least one input, as in `x: f64`";
pub const TOO_MANY_INPUTS: &str = "a kernel takes at most 64 inputs; split it";
pub const INPUT_TYPE: &str = "inputs are `f64`, by value; single precision and batches come with the kernel";
pub const INPUT_PATTERN: &str = "an input is a plain name, as in `x: f64`";
pub const INPUT_ATTRIBUTE: &str = "write `#[input(maxima = \"..\", unit = \"..\", typical(low, high))]`; no other attribute \
                                   is allowed here, besides documentation";
pub const TYPICAL: &str = "write `typical(low, high)` with two float literals, 0.0 <= low <= high";
pub const RETURN_TYPE: &str = "a kernel returns `f64` or a struct of `f64` declared beside it: write `-> f64`";

pub const NAME_CASE: &str = "write the name in snake_case, beginning with a small letter";
pub const NAME_TAKEN: &str = "this name is taken: every input and every `let` has a name of its own";
pub const NAME_RESERVED: &str = "this name belongs to the kernel language; choose another";
pub const UNKNOWN_NAME: &str = "unknown name: only inputs, earlier `let`s and `PI` can be used";

pub const STATEMENT: &str = "not a statement of the kernel language: write `require!(..);`, `let name = ..;`, and the \
                             result last";
pub const LET: &str = "write `let name = expression;`: no type, no `mut`, no pattern, no `else`";
pub const LATE_REQUIRE: &str = "`require!` comes first, before every `let`; its condition may only use inputs";
pub const REQUIRE: &str = "write `require!(condition)` or `require!(condition, \"text\")`";
pub const NO_RESULT: &str = "a kernel ends with its result: an expression without a semicolon, or a struct literal";
pub const RESULT_SHAPE: &str = "the returned expression must be of the returned type: an expression for `-> f64`, \
                                `Name { field: .. }` for `-> Name`";
pub const FIELD: &str = "write a field as `field: expression`, or `field` for the name itself";
pub const FIELD_TWICE: &str = "this field is given twice; keep one";
pub const NO_FIELDS: &str = "the struct needs at least one field";
pub const REST: &str = "name every field; `..` is not part of the kernel language";

pub const NESTING: &str = "nested deeper than 256 levels: move a part of it to a `let`";
pub const HEIGHT: &str = "more than 1024 operators in a row: move a part of them to a `let`";

pub const STEPS: &str = "this is the 1025th `let`, one too many: make a part of them a kernel of its own";

pub const CHAINED: &str = "a comparison compares two numbers: write `require!(0.0 < a && a < 1.0)` for `0.0 < a < 1.0`, and \
                           `require!(a > 0.0)` for `a > 0.0 == true`";
pub const CONDITION: &str = "not a condition: compare expressions with < <= > >= == !=, and join with && || !";
pub const CONDITION_AS_VALUE: &str = "a condition has no value here; use it in `require!(..)` or `if .. { } else { }`";
pub const INTEGER: &str = "kernels compute in floats: write this number with a decimal point, as in 2.0";
pub const SUFFIX: &str = "write float literals without a suffix";
pub const HUGE: &str = "this literal is beyond the range of f64";
pub const LITERAL: &str = "only float literals are part of the kernel language";
pub const OPERATOR: &str = "not an operator of the kernel language: use + - * / and unary -";
pub const BANG: &str = "this is a macro: write an exclamation mark before the parenthesis";
pub const ONE_ARGUMENT: &str = "this function takes one argument";
pub const TWO_ARGUMENTS: &str = "this function takes two arguments or more";
pub const POWER: &str = "powers are not part of the kernel language: write the product out, as in x * x, or sqrt(x)";
pub const CAST: &str = "everything is f64: remove the cast";
pub const REFERENCE: &str = "values are plain f64: remove the reference";
pub const LOOP: &str = "a kernel is straight-line code: no loops";
pub const MATCH: &str = "write `if condition { e } else { e }` in place of `match`";
pub const RETURN: &str = "a kernel returns its last expression: no `return`";
pub const MACRO: &str = "unknown macro: kernels know require!(..), compensated!(..) and residual!(..)";
pub const EXPRESSION: &str = "not an expression of the kernel language";
pub const IF_ELSE: &str = "`if` is an expression here: add `else { e }`";
pub const BRANCH: &str = "a branch holds one expression; move `let`s before the `if`";
pub const COMPENSATED_DIVISION: &str =
    "a compensated expression cannot divide: divide outside, as in compensated!(a) / compensated!(b)";
pub const COMPENSATED: &str =
    "a compensated expression takes only + - *, unary -, literals and names: compute this in a `let` first";
pub const RESIDUAL_DECIDES: &str = "the sign of a residual! may be wrong where it cancels: write compensated!(..)";
pub const COMPENSATED_SIZE: &str = "this compensated expression is too large: multiplied out, it may have 16384 terms of 16 factors each, \
                                    and 255 names and literals; move a part of it to a `let`";
pub const ROOT: &str = "write positive_root([c0, c1, ..]) with 2 to 33 coefficients, lowest power first";

pub const UNREADABLE: &str = "this function cannot be read as a kernel";

/// Of a call of a function that is not there.
pub fn unknown_call() -> String {
    format!(
        "unknown function: kernels know {}, max(e, ..), min(e, ..), compensated!(e), residual!(e) and positive_root([..])",
        calls()
    )
}

/// Of a method.
pub fn method() -> String {
    format!("methods are not part of the kernel language: write {}, max(e, e), or plain + - * /", calls())
}

/// The functions of the table, as they are called.
fn calls() -> String {
    Function::ALL.map(|function| format!("{}(e)", function.name())).join(", ")
}

/// Errors found so far.
#[derive(Default)]
pub struct Errors(Option<syn::Error>);

impl Errors {
    /// Adds `message` at `tokens`.
    pub fn push(&mut self, tokens: impl ToTokens, message: &str) {
        self.add(syn::Error::new_spanned(tokens, message));
    }

    /// Adds an error that has its place already.
    pub fn add(&mut self, error: syn::Error) {
        match &mut self.0 {
            Some(all) => all.combine(error),
            None => self.0 = Some(error),
        }
    }

    /// The value, or `None` with its error added.
    pub fn take<T>(&mut self, result: Result<T>) -> Option<T> {
        result.map_err(|error| self.add(error)).ok()
    }

    /// Fails if anything was found.
    pub fn finish(self) -> Result<()> {
        self.0.map_or(Ok(()), Err)
    }
}
