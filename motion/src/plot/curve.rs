//! Curves without the points that nobody sees.

/// Points within such a column, of all its pixels in the width of a curve, are drawn by four of them at most.
struct Column {
    start: f64,
    points: Vec<(f64, f64)>,
}

impl Column {
    /// Its first, least, greatest and last point.
    fn visible(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let height = |index: &usize| self.points[*index].1;
        let indices = || 0..self.points.len();
        let least = indices().min_by(|a, b| height(a).total_cmp(&height(b)));
        let greatest = indices().max_by(|a, b| height(a).total_cmp(&height(b)));
        let mut kept: Vec<usize> =
            [indices().next(), least, greatest, indices().last()].into_iter().flatten().collect();
        kept.sort_unstable();
        kept.dedup();
        kept.into_iter().map(|index| self.points[index])
    }
}

/// A curve over time by the points that are seen where each column is so wide.
pub(super) fn thinned(points: Vec<(f64, f64)>, width: f64) -> Vec<(f64, f64)> {
    let mut columns: Vec<Column> = Vec::new();
    for point in points {
        match columns.last_mut() {
            Some(column) if point.0 - column.start <= width => column.points.push(point),
            _ => columns.push(Column { start: point.0, points: vec![point] }),
        }
    }
    columns.iter().flat_map(Column::visible).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_keep_their_extremes() {
        let spike = |index: u32| (f64::from(index) * 0.001, if index == 7 { 90.0 } else { 1.0 });
        let thin = thinned((0..1000).map(spike).collect(), 0.05);
        assert!(thin.contains(&(0.007, 90.0)) && thin.len() < 60, "{thin:?}");
    }

    #[test]
    fn a_step_stays_a_step() {
        let step = vec![(0.0, 10.0), (1.0, 10.0), (1.0, 60.0), (2.0, 60.0)];
        assert_eq!(thinned(step.clone(), 0.5), step);
    }
}
