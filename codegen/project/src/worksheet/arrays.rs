//! Lists, matrices and elements with subscripts.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::rc::Rc;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Statement, mentions, print};

use super::evaluate::{Evaluator, PARAMETER, because_of, elsewhere, key};
use super::state::{Binding, Evaluated, Refusal};
use super::tree::{self, binary, call, list, rows, small, symbol};

/// Every name of a worksheet.
pub(super) fn names_in(text: &str, statements: &[Statement]) -> BTreeSet<String> {
    let mut names: BTreeSet<String> = mentions(text).into_iter().map(|mention| mention.name).collect();
    names.extend(statements.iter().flat_map(|statement| tree::names(&statement.expression)));
    names
}

/// What elements with subscripts are called where they are inputs.
#[derive(Debug, Clone, Default)]
pub(super) struct Names {
    /// Every name of the worksheet.
    taken: BTreeSet<String>,
    given: BTreeMap<String, String>,
}

impl Names {
    /// For a worksheet that has these names.
    pub(super) fn beside(taken: BTreeSet<String>) -> Self {
        Self { taken, given: BTreeMap::new() }
    }

    /// `x_1` for `x[1]`, and a longer one if that is another name of the worksheet.
    pub(super) fn of(&mut self, array: &str, indices: &[Expr]) -> String {
        let element = key(array, indices);
        if let Some(name) = self.given.get(&element) {
            return name.clone();
        }
        let letters = |c: char| if c.is_alphanumeric() { c } else { '_' };
        let indices: Vec<String> = indices.iter().map(|index| print(index).chars().map(letters).collect()).collect();
        let mut name = format!("{array}_{}", indices.join("_"));
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        self.given.insert(element, name.clone());
        name
    }
}

impl Evaluator {
    /// `a[i]`: an item, an element that has a value, or a name.
    pub(super) fn subscript(&mut self, whole: &Expr, array: &Expr, indices: &[Expr]) -> Evaluated {
        let indices: Vec<Expr> = indices.iter().map(|index| self.value(index)).collect::<Evaluated<_>>()?;
        let span = &whole.span;
        let Some(name) = array.as_symbol() else {
            let array = self.value(array)?;
            return match array.as_symbol().and_then(|marked| marked.strip_prefix(PARAMETER)) {
                Some(parameter) => self.item_of(parameter, &indices, span),
                None => item(&array, &indices, span).map_err(Into::into),
            };
        };
        let mut name = name.to_owned();
        match self.state.variables.get(&name).cloned() {
            Some(Binding::Unknown(because)) => return Err(elsewhere(&because, span).into()),
            Some(Binding::Value(array)) => match array.as_symbol() {
                Some(marked) if let Some(parameter) = marked.strip_prefix(PARAMETER) => {
                    return self.item_of(parameter, &indices, span);
                }
                Some(other) => other.clone_into(&mut name),
                None => return item(&array, &indices, span).map_err(Into::into),
            },
            None => {}
        }
        let name = name.as_str();
        match self.state.variables.get(&key(name, &indices)).cloned() {
            Some(Binding::Value(value)) => Ok((*value).clone()),
            Some(Binding::Unknown(because)) => Err(elsewhere(&because, span).into()),
            None if let Some(function) = self.state.arrays.get(name).cloned() => {
                let value = self.apply(name, &function, indices.clone(), span)?;
                // Maxima keeps what it has computed once
                if self.is_decided() {
                    self.state.variables.insert(key(name, &indices), Binding::Value(Rc::new(value.clone())));
                }
                Ok(value)
            }
            None if self.state.functions.contains_key(name) => {
                let because = self.state.functions[name].parameters.clone().err();
                let what = "a function is called with its arguments in brackets";
                let because = because.unwrap_or_else(|| Refusal::new(what, "write parentheses", span));
                Err(elsewhere(&because, span).into())
            }
            None => match &self.state.fog {
                Some(because) => Err(elsewhere(because, span).into()),
                None => Ok(symbol(&self.subscripts.of(name, &indices), span)),
            },
        }
    }

