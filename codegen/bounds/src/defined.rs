//! That a value is defined wherever it is computed: no divisor is zero, nothing negative stands under a root, and every
//! `positive_root` is there.

use crate::case::Case;
use crate::count::Counter;
use crate::refusal::{Reason, Refusal, Undefined};
use crate::sign::Sign;
use crate::text::{is_whole, text};
use closedform_arith::function::Domain;
use closedform_syntax::{BinaryOp, Condition, Expr, Function, condition_text};

impl<'k> Counter<'k> {
    /// That a divisor is not zero.
    pub(crate) fn divides(&self, divisor: &'k Expr, case: &Case, step: &str) -> Result<(), Refusal> {
        self.has_sign(divisor, Sign::NONZERO, Undefined::Quotient, case, step)
    }

    /// That a root has a value: that the argument of one that has none below zero is not negative. Other functions have no bound.
    pub(crate) fn has_value(
        &self,
        function: Function,
        argument: &'k Expr,
        case: &Case,
        step: &str,
    ) -> Result<(), Refusal> {
        if function.properties().domain != Domain::NotNegative {
            return Ok(());
        }
        self.has_sign(argument, Sign::NONNEGATIVE, Undefined::Root, case, step)
    }

    /// That the coefficients of a polynomial change their sign once: at one power, which may itself have any sign.
    pub(crate) fn has_positive_root(
        &self,
        root: &'k Expr,
        coefficients: &'k [Expr],
        case: &Case,
        step: &str,
    ) -> Result<(), Refusal> {
        let has = |coefficient: &'k Expr, sign| self.shows(coefficient, sign, case);
        let changes_at = |turn: usize| {
            let (below, above) = (&coefficients[..turn], &coefficients[turn + 1..]);
            below.iter().all(|c| has(c, Sign::NONPOSITIVE))
                && above.iter().all(|c| has(c, Sign::NONNEGATIVE))
                && coefficients[..=turn].iter().any(|c| has(c, Sign::NEGATIVE))
                && coefficients[turn..].iter().any(|c| has(c, Sign::POSITIVE))
        };
        if (0..coefficients.len()).any(changes_at) {
            return Ok(());
        }
        self.refuse(step, Reason::Undefined { kind: Undefined::PolynomialRoot, value: text(root), condition: None })
    }

    /// Why a comparison of the domain is not decided.
    pub(crate) fn why_open(&self, comparison: &'k Condition, cases: &[Case]) -> Reason {
        let Condition::Compare { left, right, .. } = comparison else {
            return Reason::Undecided(condition_text(comparison));
        };
        let refusals = cases.iter().flat_map(|case| [left, right].map(|side| self.count(side, case, "require!").err()));
        let undefined =
            refusals.flatten().map(|refusal| refusal.reason).find(|reason| matches!(reason, Reason::Undefined { .. }));
        undefined.unwrap_or_else(|| Reason::Undecided(condition_text(comparison)))
    }

    fn has_sign(&self, value: &'k Expr, sign: Sign, kind: Undefined, case: &Case, step: &str) -> Result<(), Refusal> {
        if self.shows(value, sign, case) {
            return Ok(());
        }
        let condition =
            (self.is_of_inputs(value) && is_whole(value)).then(|| format!("{} {} 0.0", text(value), kind.comparison()));
        self.refuse(step, Reason::Undefined { kind, value: text(value), condition })
    }

    /// Whether a value has this sign, or is never computed.
    fn shows(&self, value: &'k Expr, sign: Sign, case: &Case) -> bool {
        self.sign(value, case).is(sign)
            || self.parts_show(self.forms.resolved(value), sign, case)
            || self.is_contradiction(value, sign.complement(), case)
    }

    /// Whether the parts of a choice or of a quotient have signs from which this one follows.
    fn parts_show(&self, value: &'k Expr, sign: Sign, case: &Case) -> bool {
        let shows = |part: &'k Expr| self.shows(part, sign, case);
        match value {
            Expr::Neg(inner) => self.shows(inner, sign.negated(), case),
            Expr::If { condition, then, otherwise } => {
                let branch =
                    |holds, value| self.cases(condition, holds, case).iter().all(|c| self.shows(value, sign, c));
                branch(true, then) && branch(false, otherwise)
            }
            Expr::Extreme { largest, items } => {
                // the others can only lead further to this side
                let side =
                    if *largest { [Sign::POSITIVE, Sign::NONNEGATIVE] } else { [Sign::NEGATIVE, Sign::NONPOSITIVE] };
                let one_is = |side: Sign| side.is(sign) && items.iter().any(|item| self.shows(item, side, case));
                items.iter().all(shows) || side.into_iter().any(one_is)
            }
            Expr::Binary { op: BinaryOp::Div, left, right } => {
                [Sign::NONNEGATIVE, Sign::NONPOSITIVE].iter().any(|side| {
                    side.times(*side).is(sign) && self.shows(left, *side, case) && self.shows(right, *side, case)
                })
            }
            _ => false,
        }
    }

    /// Whether it contradicts what is known that a value has this sign.
    fn is_contradiction(&self, value: &'k Expr, sign: Sign, case: &Case) -> bool {
        let form = (*self.forms.of(value)).clone();
        case.split(&[vec![(form, sign)]]).iter().all(|other| other.facts.borrow().are_contradictory())
    }

    /// Whether a condition may name everything in it.
    fn is_of_inputs(&self, value: &'k Expr) -> bool {
        match value {
            Expr::Name(name) => self.forms.step(name.slot).is_none(),
            Expr::Residual(_) | Expr::PositiveRoot(_) | Expr::If { .. } => false,
            _ => value.children().into_iter().all(|part| self.is_of_inputs(part)),
        }
    }
}
