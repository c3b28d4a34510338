//! Domains: conditions on a kernel's inputs, decided exactly.

mod condition;
mod error;
mod exact;
mod magnitude;
mod read;

use rug::Rational;

pub use condition::{Comparison, Condition};
pub use error::ConditionError;

/// Where a kernel's promise holds: all conditions hold, and all inputs are finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    variables: Vec<String>,
    conditions: Vec<Stated>,
}

/// A condition of a domain.
#[derive(Debug, Clone, PartialEq)]
pub struct Stated {
    /// As the contract spells it.
    pub text: String,
    /// What must hold.
    pub condition: Condition,
    /// Whether nobody promises it but the formula needs it, so that it may be left out where the others imply it.
    pub natural: bool,
}

impl Domain {
    /// The domain of inputs with these Maxima names; each condition with its text, parsed for the same inputs.
    pub fn new(variables: Vec<String>, conditions: Vec<(String, Condition)>) -> Self {
        let stated = |(text, condition)| Stated { text, condition, natural: false };
        Self { variables, conditions: conditions.into_iter().map(stated).collect() }
    }

    /// The domain in which these conditions hold too, which a formula needs; not twice what it has already.
    #[must_use]
    pub fn with_natural(mut self, conditions: impl IntoIterator<Item = (String, Condition)>) -> Self {
        for (text, condition) in conditions {
            if self.conditions.iter().all(|stated| stated.condition != condition) {
                self.conditions.push(Stated { text, condition, natural: true });
            }
        }
        self
    }

    /// Every condition, in order.
    pub fn stated(&self) -> &[Stated] {
        &self.conditions
    }

    /// The Maxima names of the inputs, in the order of the coordinates of a point.
    pub fn variables(&self) -> &[String] {
        &self.variables
    }

    /// The conditions, in contract order.
    pub fn conditions(&self) -> impl ExactSizeIterator<Item = &Condition> {
        self.conditions.iter().map(|stated| &stated.condition)
    }

    /// The conditions as the contract spells them.
    pub fn texts(&self) -> impl ExactSizeIterator<Item = &str> {
        self.conditions.iter().map(|stated| stated.text.as_str())
    }

    /// Whether a point, one coordinate a variable, lies in the domain; decided without rounding.
    pub fn holds(&self, point: &[f64]) -> bool {
        exact(point).is_some_and(|point| self.conditions().all(|condition| condition.holds(&point)))
    }

    /// The position of the first condition that does not hold; `None` too where a coordinate is not finite, which is no
    /// condition's fault.
    pub fn violated(&self, point: &[f64]) -> Option<usize> {
        let point = exact(point)?;
        self.conditions().position(|condition| !condition.holds(&point))
    }

    /// Every comparison in the conditions.
    pub fn comparisons(&self) -> Vec<&Comparison> {
        self.conditions().flat_map(Condition::comparisons).collect()
    }
}

