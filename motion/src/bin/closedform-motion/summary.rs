//! What a command prints: a short summary for people, or the same as JSON.

use closedform_motion::plot::with_unit;
use closedform_motion::{AxisPeaks, Motion, Peak};
use serde_json::{Map, Value, json};

/// Something worth telling.
pub struct Fact {
    name: &'static str,
    value: Value,
    unit: &'static str,
    /// Why it is so, for people.
    remark: String,
}

/// All that is told of a plan.
pub struct Summary {
    plan: &'static str,
    facts: Vec<Fact>,
    peaks: Vec<AxisPeaks>,
    parts: Vec<Parts>,
    files: Vec<Value>,
}

/// What they are times of, their names and times, and how many are told.
type Parts = (&'static str, Vec<(String, f64)>, usize);

impl Summary {
    /// Of a plan of this kind, as the command calls it.
    pub fn new(plan: &'static str) -> Self {
        Self { plan, facts: Vec::new(), peaks: Vec::new(), parts: Vec::new(), files: Vec::new() }
    }

    /// A number with its unit; a share has the unit `%` and is told as such.
    pub fn number(&mut self, name: &'static str, value: f64, unit: &'static str) -> &mut Self {
        self.facts.push(Fact { name, value: json!(value), unit, remark: String::new() });
        self
    }

    /// How many.
    pub fn count(&mut self, name: &'static str, value: u64) -> &mut Self {
        self.facts.push(Fact { name, value: json!(value), unit: "", remark: String::new() });
        self
    }

    /// Words.
    pub fn words(&mut self, name: &'static str, value: &str) -> &mut Self {
        self.facts.push(Fact { name, value: json!(value), unit: "", remark: String::new() });
        self
    }

    /// Times in s of parts that have names: for people those that take longest.
    pub fn parts(&mut self, name: &'static str, parts: Vec<(String, f64)>, most: usize) -> &mut Self {
        self.parts.push((name, parts, most));
        self
    }

    /// Explains the fact before.
    pub fn because(&mut self, remark: &str) -> &mut Self {
        if let Some(fact) = self.facts.last_mut() {
            remark.clone_into(&mut fact.remark);
        }
        self
    }

    /// The largest velocity, acceleration and jerk of each axis.
    pub fn peaks_of(&mut self, motion: &Motion) -> &mut Self {
        self.peaks = motion.peaks();
        self
    }

    /// A file that was written.
    pub fn file(&mut self, path: &std::path::Path, rows: Option<u64>) {
        self.files.push(json!({ "path": path.display().to_string(), "rows": rows }));
    }

    /// For people.
    pub fn text(&self) -> String {
        let facts = self.facts.iter().map(|fact| (fact.name.to_owned(), fact.text()));
        let peaks = self.peaks.iter().flat_map(|axis| {
            let named = |what: &str| format!("{what} of {}", axis.name);
            let jumps = axis.jump.size != 0.0;
            let jerk =
                peak_text(axis.jerk, "m/s³") + if jumps { "  (where the acceleration does not jump)" } else { "" };
            let jump = || format!("{} at {}", with_unit(axis.jump.size.abs(), "m/s²"), with_unit(axis.jump.time, "s"));
            [
                Some((named("velocity"), peak_text(axis.velocity, "m/s"))),
                Some((named("acceleration"), peak_text(axis.acceleration, "m/s²"))),
                jumps.then(|| (named("jump of acceleration"), jump())),
                Some((named("jerk"), jerk)),
            ]
            .into_iter()
            .flatten()
        });
        let written = self.files.iter().map(|file| {
            let rows = file["rows"].as_u64().map_or_else(String::new, |rows| format!(", {rows} rows"));
            ("written".to_owned(), format!("{}{rows}", file["path"].as_str().unwrap_or_default()))
        });
        let lines: Vec<(String, String)> = facts.chain(peaks).chain(written).collect();
        let widest = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
        let lines = lines.iter().map(|(name, text)| format!("{name:widest$}  {text}\n"));
        lines.chain(self.parts.iter().map(parts_text)).collect()
    }

    /// For programs: every number in its SI unit, `null` where there is no limit.
    pub fn json(&self) -> String {
        let facts: Map<String, Value> =
            self.facts.iter().map(|fact| (fact.name.replace([' ', '-'], "_"), fact.json())).collect();
        let peaks: Vec<Value> = self.peaks.iter().map(axis_json).collect();
        let mut facts = facts;
        for (name, parts, _) in &self.parts {
            let parts: Vec<Value> =
                parts.iter().map(|(name, time)| json!({ "name": name, "value": time, "unit": "s" })).collect();
            facts.insert(name.replace(' ', "_"), Value::Array(parts));
        }
        let all = json!({ "plan": self.plan, "facts": facts, "peaks": peaks, "files": self.files });
        format!("{all:#}\n")
    }
}

impl Fact {
    fn text(&self) -> String {
        let said = match (self.value.as_f64(), self.unit) {
            (Some(share), "%") => format!("{:.2} %", 100.0 * share),
            (Some(number), unit) if !unit.is_empty() => with_unit(number, unit),
            _ => self.value.as_str().map_or_else(|| self.value.to_string(), str::to_owned),
        };
        if self.remark.is_empty() { said } else { format!("{said}  ({})", self.remark) }
    }

    fn json(&self) -> Value {
        match self.unit {
            "" => self.value.clone(),
            "%" => json!({ "value": self.value, "unit": "1" }),
            unit => json!({ "value": self.value, "unit": unit }),
        }
    }
}

/// A heading, and a line for each part that takes long.
fn parts_text((name, parts, most): &Parts) -> String {
    let mut longest: Vec<&(String, f64)> = parts.iter().collect();
    longest.sort_by(|a, b| b.1.total_cmp(&a.1));
    let told = longest.iter().take(*most).map(|(name, time)| format!("  {:>10}  {name}\n", with_unit(*time, "s")));
    let rest = match parts.len().saturating_sub(*most) {
        0 => String::new(),
        rest => format!("  and {rest} more\n"),
    };
    format!("{name}\n{}{rest}", told.collect::<String>())
}

fn peak_text(peak: Peak, unit: &str) -> String {
    let value = with_unit(peak.at.value.abs(), unit);
    match peak.limit.is_finite() {
        true => format!("{value} of {}, {:.1} %", with_unit(peak.limit, unit), 100.0 * peak.share()),
        false => value,
    }
}

fn axis_json(axis: &AxisPeaks) -> Value {
    let peak = |peak: Peak, unit: &str| {
        let limit = peak.limit.is_finite().then_some(peak.limit);
        json!({ "value": peak.at.value, "time": peak.at.time, "limit": limit, "unit": unit })
    };
    json!({
        "axis": axis.name,
        "velocity": peak(axis.velocity, "m/s"),
        "acceleration": peak(axis.acceleration, "m/s^2"),
        "jerk": peak(axis.jerk, "m/s^3"),
        "acceleration_jump": { "value": axis.jump.size, "time": axis.jump.time, "unit": "m/s^2" },
    })
}
