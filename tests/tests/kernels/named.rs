//! Calls by name, columns and rows have the bits of calls by position.

use closedform::{CallError, Record};
use closedform_tests::budget::budget;
use closedform_tests::check::Judge;
use closedform_tests::harness::Said;
use closedform_tests::inputs::Maker;
use closedform_tests::random::seed;
use closedform_tests::shapes::same_bits;

/// What the structs of a kernel give: numbers in order, or what is said in their place.
struct Named {
    kernel: &'static str,
    /// `call`, `checked`, `faithful`, `fast`, and both parts of `with_bound`.
    single: fn(&[f64]) -> [Answer; 6],
    /// `rows` and `fast_rows`, a list a point.
    rows: fn(&[Point]) -> [Vec<Numbers>; 2],
    /// `batch` and `fast_batch` of columns, a list a result.
    columns: fn(&[Column]) -> [Vec<Column>; 2],
}

type Point = Vec<f64>;
type Numbers = Vec<f64>;
type Column = Vec<f64>;
type Answer = Result<Vec<f64>, String>;

fn numbers<R: Record<N>, const N: usize>(record: R) -> Answer {
    Ok(record.numbers().to_vec())
}

/// All kernels, each as `family::kernel [inputs] [fields of the returned struct]`.
macro_rules! kernels {
    ($($family:ident :: $kernel:ident [$($input:ident)*] $results:tt)*) => {
        const KERNELS: &[Named] = &[$({
            use closedform_kernels::$family::$kernel as kernel;
            Named {
                kernel: concat!(stringify!($family), "::", stringify!($kernel)),
                single: |inputs| {
                    let &[$($input),*] = inputs else { panic!("{}", inputs.len()) };
                    let inputs = kernel::Inputs { $($input),* };
                    let (values, errors) = inputs.with_bound();
                    let checked = match inputs.checked() {
                        Ok(results) => numbers(results),
                        Err(error) => Err(format!("{:?}", CallError::from(error))),
                    };
                    let [call, faithful, fast, values, errors] =
                        [inputs.call(), inputs.faithful(), inputs.fast(), values, errors].map(numbers);
                    [call, checked, faithful, fast, values, errors]
                },
                rows: |points| {
                    let row = |point: &Vec<f64>| {
                        let &[$($input),*] = &point[..] else { panic!("{}", point.len()) };
                        kernel::Inputs { $($input),* }
                    };
                    let rows: Vec<kernel::Inputs> = points.iter().map(row).collect();
                    [kernel::rows, kernel::fast_rows].map(|shape| {
                        let mut results = vec![rows[0].call(); rows.len()];
                        shape(&rows, &mut results).expect("slices of one length");
                        results.into_iter().map(|results| results.numbers().to_vec()).collect()
                    })
                },
                columns: |columns| {
                    let [$($input),*] = columns else { panic!("{}", columns.len()) };
                    let columns = kernel::Columns { $($input),* };
                    let length = [$($input.len()),*][0];
                    [kernel::Columns::batch, kernel::Columns::fast_batch]
                        .map(|shape| room!(length, $results, |results| shape(columns, results)))
                },
            }
        }),*];
    };
}

/// What a batch writes into room for its results, a slice for each.
macro_rules! room {
    ($length:expr, [], |$results:ident| $batch:expr) => {{
        let mut results = vec![0.0; $length];
        let $results = &mut results[..];
        $batch.expect("slices of one length");
        vec![results]
    }};
    ($length:expr, [$($field:ident)*], |$results:ident| $batch:expr) => {{
        let mut results = [$(vec![0.0; { _ = stringify!($field); $length }]),*];
        let [$($field),*] = &mut results;
        let $results = kernel::ResultColumns { $($field),* };
        $batch.expect("slices of one length");
        results.to_vec()
    }};
}

include!(concat!(env!("OUT_DIR"), "/kernels.rs"));

/// Whatever is called by name is what is called by position.
pub fn named(judge: &Judge) -> Said {
    let info = judge.kernel.info;
    let named = KERNELS.iter().find(|named| named.kernel == info.name);
    let named = named.ok_or_else(|| format!("{}: not among the kernels that are called by name", info.name))?;
    let inside = Maker::ALL.map(|maker| judge.space.inside(maker, seed(), budget().laws).list);
    let points = [inside.concat(), judge.space.outside(seed(), budget().laws).list].concat();
    let mut expected = [Vec::new(), Vec::new()];
    for point in &points {
        let by_position = by_position(judge, point);
        for (place, (named, expected)) in (named.single)(point).iter().zip(&by_position).enumerate() {
            if !same(named, expected) {
                return Err(format!("{} at {point:?}, shape {place}: {named:?} by name, {expected:?}", info.name));
            }
        }
        let [default, _, _, fast, ..] = by_position;
        expected[0].extend(default);
        expected[1].extend(fast);
    }
    let columns: Vec<Vec<f64>> =
        (0..info.inputs.len()).map(|input| points.iter().map(|point| point[input]).collect()).collect();
    for ((rows, columns), expected) in (named.rows)(&points).iter().zip((named.columns)(&columns)).zip(&expected) {
        for (place, expected) in expected.iter().enumerate() {
            let column: Vec<f64> = columns.iter().map(|column| column[place]).collect();
            if !same_bits(&rows[place], expected) || !same_bits(&column, expected) {
                let (point, row) = (&points[place], &rows[place]);
                return Err(format!("{} at {point:?}: row {row:?}, column {column:?}, alone {expected:?}", info.name));
            }
        }
    }
    Ok(String::new())
}

fn by_position(judge: &Judge, point: &[f64]) -> [Answer; 6] {
    let kernel = judge.kernel;
    let mut lists = [(); 6].map(|()| vec![0.0; kernel.info.results.len()]);
    let [default, checked, faithful, fast, values, errors] = &mut lists;
    let fits = "as many inputs and results as the kernel has";
    kernel.eval(point, default).expect(fits);
    kernel.faithful(point, faithful).expect(fits);
    kernel.fast(point, fast).expect(fits);
    kernel.with_bound(point, values, errors).expect(fits);
    let refused = kernel.checked(point, checked).err();
    let mut answers = lists.map(Ok);
    if let Some(refused) = refused {
        answers[1] = Err(format!("{refused:?}"));
    }
    answers
}

fn same(left: &Answer, right: &Answer) -> bool {
    match (left, right) {
        (Ok(left), Ok(right)) => same_bits(left, right),
        (left, right) => left == right,
    }
}
