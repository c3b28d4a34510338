//! `if` and its sides: what numbers decide is decided, and the other sides change nothing that is known afterwards.

use std::ops::Range;

use closedform_maxima::ast::Branch;
use closedform_maxima::{Expr, ExprKind};

use super::evaluate::Evaluator;
use super::numbers;
use super::state::{Evaluated, Refusal, Stop};
use super::statements::comparison;
use super::tree::symbol;

impl Evaluator {
    /// `if`: what numbers decide is decided; else both sides stay.
    pub(super) fn condition(
        &mut self,
        branches: &[Branch],
        otherwise: Option<&Expr>,
        span: &Range<usize>,
    ) -> Evaluated {
        let mut kept: Vec<Branch> = Vec::new();
        let mut last = None;
        for Branch { condition, value } in branches {
            let condition = match self.value(condition) {
                Ok(condition) => comparison(&condition),
                Err(stop) => return Err(self.undecidable(stop, branches, otherwise)),
            };
            match numbers::decided(&condition) {
                Some(false) => {}
                Some(true) => {
                    last = Some(value);
                    break;
                }
                None => {
                    let value = self.under_condition(value, span)?;
                    kept.push(Branch { condition, value });
                }
            }
        }
        match (kept.is_empty(), last.or(otherwise)) {
            (true, Some(value)) => self.value(value),
            (true, None) => Ok(symbol("false", span)),
            (false, value) => {
                let otherwise = value.map(|value| self.under_condition(value, span)).transpose()?.map(Box::new);
                Ok(Expr::new(ExprKind::If { branches: kept, otherwise }, span.clone()))
            }
        }
    }

    /// Which side counts cannot be known, nor what any of them changes.
    fn undecidable(&mut self, stop: Stop, branches: &[Branch], otherwise: Option<&Expr>) -> Stop {
        if let Stop::Refused(because) = &stop {
            let sides = branches.iter().map(|branch| &branch.value).chain(otherwise);
            sides.for_each(|side| self.doubt(side, because));
        }
        stop
    }

    /// A value that counts under a condition only: what it changes is not known afterwards.
    fn under_condition(&mut self, value: &Expr, span: &Range<usize>) -> Evaluated {
        let earlier = self.state.clone();
        self.undecided += 1;
        let found = self.value(value);
        self.undecided -= 1;
        let because = Refusal::new("it depends on an `if`", "write it as a function without `if`", span);
        self.state.doubt(earlier, &because);
        match found {
            Err(Stop::Return(_)) => {
                let what = "`return` under a condition that only its inputs decide";
                Err(Refusal::new(what, "write the block as one `if` with a value on each side", &value.span).into())
            }
            other => other,
        }
    }
}
