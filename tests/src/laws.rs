//! Laws: results put back into the equations they solve.

pub mod chain;
pub mod motion;

use closedform_maxima::ast::BinaryOperator;
use closedform_maxima::{Expr, ExprKind, Relation};
use rug::Rational;

use crate::check::Judge;
use crate::inputs::Points;
use crate::rational::{self, Names};

use chain::{Chain, Claim, Run, parse, value};

/// An equation or a condition between the inputs of a kernel, by their Maxima names, and its results, by names of the
/// law's own.
///
/// An equation, and a comparison that includes equality (`<=`, `>=`) and stands alone, holds up to what the bounds of the
/// results allow; any other condition holds for the results as they are.
#[derive(Clone, Debug)]
pub struct Law {
    text: String,
    claim: Expr,
}

impl Law {
    /// The law that a text states.
    ///
    /// # Panics
    ///
    /// It is not Maxima text.
    pub fn new(text: &str) -> Self {
        Law { text: text.to_owned(), claim: parse(text) }
    }

    /// Demands the law at every point. `names` are those of the results, in order.
    ///
    /// # Errors
    ///
    /// The first point where it does not hold.
    ///
    /// # Panics
    ///
    /// The law names what the kernel does not have.
    pub fn check(&self, judge: &Judge, names: &[&'static str], points: &Points) -> Result<(), String> {
        Chain::new(judge, names).check(points, &[self]).map(drop)
    }

    /// Whether equality satisfies it, so that bounds may lead beyond it.
    fn is_closed(&self) -> bool {
        use Relation::{Equal, GreaterOrEqual, LessOrEqual};
        matches!(
            self.claim.kind,
            ExprKind::Binary { operator: BinaryOperator::Compare(Equal | LessOrEqual | GreaterOrEqual), .. }
        )
    }

    /// What must not be above zero.
    fn excesses(&self, names: &Names) -> Vec<Option<Rational>> {
        let ExprKind::Binary { operator, left, right } = &self.claim.kind else { return Vec::new() };
        let excess = || Some(value(left, names)? - value(right, names)?);
        let deficit = |excess: &Option<Rational>| excess.as_ref().map(|excess| Rational::from(-excess));
        match operator {
            BinaryOperator::Compare(Relation::Equal) => {
                let excess = excess();
                vec![deficit(&excess), excess]
            }
            BinaryOperator::Compare(Relation::LessOrEqual) => vec![excess()],
            BinaryOperator::Compare(Relation::GreaterOrEqual) => vec![deficit(&excess())],
            _ => Vec::new(),
        }
    }
}

impl Claim for Law {
    fn broken(&self, run: &Run) -> Option<String> {
        let what = if self.is_closed() {
            run.exceeding(|names| self.excesses(names)).map(|(_, what)| what)
        } else {
            let holds = rational::holds(&self.claim, &run.values).expect("a condition is rational");
            (!holds).then(|| "is false".to_owned())
        };
        what.map(|what| format!("law `{}` {what}", self.text))
    }
}

/// A kernel and the Maxima name that its first result goes by.
pub type Named<'a> = (&'a Judge, &'static str);

/// Demands that `second`, fed with the result of `first` and with its inputs, returns what `first` was given.
///
/// Inputs of the second that the first neither has nor returns are `constants`.
///
/// # Errors
///
/// The first point where it does not, to what the bounds of both allow, or too many points that lead out of the domain of
/// the second.
///
/// # Panics
///
/// The kernels do not fit together.
pub fn check_inverse(
    first: Named,
    second: Named,
    constants: &[(&'static str, &str)],
    points: &Points,
) -> Result<(), String> {
    let chain = Chain::new(first.0, &[first.1]);
    let chain = constants.iter().fold(chain, |chain, (name, value)| chain.define(name, value));
    let returned = Law::new(&format!("returned = {}", second.1));
    chain.then(second.0, &["returned"]).check(points, &[&returned]).map(drop)
}
