//! Calls by name: structs of inputs, columns and rows have the bits of calls by position, whatever their fields are called.

use closedform::{LengthError, Record, kernel};

/// Leg of a right triangle.
///
/// By Pythagoras.
#[kernel(latex = "\\sqrt{c^{2}-a^{2}}", result(unit = "m"), example(path = "leg", inputs(5.0, 3.0), results(4.0)))]
pub fn leg(
    /// Length of the longest side.
    #[input(unit = "m")]
    hypotenuse: f64,
    #[input(maxima = "a", unit = "m")] other: f64,
) -> f64 {
    require!(other > 0.0 && hypotenuse >= other, "hypotenuse >= other > 0");
    sqrt(compensated!(hypotenuse * hypotenuse - other * other))
}

/// What `parts` returns.
#[derive(Clone, Copy, Debug, PartialEq, Record)]
pub struct Parts {
    sum: f64,
    r#type: f64,
}

/// Sum and quotient.
#[kernel]
pub fn parts(a: f64, b: f64) -> Parts {
    require!(b != 0.0);
    Parts { r#type: a / b, sum: a + b }
}

/// Another kernel may return the same struct.
#[kernel]
pub fn other_parts(a: f64) -> Parts {
    Parts { sum: a, r#type: -a }
}

/// Names that are keywords, or those of what stands beside them.
#[kernel]
#[allow(clippy::too_many_arguments)]
pub fn inputs(
    inputs: f64,
    call: f64,
    r#type: f64,
    checked: f64,
    batch: f64,
    rows: f64,
    results: f64,
    numbers: f64,
    f32: f64,
    columns: f64,
) -> f64 {
    inputs - 2.0 * call + 3.0 * r#type - 4.0 * checked + 5.0 * batch - 6.0 * rows + 7.0 * results - 8.0 * numbers
        + 9.0 * f32
        - 10.0 * columns
}

mod shapes {
    use closedform::kernel;

    /// Named like a shape.
    #[kernel]
    pub fn rows(x: f64) -> f64 {
        2.0 * x
    }

    /// A keyword.
    #[kernel]
    pub fn r#type(r#in: f64) -> f64 {
        3.0 * r#in
    }

    /// Named like a shape.
    #[kernel]
    pub fn batch(results: f64) -> f64 {
        4.0 * results
    }

    /// Named like a method.
    #[kernel]
    pub fn call(call: f64) -> f64 {
        5.0 * call
    }

    /// Left out.
    #[cfg(any())]
    #[kernel]
    pub fn absent(x: f64) -> f64 {
        x
    }
}

#[test]
fn a_call_by_name_is_the_call_by_position() {
    let inside = leg::Inputs { other: 3.0, hypotenuse: 5.0 };
    assert_eq!((inside.call(), inside.faithful(), inside.fast()), (4.0, 4.0, 4.0));
    assert_eq!(inside.checked(), Ok(4.0));
    assert_eq!(inside.with_bound(), leg::with_bound(5.0, 3.0));
    let outside = leg::Inputs { other: 6.0, ..inside };
    assert!(outside.call().is_nan());
    assert_eq!(outside.checked(), leg::checked(5.0, 6.0));
    assert_eq!(outside.checked().unwrap_err().condition(), Some("hypotenuse >= other > 0"));
    let results: parts::Results = parts::Inputs { a: 3.0, b: 2.0 }.call();
    assert_eq!(results, Parts { sum: 5.0, r#type: 1.5 });
}

#[test]
fn numbers_keep_the_order_of_the_inputs_and_names_lose_their_mark() {
    assert_eq!(leg::Inputs::from_numbers([5.0, 3.0]), leg::Inputs { hypotenuse: 5.0, other: 3.0 });
    assert_eq!(leg::Inputs { hypotenuse: 5.0, other: 3.0 }.numbers(), [5.0, 3.0]);
    assert_eq!((leg::Inputs::NAMES, Parts::NAMES), (&["hypotenuse", "other"], &["sum", "type"]));
    assert_eq!(Parts::from_numbers([1.0, 2.0]), Parts { sum: 1.0, r#type: 2.0 });
    assert_eq!((f64::from_numbers([2.0]), 2.0.numbers()), (2.0, [2.0]));
}

#[test]
fn columns_and_rows_are_single_calls() {
    let rows: Vec<parts::Inputs> = (0..1000).map(|i| parts::Inputs { a: f64::from(i), b: f64::from(i % 7) }).collect();
    let (a, b): (Vec<f64>, Vec<f64>) = rows.iter().map(|row| (row.a, row.b)).unzip();
    let bits = |parts: Parts| parts.numbers().map(f64::to_bits);
    let single: Vec<_> = rows.iter().map(|row| bits(parts(row.a, row.b))).collect();
    assert!(parts(rows[0].a, rows[0].b).sum.is_nan(), "rows outside the domain take part");

    let (mut sum, mut quotient) = (vec![0.0; 1000], vec![0.0; 1000]);
    let columns = parts::Columns { b: &b, a: &a };
    columns.batch(parts::ResultColumns { sum: &mut sum, r#type: &mut quotient }).unwrap();
    let by_columns: Vec<_> =
        sum.iter().zip(&quotient).map(|(sum, r#type)| bits(Parts { sum: *sum, r#type: *r#type })).collect();
    assert_eq!(by_columns, single);

    let mut results = vec![Parts { sum: 0.0, r#type: 0.0 }; 1000];
    for length in [0, 1, 31, 32, 33, 1000] {
        results.fill(Parts { sum: 0.0, r#type: 0.0 });
        parts::rows(&rows[..length], &mut results[..length]).unwrap();
        let by_rows: Vec<_> = results[..length].iter().map(|parts| bits(*parts)).collect();
        assert_eq!(by_rows, single[..length]);
    }
    let fast: Vec<f64> = rows.iter().map(|row| leg::fast(row.a, row.b)).collect();
    let legs: Vec<leg::Inputs> = rows.iter().map(|row| leg::Inputs::from_numbers(row.numbers())).collect();
    let (mut by_rows, mut by_columns) = (vec![0.0; 1000], vec![0.0; 1000]);
    leg::fast_rows(&legs, &mut by_rows).unwrap();
    leg::Columns { hypotenuse: &a, other: &b }.fast_batch(&mut by_columns).unwrap();
    let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    assert_eq!((bits(&by_rows), bits(&by_columns)), (bits(&fast), bits(&fast)));
}

#[test]
fn wrong_lengths_are_named_and_nothing_is_written() {
    let error = |name, expected, found| Err(LengthError { kernel: "leg", name, expected, found });
    let mut results = [7.0; 3];
    let row = leg::Inputs { hypotenuse: 5.0, other: 3.0 };
    assert_eq!(leg::rows(&[row; 2], &mut results), error("results", 2, 3));
    assert_eq!(leg::fast_rows(&[row; 4], &mut results), error("results", 4, 3));
    let columns = leg::Columns { hypotenuse: &[5.0; 3], other: &[3.0; 2] };
    assert_eq!(columns.batch(&mut results), error("other", 3, 2));
    assert_eq!(results, [7.0; 3]);
}

#[test]
fn names_do_not_clash() {
    let clashing = inputs::Inputs::from_numbers([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]);
    let expected = inputs(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0);
    assert_eq!((clashing.call(), clashing.checked()), (expected, Ok(expected)));
    assert_eq!((clashing.r#type, clashing.inputs, clashing.call), (3.0, 1.0, 2.0));
    let mut results = [0.0; 2];
    inputs::rows(&[clashing; 2], &mut results).unwrap();
    assert_eq!(results, [expected; 2]);
    assert_eq!(shapes::rows::Inputs { x: 2.0 }.call(), 4.0);
    assert_eq!(shapes::r#type::Inputs { r#in: 2.0 }.call(), 6.0);
    assert_eq!(shapes::batch::Inputs { results: 2.0 }.call(), 8.0);
    assert_eq!(shapes::call::Inputs { call: 2.0 }.call(), 10.0);
    shapes::rows::rows(&[shapes::rows::Inputs { x: 1.0 }; 2], &mut results).unwrap();
    assert_eq!(results, [2.0; 2]);
    shapes::batch::Columns { results: &[1.0, 2.0] }.batch(&mut results).unwrap();
    assert_eq!(results, [4.0, 8.0]);
    assert_eq!(other_parts::Inputs { a: 1.0 }.call(), Parts { sum: 1.0, r#type: -1.0 });
}

#[test]
fn a_kernel_inside_a_function_has_its_structs() {
    #[kernel]
    fn local(x: f64) -> f64 {
        2.0 * x
    }
    let mut results = [0.0];
    local::rows(&[local::Inputs { x: 3.0 }], &mut results).unwrap();
    assert_eq!((local::Inputs { x: 1.0 }.call(), results), (2.0, [6.0]));
}

#[test]
fn records_are_written_and_read_by_name() {
    let row = leg::Inputs { hypotenuse: 5.0, other: 0.1 };
    let text = serde_json::to_string(&row).unwrap();
    assert_eq!(text, r#"{"hypotenuse":5.0,"other":0.1}"#);
    assert_eq!(serde_json::from_str::<leg::Inputs>(&text).unwrap(), row);
    assert_eq!(serde_json::from_str::<leg::Inputs>(r#"{"other":0.1,"note":[1],"hypotenuse":5}"#).unwrap(), row);
    assert_eq!(serde_json::from_str::<leg::Inputs>("[5.0, 0.1]").unwrap(), row);
    let results = parts(3.0, 2.0);
    assert_eq!(serde_json::to_string(&results).unwrap(), r#"{"sum":5.0,"type":1.5}"#);
    for (wrong, message) in [
        (r#"{"hypotenuse":5.0}"#, "missing field `other`"),
        (r#"{"other":1.0,"other":1.0,"hypotenuse":5.0}"#, "duplicate field `other`"),
        ("[5.0]", "invalid length 1, expected 2 numbers, by name: hypotenuse other"),
        ("7", "invalid type: integer `7`, expected 2 numbers, by name: hypotenuse other"),
        (r#"{"hypotenuse":"long","other":1.0}"#, "invalid type: string \"long\", expected f64"),
    ] {
        let error = serde_json::from_str::<leg::Inputs>(wrong).unwrap_err().to_string();
        assert!(error.starts_with(message), "{wrong}: {error}");
    }
}
