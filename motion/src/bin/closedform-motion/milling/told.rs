//! What `milling` says of a job.

use closedform_motion::plan::milling::Milling;
use closedform_motion::plan::milling::gcode::Summary as Job;

use crate::summary::Summary;

/// Of features and tools so many are told, those that take longest.
const MOST: usize = 12;

/// All of it.
pub fn summary(job: &Job, milling: &Milling) -> Summary {
    let mut summary = Summary::new("milling");
    if let Some(dialect) = job.dialect {
        summary.words("dialect", dialect.name());
    }
    summary.words("model", milling.model().name()).because(model(milling));
    let share = if job.time > 0.0 { 1.0 - job.cutting_time / job.time } else { 0.0 };
    let remark = match job.notices {
        0 => clock(job.time),
        _ => format!("at least: {}", clock(job.time)),
    };
    summary
        .number("duration", job.time, "s")
        .because(&remark)
        .number("cutting", job.cutting_time, "s")
        .number("rapid", job.rapid_time, "s")
        .number("dwell", job.dwell_time, "s");
    events(&mut summary, job);
    summary
        .number("overhead share", share, "%")
        .because("of the duration, all that does not cut")
        .number("cutting length", job.cutting_length / 1000.0, "m")
        .number("rapid length", job.rapid_length / 1000.0, "m")
        .count("moves", job.moves)
        .count("lines", job.lines)
        .count("lines passed over", job.notices);
    if job.notices > 0 {
        summary.because("or of a time that nobody knows, which counts 0 s");
    }
    if job.tools.len() > 1 {
        let tools = job.tools.iter().map(|(tool, time)| (format!("tool {tool}"), *time)).collect();
        summary.parts("time of tools", tools, MOST);
    }
    if job.features.iter().any(|(name, _)| !name.is_empty()) {
        let named = |name: &String| if name.is_empty() { "without a name".to_owned() } else { name.clone() };
        let features = job.features.iter().map(|(name, time)| (named(name), *time)).collect();
        summary.parts("time of features", features, MOST);
    }
    summary
}

fn model(milling: &Milling) -> &'static str {
    use closedform_motion::plan::milling::Model;
    match milling.model() {
        Model::LookAhead(_) => "without a stop where the path allows it",
        Model::ExactStop => "rests at every point",
        Model::Steps { .. } => "rests at every point; up to 29 % too short",
    }
}

/// Tools and spindle.
fn events(summary: &mut Summary, job: &Job) {
    if job.tool_changes > 0 {
        summary.number("tool changes", job.tool_change_time, "s").because(&of(job.tool_changes, "tool-change"));
    }
    if job.spindle_starts > 0 {
        summary.number("spindle starts", job.spindle_time, "s").because(&of(job.spindle_starts, "spindle-start"));
    }
}

fn of(count: u64, flag: &str) -> String {
    format!("{count} of them; how long one takes says {flag}")
}

/// Hours, minutes and seconds.
fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    format!("{} h {:02} min {:02} s", whole / 3600, whole / 60 % 60, whole % 60)
}
