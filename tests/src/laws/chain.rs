//! Kernels that take each other's results, and how far their bounds let an expression in all of these move.

use std::collections::BTreeMap;

use closedform_maxima::{Expr, evaluate, parse_expression};
use rug::{Float, Rational};

use crate::check::Judge;
use crate::failure::{list, replay};
use crate::inputs::{Maker, Points};
use crate::rational::{self, Names};
use crate::ulp::{self, F64};

/// Bits of what is not rational.
const PRECISION: u32 = 512;

/// The largest share of points whose results rounding may take out of the domain of the next kernel.
const LEFT_SHARE: f64 = 0.05;

/// What is demanded of the inputs and results at a point.
pub trait Claim {
    /// How it is broken, if it is.
    fn broken(&self, run: &Run) -> Option<String>;
}

/// A kernel and those that take its results. Inputs go by their Maxima names, results by names given here.
#[derive(Clone, Debug)]
pub struct Chain {
    links: Vec<Link>,
}

#[derive(Clone, Debug)]
enum Link {
    Kernel { judge: Box<Judge>, names: Vec<&'static str> },
    Definition { name: &'static str, value: Expr },
}

/// Values at one point: those that came out, and those that come out where one result moves by its bound.
#[derive(Clone, Debug)]
pub struct Run {
    /// Inputs, definitions and results.
    pub values: Names<'static>,
    /// The same for each result, moved down and up by its bound; none where a later kernel has no value there.
    moved: Vec<[Option<Names<'static>>; 2]>,
}

/// What a link adds.
struct Named {
    name: &'static str,
    value: Rational,
    /// What the bound of a result is worth.
    error: Option<Rational>,
}

/// Why there are no values at a point.
enum Stop {
    /// Rounding leads out of the domain of a later kernel.
    Left,
    Broken(String),
}

impl Chain {
    /// The first kernel, which takes the points, and the names of its first results.
    pub fn new(judge: &Judge, names: &[&'static str]) -> Self {
        Chain { links: Vec::new() }.then(judge, names)
    }

    /// A name for an expression in inputs and results so far, as an input of the next kernels or in claims.
    ///
    /// # Panics
    ///
    /// It is not Maxima text.
    pub fn define(mut self, name: &'static str, text: &str) -> Self {
        self.links.push(Link::Definition { name, value: parse(text) });
        self
    }

    /// One more kernel, which takes what has its inputs' names so far, and the names of its first results.
    ///
    /// # Panics
    ///
    /// It has less results.
    pub fn then(mut self, judge: &Judge, names: &[&'static str]) -> Self {
        let info = judge.kernel.info;
        assert!(names.len() <= info.results.len(), "{}: {names:?} are too many names", info.name);
        self.links.push(Link::Kernel { judge: Box::new(judge.clone()), names: names.to_vec() });
        self
    }

    /// Points of the first kernel.
    pub fn points(&self, maker: Maker, seed: u64, count: usize) -> Points {
        self.first().space.inside(maker, seed, count)
    }

    /// Demands the claims at every point; how many points stayed inside all domains.
    ///
    /// # Errors
    ///
    /// The first point where one is broken, or too many points that lead out of a domain.
    ///
    /// # Panics
    ///
    /// A kernel's input has no name here, or a claim names what nothing here has.
    pub fn check(&self, points: &Points, claims: &[&dyn Claim]) -> Result<usize, String> {
        let mut judged = 0;
        for inputs in &points.list {
            let broken = match self.run(inputs) {
                Ok(run) => claims.iter().find_map(|claim| claim.broken(&run)).map(|what| (what, Some(run))),
                Err(Stop::Broken(what)) => Some((what, None)),
                Err(Stop::Left) => continue,
            };
            if let Some((what, run)) = broken {
                return Err(self.told(inputs, run.as_ref(), &points.origin, &what));
            }
            judged += 1;
        }
        let all = points.list.len();
        if (all - judged) as f64 > LEFT_SHARE * all as f64 {
            return Err(format!("{}: only {judged} of {all} points stay inside all domains", self.name()));
        }
        Ok(judged)
    }

    fn run(&self, inputs: &[f64]) -> Result<Run, Stop> {
        let mut values = self.first().space.domain().exactly(inputs);
        let mut errors = Vec::new();
        for (position, link) in self.links.iter().enumerate() {
            for Named { name, value, error } in link.values(&values)? {
                assert!(values.insert(name, value).is_none(), "{}: a second `{name}`", self.name());
                errors.extend(error.map(|error| (position, name, error)));
            }
        }
        let exact =
            self.links[1..].iter().flat_map(|link| link.exact(&values).expect("a reference has a value")).collect();
        let moved = |(position, name, error): (usize, _, Rational)| {
            [-error.clone(), error].map(|error| self.moved(&values, &exact, position, name, error))
        };
        let moved = errors.into_iter().map(moved).collect();
        Ok(Run { values, moved })
    }

    /// The values where the result `name` of a link is off by `error` and what follows from it follows; `exact` are those
    /// of the later results where it is not.
    fn moved(
        &self,
        values: &Names<'static>,
        exact: &Names,
        link: usize,
        name: &str,
        error: Rational,
    ) -> Option<Names<'static>> {
        let mut moved = values.clone();
        *moved.get_mut(name)? += error;
        for later in &self.links[link + 1..] {
            later.follow(values, exact, &mut moved)?;
        }
        Some(moved)
    }

    fn first(&self) -> &Judge {
        self.judges().next().expect("a chain begins with a kernel")
    }

    fn judges(&self) -> impl Iterator<Item = &Judge> {
        self.links.iter().filter_map(|link| match link {
            Link::Kernel { judge, .. } => Some(&**judge),
            Link::Definition { .. } => None,
        })
    }

    /// The names of its kernels, in order.
    pub fn kernels(&self) -> Vec<&'static str> {
        self.judges().map(|judge| judge.kernel.info.name).collect()
    }

    fn name(&self) -> String {
        self.kernels().join(", then ")
    }

    fn told(&self, inputs: &[f64], run: Option<&Run>, origin: &str, what: &str) -> String {
        let (info, given) = (self.first().kernel.info, self.first().oracle.names());
        let value = |(name, value): (&&str, &Rational)| format!("{name} = {:.20e}", Float::with_val(80, value));
        let values = run.iter().flat_map(|run| &run.values).filter(|(name, _)| !given.contains(name)).map(value);
        let values: Vec<String> = values.collect();
        let (inputs, replay, name) = (list(info, inputs), replay(info, inputs), self.name());
        format!("{name}: {what}\n{inputs}  with {}\n  from {origin}\n  {replay}", values.join(", "))
    }
}

impl Link {
    /// What it adds to these values.
    fn values(&self, values: &Names) -> Result<Vec<Named>, Stop> {
        match self {
            Link::Definition { name, value: definition } => {
                let value = value(definition, values).unwrap_or_else(|| panic!("definition of `{name}` has no value"));
                Ok(vec![Named { name, value, error: None }])
            }
            Link::Kernel { judge, names } => {
                let inputs: Vec<f64> = taken(judge, values).map(|(name, value)| double(name, value)).collect();
                if !judge.space.admits(&inputs) {
                    return Err(Stop::Left);
                }
                let results = names.iter().zip(judge.actual(&inputs)).enumerate();
                let result = |(position, (name, result)): (usize, (&&'static str, f64))| {
                    let not_finite = || Stop::Broken(format!("`{name}` is {result} at {inputs:?}"));
                    let value = Rational::from_f64(result).ok_or_else(not_finite)?;
                    Ok(Named { name, value, error: Some(error(judge, position, &inputs)) })
                };
                results.map(result).collect()
            }
        }
    }

    /// Takes its values along where `moved` differs from `values`.
    fn follow(&self, values: &Names, exact: &Names, moved: &mut Names) -> Option<()> {
        match self {
            Link::Definition { name, value: definition } => {
                let value = value(definition, moved)?;
                moved.insert(name, value);
            }
            Link::Kernel { judge, .. } if taken(judge, values).eq(taken(judge, moved)) => {}
            Link::Kernel { .. } => {
                for (name, value) in self.exact(moved)? {
                    *moved.get_mut(name)? += value - exact.get(name)?;
                }
            }
        }
        Some(())
    }

    /// The exact results of a kernel for these values; none where it has no value.
    fn exact(&self, values: &Names) -> Option<Vec<(&'static str, Rational)>> {
        let Link::Kernel { judge, names } = self else { return Some(Vec::new()) };
        let inputs: Vec<Float> = taken(judge, values).map(|(_, value)| Float::with_val(PRECISION, value)).collect();
        let exact = |result| judge.oracle.value_at(result, &inputs, PRECISION).ok()?.to_rational();
        names.iter().enumerate().map(|(result, name)| Some((*name, exact(result)?))).collect()
    }
}

impl Run {
    /// The first of these differences that is farther above zero than the bounds of the results allow, and by how much.
    ///
    /// What they allow is how far the difference moves when each result moves by its bound. Where it has no value then,
    /// everything is allowed.
    ///
    /// # Panics
    ///
    /// A difference has no value as the results are.
    pub fn exceeding(&self, differences: impl Fn(&Names) -> Vec<Option<Rational>>) -> Option<(usize, String)> {
        let residuals = differences(&self.values).into_iter().map(|value| value.expect("a claim has a value"));
        let residuals: Vec<Rational> = residuals.collect();
        if residuals.iter().all(|residual| *residual <= 0) {
            return None;
        }
        let mut allowed = vec![Some(Rational::new()); residuals.len()];
        for sides in &self.moved {
            let [down, up] = sides.each_ref().map(|names| names.as_ref().map(&differences));
            for (position, allowed) in allowed.iter_mut().enumerate() {
                let moved = |side: &Option<Vec<Option<Rational>>>| {
                    let value = side.as_ref()?[position].as_ref()?;
                    Some(Rational::from(value - &residuals[position]).abs())
                };
                *allowed = allowed.take().zip(moved(&down).zip(moved(&up))).map(|(sum, (down, up))| sum + down.max(up));
            }
        }
        let exceeds = |(residual, allowed): (&Rational, Option<Rational>)| {
            let allowed = allowed.filter(|allowed| residual > allowed)?;
            let [residual, allowed] = [residual, &allowed].map(|value| Float::with_val(60, value));
            Some(format!("is off by {residual:.6e}, allowed {allowed:.6e}"))
        };
        let mut found = residuals.iter().zip(allowed).map(exceeds).enumerate();
        found.find_map(|(position, what)| Some((position, what?)))
    }
}

/// The expression of a text.
///
/// # Panics
///
/// It is not Maxima text.
pub(super) fn parse(text: &str) -> Expr {
    parse_expression(text).unwrap_or_else(|errors| panic!("`{text}`: {errors}"))
}

/// The value of an expression: exact where it is rational.
pub(super) fn value(expression: &Expr, names: &Names) -> Option<Rational> {
    rational::value(expression, names).or_else(|| {
        let value = |(name, value): (&&str, &Rational)| ((*name).to_owned(), Float::with_val(PRECISION, value));
        let names: BTreeMap<String, Float> = names.iter().map(value).collect();
        evaluate(expression, &names, PRECISION).ok()?.to_rational()
    })
}

/// What a kernel takes of what there is.
fn taken<'a>(judge: &'a Judge, values: &'a Names) -> impl Iterator<Item = (&'static str, &'a Rational)> {
    let name = judge.kernel.info.name;
    let value =
        move |input: &&'static str| (*input, values.get(input).unwrap_or_else(|| panic!("{name}: no `{input}`")));
    judge.oracle.names().iter().map(value)
}

fn double(name: &str, value: &Rational) -> f64 {
    let double = value.to_f64();
    assert!(Rational::from_f64(double).as_ref() == Some(value), "`{name}` is no double: {value}");
    double
}

/// What the bound of a result is worth.
fn error(judge: &Judge, result: usize, inputs: &[f64]) -> Rational {
    let unit = ulp::unit(&judge.exact(result, inputs), F64).to_rational().expect("a unit is finite");
    unit * Rational::from_f64(judge.bound(result)).expect("a bound is finite")
}
