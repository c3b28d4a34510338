//! Loops: run through where numbers and lists say how often, and left where only Maxima can know.

use closedform_maxima::Expr;
use closedform_maxima::ast::{LoopClause, LoopWord};

use super::calls::ITEMS;
use super::evaluate::{Evaluator, because_of};
use super::numbers;
use super::state::{Binding, Evaluated, Refusal, Stop};
use super::statements::comparison;
use super::tree::{self, list, rows, small, symbol};
use super::words::COMPUTE;

/// The words of a loop, each with what follows it.
#[derive(Default)]
struct Words<'a> {
    variable: Option<&'a str>,
    from: Option<&'a Expr>,
    items: Option<&'a Expr>,
    step: Option<&'a Expr>,
    next: Option<&'a Expr>,
    thru: Option<&'a Expr>,
    /// Conditions to go on, and whether they must hold.
    conditions: Vec<(&'a Expr, bool)>,
}

impl<'a> Words<'a> {
    fn of(clauses: &'a [LoopClause]) -> Self {
        let mut words = Self::default();
        for LoopClause { word, value } in clauses {
            match word {
                LoopWord::For => words.variable = value.as_symbol(),
                LoopWord::From => words.from = Some(value),
                LoopWord::In => words.items = Some(value),
                LoopWord::Step => words.step = Some(value),
                LoopWord::Next => words.next = Some(value),
                LoopWord::Thru => words.thru = Some(value),
                LoopWord::While => words.conditions.push((value, true)),
                LoopWord::Unless => words.conditions.push((value, false)),
            }
        }
        words
    }
}

/// The variable of a loop that names none.
const NAMELESS: &str = "\u{3}";

impl Evaluator {
    /// The value of a loop; if it cannot be run through, what it may change is not known afterwards.
    pub(super) fn repeated(&mut self, whole: &Expr, clauses: &[LoopClause], body: &Expr) -> Expr {
        let words = Words::of(clauses);
        let variable = words.variable.unwrap_or(NAMELESS);
        let before = self.state.bind(variable, None);
        let done = match words.items {
            Some(items) => self.for_items(variable, items, &words, body),
            None => self.for_numbers(variable, &words, body),
        };
        self.state.restore(vec![before]);
        match done {
            Ok(()) => symbol("done", &whole.span),
            Err(Stop::Return(value)) => value,
            Err(Stop::Refused(because)) => {
                self.left += 1;
                match because.remedy == COMPUTE {
                    true => self.doubt(whole, &because),
                    false => self.leave(whole, "a loop"),
                }
                symbol("done", &whole.span)
            }
        }
    }

    fn for_items(&mut self, variable: &str, items: &Expr, words: &Words, body: &Expr) -> Evaluated<()> {
        let items = self.value(items)?;
        let of_matrix = || {
            let whole = |row: &[Expr]| Expr::new(closedform_maxima::ExprKind::List(row.to_vec()), items.span.clone());
            rows(&items).map(|rows| rows.into_iter().map(whole).collect())
        };
        let Some(each) = list(&items).map(<[Expr]>::to_vec).or_else(of_matrix) else {
            return Err(because_of(&[&items], unknown(&items)).into());
        };
        for item in each {
            self.state.bind(variable, Some(Binding::Value(item.into())));
            if !self.goes_on(words)? {
                break;
            }
            self.value(body)?;
        }
        Ok(())
    }

    fn for_numbers(&mut self, variable: &str, words: &Words, body: &Expr) -> Evaluated<()> {
        let from = self.number_or(words.from, 1)?;
        let step = self.number_or(words.step, 1)?;
        let thru = words.thru.map(|thru| self.number_or(Some(thru), 0)).transpose()?;
        let mut at = from;
        for _ in 0..ITEMS {
            let is_beyond = |thru: i64| if step < 0 { at < thru } else { at > thru };
            self.state.bind(variable, Some(Binding::Value(tree::number(at, &body.span).into())));
            if thru.is_some_and(is_beyond) || !self.goes_on(words)? {
                return Ok(());
            }
            self.value(body)?;
            // a body may set the variable itself
            let own = symbol(variable, &body.span);
            at = match words.next {
                Some(next) => self.number_or(Some(next), 0)?,
                None => self.number_or(Some(&own), 0)?.checked_add(step).ok_or_else(|| unknown(body))?,
            };
        }
        Err(unknown(body).into())
    }

    fn goes_on(&mut self, words: &Words) -> Evaluated<bool> {
        for (condition, wanted) in &words.conditions {
            let value = comparison(&self.value(condition)?);
            match numbers::decided(&value) {
                Some(holds) if holds == *wanted => {}
                Some(_) => return Ok(false),
                None => return Err(because_of(&[&value], unknown(condition)).into()),
            }
        }
        Ok(true)
    }

    fn number_or(&mut self, number: Option<&Expr>, otherwise: i64) -> Evaluated<i64> {
        let Some(number) = number else { return Ok(otherwise) };
        let value = self.value(number)?;
        small(&value).ok_or_else(|| because_of(&[&value], unknown(number)).into())
    }
}

fn unknown(place: &Expr) -> Refusal {
    Refusal::new("a loop of which only Maxima knows how often it runs", "write what it gives as a formula", &place.span)
}
