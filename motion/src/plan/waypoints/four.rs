//! Four points: the segments as the kernels solve them, to the last digits.

use closedform_kernels::waypoints;

use super::Problem;
use crate::scale::{exponent, largest, scale};
use crate::segment::{Segment, State};

/// Kernels take products of up to eight times: with times no further apart than this power of two, and near 1, neither
/// those nor their rounding errors underflow.
const APART: i32 = 64;

/// The coefficients of one segment: position is c\[0\] + c\[1\]*t + c\[2\]*t² + ..
type Coefficients = [f64; 5];

/// The segments through four points; none for more points, or times that are too far apart for the kernels.
pub(super) fn segments(problem: Problem, positions: &[f64], durations: &[f64]) -> Option<Vec<Segment>> {
    let p: [f64; 4] = positions.try_into().ok()?;
    let t: [f64; 3] = durations.try_into().ok()?;
    let least = t.into_iter().fold(f64::INFINITY, f64::min);
    if exponent(largest(t)) - exponent(least) > APART {
        return None;
    }
    let way = coefficients(problem, p, t);
    let back = coefficients(problem, [p[3], p[2], p[1], p[0]], [t[2], t[1], t[0]]);
    Some((0..3).map(|index| segment(problem, index, (&p, &t), (&way, &back))).collect())
}

/// Segment `index`. Where the next segment starts is where it ends; the last one ends where the way back starts.
fn segment(
    problem: Problem,
    index: usize,
    (p, t): (&[f64; 4], &[f64; 3]),
    (way, back): (&[Coefficients; 3], &[Coefficients; 3]),
) -> Segment {
    use Problem::{Linear, QuadraticCubicQuadraticAtRest};
    let own = way[index];
    let (next, returning) = (way.get(index + 1), back[2 - index]);
    let velocity = match next {
        _ if problem == Linear => own[1],
        Some(next) => next[1],
        // The same speed, the other way; 0 - v has no -0.
        None => 0.0 - returning[1],
    };
    let acceleration = match next {
        _ if degree(problem, index) <= 2 => own[2],
        Some(next) if problem != QuadraticCubicQuadraticAtRest => next[2],
        _ => returning[2],
    };
    Segment {
        duration: t[index],
        start: State { position: p[index], velocity: own[1], acceleration: 2.0 * own[2] },
        end: State { position: p[index + 1], velocity, acceleration: 2.0 * acceleration },
        jerk: 6.0 * own[3],
        snap: 24.0 * own[4],
    }
}

/// Of segment `index` of three.
fn degree(problem: Problem, index: usize) -> usize {
    match (problem, problem.degrees()) {
        (Problem::QuadraticLinearQuadratic, _) if index == 1 => 1,
        (_, (_, inner)) if index == 1 => inner,
        (_, (outer, _)) => outer,
    }
}

/// By the kernels, with rises and times near 1, which changes no digit.
fn coefficients(problem: Problem, p: [f64; 4], t: [f64; 3]) -> [Coefficients; 3] {
    let rise = largest(p.windows(2).map(|pair| pair[1] - pair[0])).min(f64::MAX);
    let far = exponent(if rise > 0.0 { rise } else { largest(p) });
    let long = exponent(largest(t));
    let near = by_kernel(problem, p.map(|p| scale(p, -far)), t.map(|t| scale(t, -long)));
    near.map(|segment| {
        let mut power = far;
        segment.map(|coefficient| {
            let value = scale(coefficient, power);
            power -= long;
            value
        })
    })
}

fn by_kernel(problem: Problem, [p0, p1, p2, p3]: [f64; 4], [t0, t1, t2]: [f64; 3]) -> [Coefficients; 3] {
    match problem {
        Problem::Linear => {
            let c = waypoints::linear(p0, p1, p2, p3, t0, t1, t2);
            [[c.c00, c.c01, 0.0, 0.0, 0.0], [c.c10, c.c11, 0.0, 0.0, 0.0], [c.c20, c.c21, 0.0, 0.0, 0.0]]
        }
        Problem::QuadraticLinearQuadratic => {
            let c = waypoints::quadratic_linear_quadratic(p0, p1, p2, p3, t0, t1, t2);
            [[c.c00, c.c01, c.c02, 0.0, 0.0], [c.c10, c.c11, 0.0, 0.0, 0.0], [c.c20, c.c21, c.c22, 0.0, 0.0]]
        }
        Problem::QuadraticCubicQuadraticAtRest => {
            let c = waypoints::quadratic_cubic_quadratic_at_rest(p0, p1, p2, p3, t0, t1, t2);
            [[c.c00, c.c01, c.c02, 0.0, 0.0], [c.c10, c.c11, c.c12, c.c13, 0.0], [c.c20, c.c21, c.c22, 0.0, 0.0]]
        }
        Problem::QuadraticCubicQuadratic => {
            let c = waypoints::quadratic_cubic_quadratic(p0, p1, p2, p3, t0, t1, t2);
            [[c.c00, c.c01, c.c02, 0.0, 0.0], [c.c10, c.c11, c.c12, c.c13, 0.0], [c.c20, c.c21, c.c22, 0.0, 0.0]]
        }
        Problem::CubicsAtRest => {
            let c = waypoints::cubics_at_rest(p0, p1, p2, p3, t0, t1, t2);
            [[c.c00, c.c01, c.c02, c.c03, 0.0], [c.c10, c.c11, c.c12, c.c13, 0.0], [c.c20, c.c21, c.c22, c.c23, 0.0]]
        }
        Problem::QuarticCubicQuarticAtRest => {
            let c = waypoints::quartic_cubic_quartic_at_rest(p0, p1, p2, p3, t0, t1, t2);
            [
                [c.c00, c.c01, c.c02, c.c03, c.c04],
                [c.c10, c.c11, c.c12, c.c13, 0.0],
                [c.c20, c.c21, c.c22, c.c23, c.c24],
            ]
        }
    }
}
