//! Reports: what was measured, as a table, as JSON, and as text that replays a failure.

use std::fmt::Write as _;
use std::path::Path;

use serde::Serialize;

use super::super::eval::decimal;
use closedform_measure::accuracy::{Measurement, Worst, ulp_text};
use closedform_measure::catalogue::Entry;
use closedform_measure::search::Found;
use closedform_project::hexfloat;

/// Digits of expected values.
const DIGITS: u32 = 40;

/// What a replay must know besides the point.
pub struct Replay<'a> {
    /// Where the kernels were found.
    pub root: &'a Path,
    /// Where the random numbers started.
    pub seed: u64,
}

/// What was measured of one result.
#[derive(Debug, Serialize)]
pub struct Row {
    kernel: String,
    result: String,
    /// Points measured.
    points: usize,
    /// Points that the bound does not cover.
    beyond: usize,
    bound_ulp: Option<f64>,
    /// Whether the error is nowhere larger than the bound.
    holds: bool,
    seed: u64,
    /// Of a search: the worst error at the inputs that were kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    before_ulp: Option<f64>,
    worst: Option<WorstPoint>,
}

/// The worst point.
#[derive(Debug, Serialize)]
struct WorstPoint {
    /// `null` in JSON where it is infinite.
    ulp: f64,
    inputs: Vec<Coordinate>,
    got: f64,
    got_hex: String,
    expected: String,
    replay: String,
}

/// An input of the worst point.
#[derive(Debug, Serialize)]
struct Coordinate {
    name: String,
    value: f64,
    hex: String,
}

/// One row a result.
pub fn rows(entry: &Entry, measurement: &Measurement, replay: &Replay) -> Vec<Row> {
    let results = entry.kernel.meta.results.iter().zip(&measurement.worst);
    results
        .map(|(result, worst)| Row {
            kernel: entry.full_name(),
            result: result.name.to_string(),
            points: measurement.covered,
            beyond: measurement.beyond,
            bound_ulp: result.bound,
            holds: holds(worst.as_ref(), result.bound),
            seed: replay.seed,
            before_ulp: None,
            worst: worst.as_ref().map(|worst| WorstPoint::new(entry, worst, replay)),
        })
        .collect()
}

fn holds(worst: Option<&Worst>, bound: Option<f64>) -> bool {
    worst.zip(bound).is_none_or(|(worst, bound)| worst.ulp <= bound)
}

/// The table of all rows.
pub fn text(rows: &[Row], seed: u64) -> String {
    let header = ["kernel", "result", "points", "beyond", "kept", "worst ulp", "bound", "worst inputs"];
    let table = crate::columns::table(header, rows.iter().map(Row::cells));
    let mut text = format!("{table}\nseed {seed}\n");
    if rows.iter().any(|row| row.beyond > 0) {
        text += "beyond: points that bounds do not cover, because a result over- or underflows\n";
    }
    text
}

impl Row {
    /// One row a result of a search; `before` are the worst errors at the inputs that were kept.
    pub fn searched(entry: &Entry, before: &[Option<f64>], found: &Found, replay: &Replay) -> Vec<Self> {
        let results = entry.kernel.meta.results.iter().zip(&found.worst).zip(before);
        results
            .map(|((result, worst), before)| {
                let worst = worst.first();
                Row {
                    kernel: entry.full_name(),
                    result: result.name.to_string(),
                    points: found.looked as usize,
                    beyond: 0,
                    bound_ulp: result.bound,
                    holds: holds(worst, result.bound),
                    seed: replay.seed,
                    before_ulp: *before,
                    worst: worst.map(|worst| WorstPoint::new(entry, worst, replay)),
                }
            })
            .collect()
    }

    /// Whether the error is larger than the bound.
    pub fn exceeds(&self) -> bool {
        !self.holds
    }

    fn cells(&self) -> [String; 8] {
        let worst = self.worst.as_ref();
        [
            self.kernel.clone(),
            self.result.clone(),
            self.points.to_string(),
            self.beyond.to_string(),
            self.before_ulp.map_or_else(String::new, ulp_text),
            worst.map_or_else(String::new, |worst| ulp_text(worst.ulp)),
            self.bound_ulp.map_or_else(|| "none".to_owned(), |bound| bound.to_string()),
            worst.map_or_else(String::new, |worst| worst.inputs_text("\n")),
        ]
    }

    /// Everything about a bound that does not hold.
    pub fn failure(&self) -> String {
        let mut text = format!("`{}`: the error of `{}` exceeds its bound\n", self.kernel, self.result);
        if let Some(worst) = &self.worst {
            let _ = writeln!(text, "  {}", worst.inputs_text("\n  "));
            let _ = writeln!(text, "  expected  {}", worst.expected);
            let _ = writeln!(text, "  actual    {:?} ({})", worst.got, worst.got_hex);
            let bound = self.bound_ulp.unwrap_or(f64::INFINITY);
            let _ = writeln!(text, "  error     {} ulp, bound {bound}, seed {}", ulp_text(worst.ulp), self.seed);
            let _ = writeln!(text, "  replay    {}", worst.replay);
        }
        text
    }
}

impl WorstPoint {
    fn new(entry: &Entry, worst: &Worst, replay: &Replay) -> Self {
        let inputs = entry.kernel.inputs.iter().zip(&worst.inputs);
        let inputs: Vec<Coordinate> = inputs
            .map(|(input, value)| Coordinate {
                name: input.name.to_string(),
                value: *value,
                hex: hexfloat::print(*value),
            })
            .collect();
        Self {
            ulp: worst.ulp,
            got: worst.got,
            got_hex: hexfloat::print(worst.got),
            expected: decimal(&worst.expected, DIGITS),
            replay: command(entry, &inputs, replay),
            inputs,
        }
    }

    fn inputs_text(&self, separator: &str) -> String {
        let inputs = self.inputs.iter().map(|input| format!("{} = {:?} ({})", input.name, input.value, input.hex));
        inputs.collect::<Vec<_>>().join(separator)
    }
}

/// The command that evaluates the kernel there.
fn command(entry: &Entry, inputs: &[Coordinate], replay: &Replay) -> String {
    let here = replay.root == Path::new(".") || replay.root.as_os_str().is_empty();
    let root = if here { String::new() } else { format!("--root {} ", replay.root.display()) };
    let inputs: Vec<String> = inputs.iter().map(|input| format!("{}={}", input.name, input.hex)).collect();
    format!("closedform {root}eval {} {} --digits {DIGITS}", entry.full_name(), inputs.join(" "))
}