/// The same point in rationals; `None` if a coordinate is not finite.
pub fn exact(point: &[f64]) -> Option<Vec<Rational>> {
    point.iter().map(|value| Rational::from_f64(*value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn domain(variables: &[&str], conditions: &[&str]) -> Domain {
        let variables: Vec<String> = variables.iter().map(|name| name.to_string()).collect();
        let parsed = conditions.iter().map(|text| (text.to_string(), Condition::parse(text, &variables).unwrap()));
        let conditions = parsed.collect();
        Domain::new(variables, conditions)
    }

    #[test]
    fn decisions_do_not_round() {
        let sum = domain(&["a", "b", "c"], &["a+b > c"]);
        assert!(sum.holds(&[1.0, 1e-300, 1.0]));
        assert!(!sum.holds(&[1.0, 0.0, 1.0]));
        let tenths = domain(&["x"], &["10*x > 1"]);
        assert!(tenths.holds(&[0.1])); // the double nearest 0.1 is above it
        assert!(!tenths.holds(&[0.1f64.next_down()]));
        let huge = domain(&["x"], &["x*x*x > 0"]);
        assert!(huge.holds(&[f64::MAX]));
        assert!(huge.holds(&[f64::from_bits(1)]));
    }

    #[test]
    fn conditions_combine() {
        let either = domain(&["a", "v"], &["a # 0 or v > 0", "not (a < 0 and v < 0)"]);
        assert_eq!(either.violated(&[0.0, 0.0]), Some(0));
        assert_eq!(either.violated(&[-1.0, -1.0]), Some(1));
        assert_eq!(either.violated(&[-1.0, 1.0]), None);
        assert_eq!(either.comparisons().len(), 4);
    }

    #[test]
    fn what_has_no_value_neither_holds_nor_fails() {
        let at_zero = |condition: &str| domain(&["x", "y"], &[condition]).holds(&[0.0, 0.0]);
        for pole in [
            "1/x # 7",
            "x^-2 >= 4",
            "x^(1-2) < 3",
            "(x^2-y^2)/(x-y) >= 0",
            "x*y/(x*y) > 0",
            "0/x = 0",
            "0*x^-1 <= 1",
            "1/(1/x) >= 0",
            "(1/x)^0 > 0",
            "1 < 2 + x/(y-x)",
            "abs(1/x) > 1",
            "abs(y)/abs(x) # 3",
        ] {
            assert!(!at_zero(pole), "{pole}");
            assert!(!at_zero(&format!("not ({pole})")), "not {pole}");
            assert!(!at_zero(&format!("{pole} and x = 0")), "{pole} and");
            assert!(at_zero(&format!("{pole} or x = 0")), "{pole} or");
            assert!(at_zero(&format!("not ({pole} and x # 0)")), "{pole}: one part fails");
            assert!(!at_zero(&format!("not ({pole} or x # 0)")), "{pole}: no part holds");
        }
    }

    #[test]
    fn not_turns_what_has_a_value() {
        let turned = domain(&["x"], &["not (x < 0 or not (1/x <= 1 and x # 2))"]);
        assert_eq!(
            [-1.0, 0.0, 0.5, 1.0, 2.0, 3.0].map(|x| turned.holds(&[x])),
            [false, false, false, true, false, true]
        );
    }

    #[test]
    fn poles_and_infinities_are_outside() {
        let pole = domain(&["x"], &["1/x # 7"]);
        assert!(!pole.holds(&[0.0]));
        assert!(pole.holds(&[1.0]));
        assert!(!pole.holds(&[f64::INFINITY]));
        assert!(!pole.holds(&[f64::NAN]));
        assert_eq!(pole.violated(&[f64::NAN]), None);
    }

    #[test]
    fn what_is_no_condition_says_why() {
        let variables = ["x".to_owned()];
        let message = |text: &str| Condition::parse(text, &variables).unwrap_err().to_string();
        assert_eq!(message("x"), "the domain condition is not a comparison");
        assert_eq!(message("x > y"), "the domain condition names `y`, which is not an input of this kernel");
        assert_eq!(message("sqrt(x) > 0"), "a side of the domain condition is not a rational function");
        assert_eq!(message("x^x > 0"), "a side of the domain condition is not a rational function");
        assert_eq!(message("x^9999 > 0"), "a side of the domain condition is not a rational function");
        assert_eq!(message("x > 1 and x"), "the domain condition is not a comparison");
        let nothing =
            "a side of the domain condition has no value anywhere: it divides by zero, whatever its inputs are";
        assert_eq!(message("x > 0 or 1/(2-2) # 7"), nothing);
        assert!(message("x > 0^0").starts_with("a side of the domain condition has no value anywhere: 0^0"));
        assert!(message("x > ").starts_with("the domain condition cannot be read"));
        let place =
            |text: &str| Condition::parse(text, &variables).unwrap_err().span().map(|span| text[span].to_owned());
        assert_eq!(place("x > 0 or 1/(2-2) # 7").as_deref(), Some("(2-2)"));
        assert_eq!(place("not abs(x-sqrt(x)) > 1").as_deref(), Some("sqrt(x)"));
    }
}
