//! What a path is made of: points that can be joined, and the time of each segment.

use closedform_kernels::waypoints;

use super::{FEWEST, Timing};
use crate::error::PlanError;
use crate::scale::{exponent, largest, scale};

/// How many coordinates the points have.
pub(super) fn dimension(points: &[Vec<f64>]) -> Result<usize, PlanError> {
    if points.len() < FEWEST {
        let remedy = "give at least four";
        return Err(PlanError::Input { name: "number of points", value: points.len() as f64, remedy });
    }
    let dimension = points[0].len();
    for (index, point) in points.iter().enumerate() {
        let item = |name, value, remedy| Err(PlanError::Item { item: "point", index, name, value, remedy });
        if !(1..=3).contains(&point.len()) {
            return item("number of coordinates", point.len() as f64, "give one, two or three");
        }
        if point.len() != dimension {
            return item("number of coordinates", point.len() as f64, "give all points as many as point 0");
        }
        if let Some(bad) = point.iter().find(|coordinate| !coordinate.is_finite()) {
            return item("a coordinate", *bad, "make all coordinates finite");
        }
    }
    Ok(dimension)
}

/// How long each segment takes.
pub(super) fn durations(points: &[Vec<f64>], timing: &Timing) -> Result<Vec<f64>, PlanError> {
    match timing {
        Timing::Speed(speed) => by_distance(points, *speed),
        Timing::Durations(durations) => given(points.len() - 1, durations),
    }
}

fn given(segments: usize, durations: &[f64]) -> Result<Vec<f64>, PlanError> {
    if durations.len() != segments {
        let remedy = "give one a segment, one fewer than points";
        return Err(PlanError::Input { name: "number of durations", value: durations.len() as f64, remedy });
    }
    match durations.iter().position(|time| !(*time > 0.0 && time.is_finite())) {
        None => Ok(durations.to_vec()),
        Some(index) => {
            let remedy = "make it positive and finite";
            Err(PlanError::Item { item: "segment", index, name: "duration", value: durations[index], remedy })
        }
    }
}

fn by_distance(points: &[Vec<f64>], speed: f64) -> Result<Vec<f64>, PlanError> {
    if !(speed > 0.0 && speed.is_finite()) {
        return Err(PlanError::Input { name: "speed", value: speed, remedy: "make it positive and finite" });
    }
    let duration = |(first, pair): (usize, &[Vec<f64>])| match distance_time(&pair[0], &pair[1], speed) {
        _ if pair[0] == pair[1] => {
            let (why, remedy) = ("are the same, so the way between them takes no time", "drop one, or give durations");
            Err(PlanError::Points { first, second: first + 1, why, remedy })
        }
        time if time > 0.0 && time.is_finite() => Ok(time),
        _ => Err(PlanError::Range { what: "the time between two waypoints" }),
    };
    points.windows(2).enumerate().map(duration).collect()
}

/// Distance by speed. Both go to the kernels near 1, so that no square overflows.
fn distance_time(from: &[f64], to: &[f64], speed: f64) -> f64 {
    let mut way = [0.0; 3];
    for (way, (from, to)) in way.iter_mut().zip(from.iter().zip(to)) {
        *way = to - from;
    }
    let most = largest(way);
    if !most.is_finite() {
        return f64::INFINITY;
    }
    let (far, fast) = (exponent(most), exponent(speed));
    let [x, y, z] = way.map(|way| scale(way, -far));
    let speed = scale(speed, -fast);
    let time = match from.len() {
        3 => waypoints::segment_3d(0.0, 0.0, 0.0, x, y, z, speed).time,
        _ => waypoints::segment_2d(0.0, 0.0, x, y, speed).time,
    };
    scale(time, far - fast)
}
