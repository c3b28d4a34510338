//! Random expressions for tests.

use closedform_maxima::ast::{Branch, LoopClause, LoopWord, Quoting};
use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;

fn leaf() -> BoxedStrategy<ExprKind> {
    prop_oneof![
        5 => select(vec!["a", "b", "x", "tOut", "%pi", "in", "delta_1", "odd name"])
            .prop_map(|name| ExprKind::Symbol(name.into())),
        3 => (0..100_u64).prop_map(|value| ExprKind::Integer(value.into())),
        1 => select(vec!["1.5", ".5", "1e-3", "2.5d0"]).prop_map(|text| ExprKind::Float(text.into())),
        1 => select(vec!["1.5b-3", "2b0"]).prop_map(|text| ExprKind::BigFloat(text.into())),
        1 => select(vec!["", "text", "a \"b\" \\c"]).prop_map(|text| ExprKind::String(text.into())),
    ]
    .boxed()
}

fn boxed(inner: &BoxedStrategy<Expr>) -> impl Strategy<Value = Box<Expr>> + use<> {
    inner.clone().prop_map(Box::new)
}

fn unary(inner: &BoxedStrategy<Expr>) -> BoxedStrategy<ExprKind> {
    use UnaryOperator as U;
    (select(vec![U::Plus, U::Minus, U::Not, U::Factorial, U::DoubleFactorial]), boxed(inner))
        .prop_map(|(operator, operand)| ExprKind::Unary { operator, operand })
        .boxed()
}

fn binary(inner: &BoxedStrategy<Expr>) -> BoxedStrategy<ExprKind> {
    (select(BinaryOperator::ALL.to_vec()), boxed(inner), boxed(inner))
        .prop_map(|(operator, left, right)| ExprKind::Binary { operator, left, right })
        .boxed()
}

/// What may be applied: everything but a number, and no string, which names an operator.
fn function(inner: &BoxedStrategy<Expr>) -> BoxedStrategy<Box<Expr>> {
    use ExprKind as E;
    let literal = |e: &Expr| matches!(e.kind, E::Integer(_) | E::Float(_) | E::BigFloat(_) | E::String(_));
    let name = Just(Expr::from(ExprKind::Symbol("f".into())));
    prop_oneof![3 => name, 1 => inner.clone().prop_filter("no literal", move |e| !literal(e))]
        .prop_map(Box::new)
        .boxed()
}

/// Quotes whose form is the one that parsing gives.
fn quote(inner: &BoxedStrategy<Expr>) -> BoxedStrategy<ExprKind> {
    let name = || Box::new(Expr::from(ExprKind::Symbol("q".into())));
    prop_oneof![
        select(vec![Quoting::Noun, Quoting::Verb])
            .prop_map(move |quoting| ExprKind::Quote { quoting, expression: name() }),
        (select(vec![Quoting::Expression, Quoting::Value]), boxed(inner))
            .prop_map(|(quoting, expression)| ExprKind::Quote { quoting, expression }),
    ]
    .boxed()
}

fn condition(inner: &BoxedStrategy<Expr>) -> BoxedStrategy<ExprKind> {
    let branch = (inner.clone(), inner.clone()).prop_map(|(condition, value)| Branch { condition, value });
    (vec(branch, 1..3), option::of(boxed(inner)))
        .prop_map(|(branches, otherwise)| ExprKind::If { branches, otherwise })
        .boxed()
}

fn repetition(inner: &BoxedStrategy<Expr>) -> BoxedStrategy<ExprKind> {
    use LoopWord as W;
    let words =
        select(vec![vec![W::For, W::From, W::Step, W::Thru], vec![W::For, W::In], vec![W::While, W::Unless], vec![]]);
    (words, vec(inner.clone(), 4), boxed(inner))
        .prop_map(|(words, values, body)| {
            let name = Expr::from(ExprKind::Symbol("i".into()));
            let value = |(word, value)| LoopClause { word, value: if word == W::For { name.clone() } else { value } };
            ExprKind::Loop { clauses: words.into_iter().zip(values).map(value).collect(), body }
        })
        .boxed()
}

/// Any expression that text can say.
pub fn expression() -> BoxedStrategy<Expr> {
    let level = |inner: BoxedStrategy<Expr>| {
        let elements = || vec(inner.clone(), 0..3);
        prop_oneof![
            12 => binary(&inner),
            4 => unary(&inner),
            2 => (function(&inner), elements()).prop_map(|(function, arguments)| ExprKind::Call { function, arguments }),
            1 => (function(&inner), vec(inner.clone(), 1..3)).prop_map(|(array, indices)| ExprKind::Subscript { array, indices }),
            1 => elements().prop_map(ExprKind::List),
            1 => elements().prop_map(ExprKind::Set),
            1 => vec(inner.clone(), 2..4).prop_map(ExprKind::Sequence),
            1 => quote(&inner),
            2 => condition(&inner),
            1 => repetition(&inner),
        ]
        .prop_map(Expr::from)
    };
    leaf().prop_map(Expr::from).prop_recursive(5, 40, 4, move |inner| level(inner.boxed())).boxed()
}
