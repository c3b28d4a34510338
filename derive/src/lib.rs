//! The macro `#[kernel]`: one straight-line function in all its arithmetics and shapes.
//!
//! Read from here: `closedform_syntax::parse` reads and checks, `expand` assembles what is emitted, and what parse
//! refuses becomes its errors beside a stand-in (`fallback`), so that callers of the function stay quiet.

mod batch;
mod documentation;
mod example;
mod expand;
mod fallback;
mod info;
mod mathml;
mod named;
mod parts;
mod program;
mod record;
mod table;

use proc_macro2::TokenStream;
use syn::ItemFn;

/// Makes a straight-line function a kernel.
///
/// ```
/// use closedform::kernel;
///
/// /// Leg of a right triangle.
/// #[kernel(family = "triangle", result(unit = "m"))]
/// pub fn leg(
///     #[input(unit = "m", typical(1.0, 10.0))] hypotenuse: f64,
///     #[input(unit = "m", typical(1.0, 10.0))] other: f64,
/// ) -> f64 {
///     require!(other > 0.0 && hypotenuse >= other, "hypotenuse >= other > 0");
///     let square = compensated!(hypotenuse * hypotenuse - other * other);
///     sqrt(square)
/// }
///
/// assert_eq!(leg(5.0, 3.0), 4.0);
/// assert_eq!(leg::checked(3.0, 5.0).unwrap_err().condition(), Some("hypotenuse >= other > 0"));
/// assert_eq!(leg::INFO.operations.compensated, 3);
/// ```
///
/// # The function
///
/// - inputs are `f64`, one to sixty-four; `#[input(maxima = "..", unit = "..", typical(low, high))]` describes one, and so
///   does documentation above it, `/// What it is`. It
///   returns `f64`, or a struct of `f64` declared beside it in a module (not inside a function).
/// - statements: `require!(condition)` or `require!(condition, "text")` first, on inputs alone; then `let name = e;`;
///   last the result: an expression, or a struct literal. Every input must be finite, without saying so.
/// - expressions: float literals, names, `+ - * /`, unary `-`, `sqrt(e)`, `abs(e)`, `cbrt(e)`, `max(e, ..)`, `min(e, ..)`, `PI`,
///   `if condition { e } else { e }`, `compensated!(e)`, `residual!(e)`,
///   `positive_root([c0, c1, ..])`.
/// - `compensated!(e)` takes `+ - *`, unary `-`, literals and names: right to all digits of its operands.
/// - `positive_root([c0, .., cn])` is the one positive root of c0 + c1 x + .. + cn x^n.
///
/// # The attribute
///
/// All keys are optional: `family`, `maxima`, `latex`, `source` are texts; `rules("..", "..")` names rewrites; `bound = 4`
/// states an error in ulp; `result(worksheet = "..", unit = "..")` describes the result. For a struct write
/// `bound(field = 4)` and `results(field(worksheet = "..", unit = ".."))`. With `precision = "double-double"` every shape
/// is computed as `faithful` is, and only rounded at the end. `example(path = "family::name", inputs(..), results(..))` gives
/// the documentation an example, which `cargo test` runs: the path leads from the crate's root to the kernel.
///
/// Nobody writes a bound by hand: `closedform bound FILE.rs --write` proves it and enters it with `certificate = ".."`, a
/// hash of the kernel and of the version of the rules. A bound whose certificate is missing, or was issued for another
/// text, does not compile. The hash is no secret: it guards against bounds that are made up or left behind by a change.
///
/// # What it becomes
///
/// The function itself, NaN outside its domain, and a module of the same name: `checked`, `faithful`, `fast`, `with_bound`,
/// `batch`, `fast_batch`, `f32`, `evaluate` in any arithmetic, `INFO` and `KERNEL`. The same calls by name are methods of
/// the module's `Inputs`, `leg::Inputs { hypotenuse, other }.call()`, and of its `Columns`, which holds a slice an input;
/// `rows` and `fast_rows` take a slice of `Inputs`. Documentation shows what `latex` says as mathematics. Steps may over- and underflow, results
/// may not: where `f64` cannot hold one, the function returns an infinity or what is left of its digits, and `checked` an
/// error. Where a formula has no value, since it divides by zero or takes the root of a negative number, the function
/// returns NaN.
///
/// The function is off by no more than its bound where it states one, and `faithful` by less than one ulp. Without a
/// bound neither promises anything: `faithful` computes the same steps in double-double, which keeps most digits of
/// most formulas, but nothing shows that it keeps those of this one.
///
/// # Limits
///
/// Brackets, prefix operators and `if`s may be nested 256 deep, and 1024 operators may follow each other in a row; 1024 `let`s
/// are the most.
#[proc_macro_attribute]
pub fn kernel(attribute: proc_macro::TokenStream, item: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expansion(attribute.into(), item.into()).into()
}

/// Makes a struct of `f64` a [`Record`](https://docs.rs/closedform/latest/closedform/trait.Record.html): numbers with names, in
/// order. Structs that kernels return need it where the feature `serde` of `closedform` is to serialise them.
#[proc_macro_derive(Record)]
pub fn record(item: proc_macro::TokenStream) -> proc_macro::TokenStream {
    record::derived(item.into()).into()
}

fn expansion(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let tokens = [attribute.clone(), item.clone()].into_iter().collect();
    if let Err(error) = closedform_syntax::check_limits(tokens) {
        return fallback::deep(&error, item);
    }
    let function: ItemFn = match syn::parse2(item.clone()) {
        Ok(function) => function,
        Err(error) => {
            let error = error.into_compile_error();
            return quote::quote!(#error #item);
        }
    };
    match closedform_syntax::parse(attribute, function.clone()) {
        Ok(kernel) => {
            let uncertified = closedform_syntax::certified(&kernel).err().map(syn::Error::into_compile_error);
            let expanded = expand::kernel(&kernel);
            quote::quote!(#uncertified #expanded)
        }
        Err(error) => fallback::function(&error, function),
    }
}
