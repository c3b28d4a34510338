//! Where subterms vanish: for one input, near its present value.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, evaluate_double};

use super::target::Target;
use closedform_project::domain::{Comparison, exact};

/// Steps of the secant method; it doubles the digits about every second one.
const STEPS: usize = 12;

/// What vanishes at some inputs, and is dangerous there: sums inside the references, and edges of the domain.
pub(super) struct Zeros {
    names: Vec<String>,
    terms: Vec<Term>,
}

enum Term {
    /// A sum of a reference.
    Sum(Expr),
    /// The difference of the sides of a comparison.
    Edge(Comparison),
}

impl Zeros {
    pub(super) fn of(target: &Target) -> Self {
        let mut sums = Vec::new();
        target.reference.bodies().for_each(|body| collect(body, &mut sums));
        let names = target.domain.variables().to_vec();
        let sample = vec![1.0; names.len()];
        sums.retain(|term| evaluate_double(term, &names, &sample).is_some());
        let edges = target.domain.comparisons().into_iter().cloned().map(Term::Edge);
        Zeros { names, terms: sums.into_iter().map(Term::Sum).chain(edges).collect() }
    }

    pub(super) fn len(&self) -> usize {
        self.terms.len()
    }

    /// The value of an input with which a term vanishes, if the secant method finds one.
    pub(super) fn solve(&self, term: usize, input: usize, point: &[f64]) -> Option<f64> {
        let mut moved = point.to_vec();
        let mut at = |x: f64| {
            moved[input] = x;
            self.terms[term].value(&self.names, &moved).filter(|value| value.is_finite())
        };
        let start = point[input];
        let (mut x0, mut x1) = (start, if start == 0.0 { 1.0 } else { start * 1.0625 });
        let (mut y0, mut y1) = (at(x0)?, at(x1)?);
        for _ in 0..STEPS {
            if y1 == y0 || y1 == 0.0 {
                break;
            }
            let next = x1 - y1 * ((x1 - x0) / (y1 - y0));
            (x0, y0) = (x1, y1);
            (x1, y1) = (next, at(next)?);
        }
        let settled = y1 == 0.0 || (x1 - x0).abs() <= x1.abs() * 1e-6;
        (settled && x1 != start && x1.is_finite()).then_some(x1)
    }
}

impl Term {
    /// Its value at a point, as near as a double is.
    fn value(&self, names: &[String], point: &[f64]) -> Option<f64> {
        match self {
            Self::Sum(sum) => evaluate_double(sum, names, point),
            Self::Edge(edge) => Some(edge.difference_at(&exact(point)?)?.to_f64()),
        }
    }
}

/// Every sum and difference inside the expression, each once.
fn collect(expression: &Expr, terms: &mut Vec<Expr>) {
    match &expression.kind {
        ExprKind::Binary { operator, left, right } => {
            let sum = matches!(operator, BinaryOperator::Add | BinaryOperator::Subtract);
            if sum && !terms.contains(expression) {
                terms.push(expression.clone());
            }
            collect(left, terms);
            collect(right, terms);
        }
        ExprKind::Unary { operand, .. } => collect(operand, terms),
        ExprKind::Call { arguments, .. } => arguments.iter().for_each(|argument| collect(argument, terms)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_maxima::parse_expression;
    use closedform_project::domain::Condition;

    #[test]
    fn zeros_are_found_where_they_are() {
        let mut terms = Vec::new();
        collect(&parse_expression("sqrt(x^2-2*y)/(x+y)").unwrap(), &mut terms);
        let terms = terms.into_iter().map(Term::Sum).collect();
        let zeros = Zeros { names: vec!["x".to_owned(), "y".to_owned()], terms };
        assert_eq!(zeros.len(), 2);
        let near = |found: Option<f64>, wanted: f64| found.is_some_and(|found| (found - wanted).abs() < 1e-12);
        assert!(near(zeros.solve(0, 0, &[3.0, 2.0]), 2.0));
        assert!(near(zeros.solve(0, 1, &[3.0, 2.0]), 4.5));
        assert!(near(zeros.solve(1, 1, &[3.0, 2.0]), -3.0));
        let with = |term| Zeros { names: zeros.names.clone(), terms: vec![term] };
        assert_eq!(with(Term::Sum(parse_expression("x^2+1").unwrap())).solve(0, 0, &[3.0, 2.0]), None);
        let condition = Condition::parse("x*y > 6", &zeros.names).unwrap();
        let edge = with(Term::Edge(condition.comparisons()[0].clone()));
        assert!(near(edge.solve(0, 0, &[4.0, 2.0]), 3.0));
    }
}
