//! What a path is made of: points that can be joined, and the time of each segment.

use closedform_kernels::waypoints;

use super::{Problem, Waypoints};
use crate::error::PlanError;
use crate::motion::Limits;
use crate::plan::check::finite;
use crate::plan::single::check_limits;
use crate::scale::{exponent, largest, scale};

/// How many coordinates the points have.
pub(super) fn dimension(points: &[Vec<f64>], problem: Problem) -> Result<usize, PlanError> {
    if points.len() < problem.fewest() {
        let remedy = match points.len() {
            0 | 1 => "give at least two",
            2 => "give at least four, or with two points problem a or e",
            _ => "give at least four, or with three points problem a, e or f",
        };
        return Err(PlanError::Input { name: "number of points", value: points.len() as f64, remedy });
    }
    let dimension = points[0].len();
    for (index, point) in points.iter().enumerate() {
        let item = |name, value, remedy| Err(PlanError::Item { item: "point", index, name, value, remedy });
        if point.is_empty() {
            return item("number of coordinates", 0.0, "give one or more");
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

/// The velocities at both ends, a number an axis.
pub(super) fn ends(given: &[Vec<f64>; 2], dimension: usize, path: &Waypoints) -> Result<[Vec<f64>; 2], PlanError> {
    for end in given.iter().filter(|end| !end.is_empty()) {
        if path.problem != Problem::CubicsAtRest {
            let remedy = "only cubics have velocities at the ends to choose: leave them out, or give problem e";
            return Err(PlanError::Input { name: "number of velocities at an end", value: end.len() as f64, remedy });
        }
        if end.len() != dimension {
            let remedy = "give as many as the points have coordinates";
            return Err(PlanError::Input { name: "number of velocities at an end", value: end.len() as f64, remedy });
        }
        end.iter().try_for_each(|velocity| finite("velocity at an end", *velocity))?;
    }
    Ok([0, 1].map(|end: usize| if given[end].is_empty() { vec![0.0; dimension] } else { given[end].clone() }))
}

/// The limits of each axis.
pub(super) fn limits(given: &[Limits], dimension: usize) -> Result<Vec<Limits>, PlanError> {
    given.iter().try_for_each(check_limits)?;
    match given {
        [] => Ok(vec![Limits::NONE; dimension]),
        [all] => Ok(vec![*all; dimension]),
        _ if given.len() == dimension => Ok(given.to_vec()),
        _ => {
            let remedy = "give one for all axes, or as many as the points have coordinates";
            Err(PlanError::Input { name: "number of limits", value: given.len() as f64, remedy })
        }
    }
}

/// Whether limits say a time: there are some, and the path scales with it.
pub(super) fn can_be_timed(path: &Waypoints) -> Result<(), PlanError> {
    let are_finite = |limits: &Limits| limits.velocity.min(limits.acceleration).min(limits.jerk).is_finite();
    if !path.limits.iter().all(are_finite) || path.limits.is_empty() {
        let remedy = "give each axis a limit of velocity, acceleration or jerk, or give a speed or durations";
        return Err(PlanError::Input { name: "number of limits", value: path.limits.len() as f64, remedy });
    }
    if path.ends.iter().flatten().any(|velocity| *velocity != 0.0) {
        let remedy = "velocities at the ends do not scale with the time: give a speed or durations";
        return Err(PlanError::Input { name: "number of velocities at an end", value: path.ends.len() as f64, remedy });
    }
    Ok(())
}

/// Durations that are given.
pub(super) fn given(segments: usize, durations: &[f64]) -> Result<Vec<f64>, PlanError> {
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

/// By the distances of the points.
pub(super) fn by_distance(points: &[Vec<f64>], speed: f64) -> Result<Vec<f64>, PlanError> {
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
    let way: Vec<f64> = from.iter().zip(to).map(|(from, to)| to - from).collect();
    let most = largest(way.iter().copied());
    if !most.is_finite() {
        return f64::INFINITY;
    }
    let (far, fast) = (exponent(most), exponent(speed));
    let way: Vec<f64> = way.into_iter().map(|way| scale(way, -far)).collect();
    let speed = scale(speed, -fast);
    let time = match way.as_slice() {
        [x] => waypoints::segment_2d(0.0, 0.0, *x, 0.0, speed).time,
        [x, y] => waypoints::segment_2d(0.0, 0.0, *x, *y, speed).time,
        [x, y, z] => waypoints::segment_3d(0.0, 0.0, 0.0, *x, *y, *z, speed).time,
        more => more.iter().map(|way| way * way).sum::<f64>().sqrt() / speed,
    };
    scale(time, far - fast)
}
