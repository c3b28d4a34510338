//! Functions of lists and matrices.

use std::ops::Range;

use closedform_maxima::{Expr, ExprKind};

use super::arrays::{determinant, item, transposed};
use super::state::Refusal;
use super::tree::{self, call, list, rows, small};

/// Words for the first items.
const PLACES: [&str; 5] = ["first", "second", "third", "fourth", "fifth"];

/// What a function of lists gives, if it is one and its arguments are lists.
pub(super) fn of_lists(name: &str, arguments: &[Expr], span: &Range<usize>) -> Result<Option<Expr>, Refusal> {
    let listed = |items: Vec<Expr>| Expr::new(ExprKind::List(items), span.clone());
    Ok(match (name, arguments) {
        (place, [items]) if let Some(at) = PLACES.iter().position(|word| *word == place) => {
            list(items).and_then(|items| items.get(at).cloned())
        }
        ("last", [items]) => list(items).and_then(|items| items.last().cloned()),
        ("part" | "inpart", [array, indices @ ..]) if list(array).is_some() || rows(array).is_some() => {
            Some(item(array, indices, span)?)
        }
        ("length", [items]) => {
            let count = list(items).map(<[Expr]>::len).or_else(|| rows(items).map(|rows| rows.len()));
            count.and_then(|count| i64::try_from(count).ok()).map(|count| tree::number(count, span))
        }
        ("append", lists) => lists.iter().map(list).collect::<Option<Vec<_>>>().map(|items| listed(items.concat())),
        ("cons", [first, items]) => list(items).map(|items| listed([std::slice::from_ref(first), items].concat())),
        ("endcons", [last, items]) => list(items).map(|items| listed([items, std::slice::from_ref(last)].concat())),
        ("rest", [items]) => list(items).and_then(|items| Some(listed(without(items, 1)?))),
        ("rest", [items, count]) => {
            list(items).zip(small(count)).and_then(|(items, n)| Some(listed(without(items, n)?)))
        }
        ("reverse", [items]) => list(items).map(|items| listed(items.iter().rev().cloned().collect())),
        ("flatten", [items]) => list(items).map(|items| listed(flat(items))),
        ("transpose", [matrix]) => match list(matrix) {
            Some(row) => transposed(&[row], span),
            None => rows(matrix).and_then(|rows| transposed(&rows, span)),
        },
        ("row", [matrix, _]) if rows(matrix).is_some() => {
            Some(call("matrix", vec![item(matrix, &arguments[1..], span)?], span))
        }
        ("col", [matrix, at]) if let Some(rows) = rows(matrix) => {
            let in_column = |row: &&[Expr]| {
                let row = Expr::new(ExprKind::List(row.to_vec()), span.clone());
                item(&row, std::slice::from_ref(at), span).map(|item| listed(vec![item]))
            };
            Some(call("matrix", rows.iter().map(in_column).collect::<Result<_, _>>()?, span))
        }
        ("determinant", [matrix]) => {
            rows(matrix).and_then(|rows| determinant(&rows.into_iter().map(<[Expr]>::to_vec).collect::<Vec<_>>(), span))
        }
        _ => None,
    })
}

/// Items without the first ones, or without the last ones of a negative number; none if there are not as many.
fn without(items: &[Expr], count: i64) -> Option<Vec<Expr>> {
    let many = usize::try_from(count.unsigned_abs()).ok().filter(|many| *many <= items.len())?;
    Some(if count < 0 { items[..items.len() - many].to_vec() } else { items[many..].to_vec() })
}

/// All items, those of lists among them in their places.
fn flat(items: &[Expr]) -> Vec<Expr> {
    items.iter().flat_map(|item| list(item).map_or_else(|| vec![item.clone()], flat)).collect()
}
