//! The law of units: other units of length and time change results by their powers, bit for bit.

use closedform::{Info, Kernel};

use crate::inputs::Points;

/// Powers of length and time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// The power of the metre.
    pub length: i32,
    /// The power of the second.
    pub time: i32,
}

impl Dimension {
    /// The dimension of a unit such as `m/s^2`, `s` or `1`.
    pub fn parse(unit: &str) -> Option<Self> {
        let mut dimension = Dimension { length: 0, time: 0 };
        for (position, part) in unit.split('/').enumerate() {
            let sign = if position == 0 { 1 } else { -1 };
            for factor in part.split('*') {
                let (base, power) = factor.split_once('^').unwrap_or((factor, "1"));
                let power = sign * power.parse::<i32>().ok()?;
                match base {
                    "m" | "mm" => dimension.length += power,
                    "s" => dimension.time += power,
                    "1" => {}
                    _ => return None,
                }
            }
        }
        Some(dimension)
    }

    /// What a number of this dimension is multiplied by when lengths are by 2^length and times by 2^time.
    pub(crate) fn factor(self, length: i32, time: i32) -> f64 {
        2.0_f64.powi(self.length * length + self.time * time)
    }
}

/// Demands that lengths and times scaled by powers of two scale the results, bit for bit.
///
/// # Errors
///
/// A unit that is none, or the first point where they do not.
pub fn check_scaling(kernel: &Kernel, points: &Points) -> Result<(), String> {
    let info = kernel.info;
    let inputs = dimensions(info, info.inputs.iter().map(|input| input.unit))?;
    let results = dimensions(info, info.results.iter().map(|result| result.unit))?;
    for point in &points.list {
        for (length, time) in [(1, 0), (-7, 0), (0, 1), (0, -5), (3, 2)] {
            let by = |dimensions: &[Dimension], values: &[f64]| -> Vec<f64> {
                dimensions.iter().zip(values).map(|(dimension, value)| value * dimension.factor(length, time)).collect()
            };
            let found = values(kernel, &by(&inputs, point));
            let expected = by(&results, &values(kernel, point));
            if found != expected {
                let what = format!("lengths times 2^{length}, times times 2^{time}: {found:?}, not {expected:?}");
                return Err(format!("{}({point:?}), {what} ({})", info.name, points.origin));
            }
        }
    }
    Ok(())
}

pub(crate) fn dimensions<'a>(info: &Info, units: impl Iterator<Item = &'a str>) -> Result<Vec<Dimension>, String> {
    let parse = |unit: &str| Dimension::parse(unit).ok_or_else(|| format!("{}: unit `{unit}`", info.name));
    units.map(parse).collect()
}

fn values(kernel: &Kernel, inputs: &[f64]) -> Vec<f64> {
    let mut results = vec![0.0; kernel.info.results.len()];
    kernel.eval(inputs, &mut results).expect("as many inputs and results as the kernel has");
    results
}

#[cfg(test)]
mod tests {
    use super::Dimension;

    #[test]
    fn units_are_powers_of_length_and_time() {
        let units = [("m", 1, 0), ("m/s^2", 1, -2), ("s^2", 0, 2), ("1", 0, 0), ("1/s", 0, -1), ("s^3/m", -1, 3)];
        for (unit, length, time) in units {
            assert_eq!(Dimension::parse(unit), Some(Dimension { length, time }), "{unit}");
        }
        assert_eq!(Dimension::parse("kg"), None);
        assert_eq!(Dimension::parse(""), None);
    }
}