    /// `a[i]: value`
    pub(super) fn assign_element(
        &mut self,
        array: &Expr,
        indices: &[Expr],
        value: &Expr,
        span: &Range<usize>,
    ) -> Evaluated<()> {
        let Some(name) = array.as_symbol() else { return Err(self.sweep("assigns to what cannot be known", span)) };
        let indices: Vec<Expr> = indices.iter().map(|index| self.value(index)).collect::<Evaluated<_>>()?;
        let held = match self.state.variables.get(name) {
            Some(Binding::Value(held)) if list(held).is_some() || rows(held).is_some() => held.clone(),
            Some(Binding::Value(held)) if held.as_symbol().is_some_and(|name| name.starts_with(PARAMETER)) => {
                let what = format!("the parameter `{name}` is a list that the function changes");
                return Err(Refusal::new(what, "give its items names of their own in the function", span).into());
            }
            _ => {
                let value = Binding::Value(Rc::new(value.clone()));
                self.state.variables.insert(key(name, &indices), value);
                return Ok(());
            }
        };
        // other names may stand for the same list, and then see the change
        let what = "it is a list of which an item was changed";
        let because = Refusal::new(what, "write the list as it is to be", span);
        let same = |binding: &Binding| matches!(binding, Binding::Value(other) if **other == *held);
        let names: Vec<String> =
            self.state.variables.iter().filter(|(_, binding)| same(binding)).map(|(name, _)| name.clone()).collect();
        match (names.as_slice(), changed(&held, &indices, value)) {
            ([_], Some(changed)) => _ = self.state.variables.insert(name.to_owned(), Binding::Value(Rc::new(changed))),
            _ => names.iter().for_each(|name| self.state.forget_value(name, &because)),
        }
        Ok(())
    }
}

/// A list or matrix with another item.
fn changed(array: &Expr, indices: &[Expr], value: &Expr) -> Option<Expr> {
    let position = |index: &Expr| usize::try_from(small(index)?).ok()?.checked_sub(1);
    let mut array = array.clone();
    let slot = match (&mut array.kind, indices) {
        (ExprKind::List(items), [index]) => items.get_mut(position(index)?)?,
        (ExprKind::Call { arguments, .. }, [row, column]) => match &mut arguments.get_mut(position(row)?)?.kind {
            ExprKind::List(items) => items.get_mut(position(column)?)?,
            _ => return None,
        },
        _ => return None,
    };
    *slot = value.clone();
    Some(array)
}

/// An item of a list or matrix.
pub(super) fn item(array: &Expr, indices: &[Expr], span: &Range<usize>) -> Result<Expr, Refusal> {
    let position = |index: &Expr| usize::try_from(small(index)?).ok()?.checked_sub(1);
    let found = match (list(array), rows(array), indices) {
        (Some(items), _, [index]) => position(index).and_then(|at| items.get(at)).cloned(),
        (Some(items), _, [index, rest @ ..]) if !rest.is_empty() => {
            return match position(index).and_then(|at| items.get(at)) {
                Some(inner) => item(inner, rest, span),
                None => Err(no_item(array, span)),
            };
        }
        (_, Some(rows), [row]) => {
            position(row).and_then(|at| rows.get(at)).map(|row| Expr::new(ExprKind::List(row.to_vec()), span.clone()))
        }
        (_, Some(rows), [row, column]) => {
            position(row).and_then(|at| rows.get(at)).and_then(|row| row.get(position(column)?)).cloned()
        }
        _ => None,
    };
    found.ok_or_else(|| no_item(array, span))
}

fn no_item(array: &Expr, span: &Range<usize>) -> Refusal {
    let what = "there is no item at this subscript, or it is not a number";
    because_of(&[array], Refusal::new(what, "write the item itself", span))
}

