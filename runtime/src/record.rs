//! Records: structs of numbers with names, such as the inputs of a kernel, or its results.

/// A struct of `N` numbers, each with its name. `#[kernel]` makes one of the inputs of every kernel; `#[derive(Record)]`
/// makes one of a struct that kernels return.
///
/// ```
/// use closedform::Record;
///
/// #[derive(Clone, Copy, Debug, PartialEq, Record)]
/// struct Legs {
///     first: f64,
///     second: f64,
/// }
///
/// assert_eq!(Legs { first: 3.0, second: 4.0 }.numbers(), [3.0, 4.0]);
/// assert_eq!(Legs::from_numbers([3.0, 4.0]).second, 4.0);
/// assert_eq!(Legs::NAMES, &["first", "second"]);
/// ```
///
/// With the feature `serde` records are serialised and deserialised, by name.
pub trait Record<const N: usize>: Copy {
    /// The names, in order.
    const NAMES: &'static [&'static str; N];

    /// The record of these numbers, in order.
    fn from_numbers(numbers: [f64; N]) -> Self;

    /// The numbers, in order.
    fn numbers(self) -> [f64; N];
}

/// A kernel of one result returns the number itself.
impl Record<1> for f64 {
    const NAMES: &'static [&'static str; 1] = &["value"];

    fn from_numbers([value]: [f64; 1]) -> Self {
        value
    }

    fn numbers(self) -> [f64; 1] {
        [self]
    }
}
