//! The law of units: other base units change results by the powers of their dimensions, bit for bit.

use closedform::{Info, Kernel};
use closedform_syntax::{BASES, Dimension};

use crate::inputs::Points;

/// Units that a point is given in instead of its own: the powers of two that the base dimensions are multiplied by.
pub(crate) type Scale = [i32; BASES];

/// Scales of length and time, and of every other base dimension.
const SCALES: [Scale; 10] = [
    [1, 0, 0, 0, 0, 0, 0],
    [-7, 0, 0, 0, 0, 0, 0],
    [0, 0, 1, 0, 0, 0, 0],
    [0, 0, -5, 0, 0, 0, 0],
    [3, 0, 2, 0, 0, 0, 0],
    [0, 1, 0, 0, 0, 0, 0],
    [0, 0, 0, -3, 0, 0, 0],
    [0, 0, 0, 0, 2, 0, 0],
    [0, 0, 0, 0, 0, -1, 0],
    [0, 0, 0, 0, 0, 0, 5],
];

/// What a number of this dimension is multiplied by. A half power of a scale that is odd is none of two.
pub(crate) fn factor(dimension: &Dimension, scale: &Scale) -> f64 {
    let halves: i32 = dimension.halves.iter().zip(scale).map(|(power, scale)| power * scale).sum();
    2.0_f64.powi(halves / 2)
}

/// The scale of which all these dimensions have whole powers: twice as large where one has a half power.
pub(crate) fn whole(scale: Scale, dimensions: &[Dimension]) -> Scale {
    let odd = |power: &i32| power % 2 != 0;
    let has_half = dimensions.iter().any(|dimension| dimension.halves.iter().any(odd));
    if has_half { scale.map(|power| 2 * power) } else { scale }
}

/// Demands that base dimensions scaled by powers of two scale the results, bit for bit.
///
/// # Errors
///
/// A unit that is none, or the first point where they do not.
pub fn check_scaling(kernel: &Kernel, points: &Points) -> Result<(), String> {
    let info = kernel.info;
    let inputs = dimensions(info, info.inputs.iter().map(|input| input.unit))?;
    let results = dimensions(info, info.results.iter().map(|result| result.unit))?;
    let all: Vec<Dimension> = inputs.iter().chain(&results).copied().collect();
    let scales = SCALES.map(|scale| whole(scale, &all));
    let used =
        |scale: &&Scale| all.iter().any(|dimension| dimension.halves.iter().zip(*scale).any(|(p, s)| p * s != 0));
    for point in &points.list {
        let original = values(kernel, point);
        for scale in scales.iter().filter(used) {
            let by = |dimensions: &[Dimension], values: &[f64]| -> Vec<f64> {
                dimensions.iter().zip(values).map(|(dimension, value)| value * factor(dimension, scale)).collect()
            };
            let (moved, expected) = (by(&inputs, point), by(&results, &original));
            // in units so large or small that a number loses digits, nothing scales
            let kept = |numbers: &[f64]| numbers.iter().all(|number| *number == 0.0 || number.is_normal());
            if ![point, &moved, &original, &expected].into_iter().all(|numbers| kept(numbers)) {
                continue;
            }
            let found = values(kernel, &moved);
            if found != expected {
                let what = format!("base units times two to the powers {scale:?}: {found:?}, not {expected:?}");
                return Err(format!("{}({point:?}), {what} ({})", info.name, points.origin));
            }
        }
    }
    Ok(())
}

pub(crate) fn dimensions<'a>(info: &Info, units: impl Iterator<Item = &'a str>) -> Result<Vec<Dimension>, String> {
    let parse = |unit: &str| Dimension::of_unit(unit).map_err(|error| format!("{}: unit `{unit}`: {error}", info.name));
    units.map(parse).collect()
}

fn values(kernel: &Kernel, inputs: &[f64]) -> Vec<f64> {
    let mut results = vec![0.0; kernel.info.results.len()];
    kernel.eval(inputs, &mut results).expect("as many inputs and results as the kernel has");
    results
}

#[cfg(test)]
mod tests {
    use super::{Dimension, factor, whole};

    #[test]
    fn numbers_scale_by_the_powers_of_their_dimension() {
        let unit = |text: &str| Dimension::of_unit(text).expect(text);
        let scale = [3, 1, -2, 0, 0, 0, 0];
        for (text, power) in [("m", 3), ("m/s^2", 7), ("N", 8), ("1", 0), ("deg", 0), ("1/s", 2)] {
            assert_eq!(factor(&unit(text), &scale), 2.0_f64.powi(power), "{text}");
        }
        let root = unit("m^(1/2)");
        assert_eq!(factor(&root, &whole(scale, &[root])), 8.0);
        assert_eq!(whole(scale, &[unit("m")]), scale);
    }
}