/// Something done to every item of a list or matrix, or side of an equation; or to the value itself.
pub(super) fn each(value: &Expr, change: &mut dyn FnMut(&Expr) -> Expr) -> Expr {
    match &value.kind {
        ExprKind::List(_) => tree_map(value, change),
        ExprKind::Call { .. } if rows(value).is_some() => tree_map(value, change),
        ExprKind::Binary { operator: BinaryOperator::Compare(_), .. } => tree_map(value, change),
        _ => change(value),
    }
}

fn tree_map(value: &Expr, change: &mut dyn FnMut(&Expr) -> Expr) -> Expr {
    let Ok(changed) = tree::map::<std::convert::Infallible>(value, &mut |item| Ok(each(item, change)));
    changed
}

/// Two values joined by an operator, as Maxima does with lists, matrices and equations.
pub(super) fn joined(operator: BinaryOperator, left: Expr, right: Expr, span: &Range<usize>) -> Result<Expr, Refusal> {
    use BinaryOperator::{Add, Divide, Dot, Multiply, Power, Subtract};
    if !matches!(operator, Add | Subtract | Multiply | Divide | Power | Dot) {
        return Ok(binary(operator, left, right, span));
    }
    let (of_left, of_right) = (shape(&left), shape(&right));
    match (operator, of_left, of_right) {
        (Dot, Shape::Scalar, Shape::Scalar) => {
            let what = "the noncommutative product `.` of what may be no numbers";
            Err(Refusal::new(what, "write `*` for a product of numbers", span))
        }
        (Dot, Shape::Scalar, _) | (Dot, _, Shape::Scalar) => joined(Multiply, left, right, span),
        (Dot, ..) => product(&left, &right, span),
        (_, Shape::Scalar, Shape::Scalar) => Ok(binary(operator, left, right, span)),
        (Power, Shape::Matrix | Shape::List, Shape::Scalar)
        | (Add | Subtract | Multiply | Divide, Shape::Matrix | Shape::List, Shape::Scalar) => {
            Ok(each(&left, &mut |item| binary(operator, item.clone(), right.clone(), span)))
        }
        (Add | Subtract | Multiply | Divide, Shape::Scalar, Shape::Matrix | Shape::List) => {
            Ok(each(&right, &mut |item| binary(operator, left.clone(), item.clone(), span)))
        }
        (Add | Subtract | Multiply | Divide | Power, Shape::Equation, Shape::Scalar) => {
            Ok(each(&left, &mut |side| binary(operator, side.clone(), right.clone(), span)))
        }
        (Add | Subtract | Multiply | Divide, Shape::Scalar, Shape::Equation) => {
            Ok(each(&right, &mut |side| binary(operator, left.clone(), side.clone(), span)))
        }
        (Add | Subtract | Multiply | Divide, one, other) if one == other => by_item(operator, &left, &right, span),
        _ => Err(shapes(span)),
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    Scalar,
    List,
    Matrix,
    Equation,
}

fn shape(value: &Expr) -> Shape {
    match &value.kind {
        ExprKind::List(_) => Shape::List,
        ExprKind::Call { .. } if rows(value).is_some() => Shape::Matrix,
        ExprKind::Binary { operator: BinaryOperator::Compare(_), .. } => Shape::Equation,
        _ => Shape::Scalar,
    }
}

fn shapes(span: &Range<usize>) -> Refusal {
    Refusal::new("lists or matrices of other shapes are joined", "write them out item by item", span)
}

fn by_item(operator: BinaryOperator, left: &Expr, right: &Expr, span: &Range<usize>) -> Result<Expr, Refusal> {
    let (of_left, of_right) = (tree::parts(left), tree::parts(right));
    let own = usize::from(shape(left) == Shape::Matrix); // the name of the matrix comes first
    if of_left.len() != of_right.len() {
        return Err(shapes(span));
    }
    let pairs = of_left.into_iter().zip(of_right).skip(own);
    let mut items =
        pairs.map(|(one, other)| joined(operator, one.clone(), other.clone(), span)).collect::<Result<Vec<_>, _>>()?;
    Ok(match (&left.kind, shape(left)) {
        (_, Shape::Matrix) => call("matrix", items, span),
        (ExprKind::Binary { operator, .. }, _) if items.len() == 2 => {
            let right = items.remove(1);
            binary(*operator, items.remove(0), right, span)
        }
        _ => Expr::new(ExprKind::List(items), span.clone()),
    })
}

/// `a . b` of matrices and lists.
fn product(left: &Expr, right: &Expr, span: &Range<usize>) -> Result<Expr, Refusal> {
    let dot = |one: &[Expr], other: &[Expr]| {
        let terms = one
            .iter()
            .zip(other)
            .map(|(one, other)| binary(BinaryOperator::Multiply, one.clone(), other.clone(), span));
        terms.reduce(|sum, term| binary(BinaryOperator::Add, sum, term, span)).ok_or_else(|| shapes(span))
    };
    if let (Some(one), Some(other)) = (list(left), list(right)) {
        return if one.len() == other.len() { dot(one, other) } else { Err(shapes(span)) };
    }
    let as_column = |items: &[Expr]| items.iter().map(|item| vec![item.clone()]).collect::<Vec<_>>();
    let owned = |value: &Expr| rows(value).map(|rows| rows.into_iter().map(<[Expr]>::to_vec).collect::<Vec<_>>());
    let as_row = |items: &[Expr]| vec![items.to_vec()];
    let left_rows = owned(left).or_else(|| list(left).map(as_row)).ok_or_else(|| shapes(span))?;
    // a list is a column, unless only a row fits
    let is_column = left_rows.iter().all(|row| row.len() == 1);
    let fitting = |items: &[Expr]| if is_column { as_row(items) } else { as_column(items) };
    let right_rows = owned(right).or_else(|| list(right).map(fitting)).ok_or_else(|| shapes(span))?;
    let columns = right_rows.first().map_or(0, Vec::len);
    if left_rows.iter().any(|row| row.len() != right_rows.len()) || right_rows.iter().any(|row| row.len() != columns) {
        return Err(shapes(span));
    }
    let column = |at: usize| right_rows.iter().map(|row| row[at].clone()).collect::<Vec<_>>();
    if let ([row], 1) = (left_rows.as_slice(), columns) {
        return dot(row, &column(0)); // one number is no matrix
    }
    let mut made = Vec::new();
    for row in &left_rows {
        let items = (0..columns).map(|at| dot(row, &column(at))).collect::<Result<Vec<_>, _>>()?;
        made.push(Expr::new(ExprKind::List(items), span.clone()));
    }
    Ok(call("matrix", made, span))
}

pub(super) fn transposed(rows: &[&[Expr]], span: &Range<usize>) -> Option<Expr> {
    let columns = rows.first()?.len();
    let column = |at: usize| rows.iter().map(|row| row.get(at).cloned()).collect::<Option<Vec<_>>>();
    let made = (0..columns).map(|at| Some(Expr::new(ExprKind::List(column(at)?), span.clone())));
    Some(call("matrix", made.collect::<Option<Vec<_>>>()?, span))
}

/// By the first row, as it is written out by hand.
pub(super) fn determinant(rows: &[Vec<Expr>], span: &Range<usize>) -> Option<Expr> {
    let (first, below) = rows.split_first()?;
    if first.len() != rows.len() || rows.len() > 4 {
        return None;
    }
    if below.is_empty() {
        return first.first().cloned();
    }
    let mut sum: Option<Expr> = None;
    for (at, item) in first.iter().enumerate() {
        let without = |row: &Vec<Expr>| {
            row.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, item)| item.clone()).collect()
        };
        let minor: Vec<Vec<Expr>> = below.iter().map(without).collect();
        let term = binary(BinaryOperator::Multiply, item.clone(), determinant(&minor, span)?, span);
        let operator = if at % 2 == 0 { BinaryOperator::Add } else { BinaryOperator::Subtract };
        sum = Some(match sum {
            None => term,
            Some(sum) => binary(operator, sum, term, span),
        });
    }
    sum
}
